// Mesh files, written here byte by byte: what is read, and what is refused.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "delos/geometry/defects.h"
#include "delos/geometry/mesh.h"
#include "delos/geometry/primitives.h"
#include "support/folder.h"
#include "support/gltf.h"

namespace delos::test {
namespace {

static_assert(std::endian::native == std::endian::little, "as the binary files below");

class MeshFile : public testing::Test {
 protected:
  std::filesystem::path write(const std::string& name, const std::string& bytes) {
    return folder_.write(name, bytes);
  }

  /// What is said of a file, without its folder.
  std::string refusal(const std::string& name, const std::string& bytes) {
    try {
      (void)read_mesh(write(name, bytes));
    } catch (const std::runtime_error& e) {
      return std::string(e.what()).substr(folder_.path().string().size() + 1);
    }
    return "accepted";
  }

  Folder folder_;
};

const TriangleMesh kBox = make_box({0, 0, 0}, {1, 2, 3});

template <class T>
std::string bytes_of(T value) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  return bytes;
}

std::string off() {
  std::ostringstream out;
  out << "OFF\n# a cube\n8 12 0\n";
  for (const auto& p : kBox.vertices) out << p.transpose() << '\n';
  for (const auto& [a, b, c] : kBox.triangles) {
    out << "3 " << a << ' ' << b << ' ' << c << '\n';
  }
  return out.str();
}

std::string obj() {
  std::ostringstream out;
  out << "# a cube\no cube\nvn 0 0 1\nvt 0 0\n";
  for (const auto& p : kBox.vertices) out << "v " << p.transpose() << '\n';
  for (std::size_t t = 0; t < kBox.triangles.size(); ++t) {
    const auto& [a, b, c] = kBox.triangles[t];
    if (t % 2 == 0) {
      out << "f " << a + 1 << "/1/1 " << b + 1 << "//1 " << c + 1 << '\n';
    } else {  // counted from the end
      out << "f " << int(a) - 8 << ' ' << int(b) - 8 << ' ' << int(c) - 8 << '\n';
    }
  }
  return out.str();
}

std::string ply_header(const std::string& format) {
  return "ply\nformat " + format +
         " 1.0\ncomment a cube\nelement vertex 8\nproperty float x\nproperty float y\n"
         "property float z\nelement face 12\nproperty list uchar int vertex_indices\n"
         "end_header\n";
}

std::string ply() {
  std::ostringstream out;
  out << ply_header("ascii");
  for (const auto& p : kBox.vertices) out << p.transpose() << '\n';
  for (const auto& [a, b, c] : kBox.triangles) {
    out << "3 " << a << ' ' << b << ' ' << c << '\n';
  }
  return out.str();
}

std::string with_replaced(std::string text, const std::string& from,
                          const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

std::string binary_ply() {
  std::string out = ply_header("binary_little_endian");
  for (const auto& p : kBox.vertices) {
    for (const double x : p) out += bytes_of(static_cast<float>(x));
  }
  for (const auto& triangle : kBox.triangles) {
    out += bytes_of(std::uint8_t{3});
    for (const std::uint32_t corner : triangle) out += bytes_of(corner);
  }
  return out;
}

std::string stl() {
  std::ostringstream out;
  out << "solid cube\n";
  for (const auto& triangle : kBox.triangles) {
    out << "facet normal 0 0 0\n outer loop\n";
    for (const std::uint32_t corner : triangle) {
      out << "  vertex " << kBox.vertices[corner].transpose() << '\n';
    }
    out << " endloop\nendfacet\n";
  }
  out << "endsolid cube\n";
  return out.str();
}

std::string binary_stl(const TriangleMesh& mesh = kBox) {
  std::string out(80, ' ');
  out += bytes_of(static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const auto& triangle : mesh.triangles) {
    for (int i = 0; i < 3; ++i) out += bytes_of(0.0f);
    for (const std::uint32_t corner : triangle) {
      for (const double x : mesh.vertices[corner])
        out += bytes_of(static_cast<float>(x));
    }
    out += std::string(2, '\0');
  }
  return out;
}

TEST_F(MeshFile, OfEveryFormatGivesTheCube) {
  const std::pair<const char*, std::string> files[] = {
      {"a.off", off()},           {"a.obj", obj()},
      {"a.ply", ply()},           {"b.ply", binary_ply()},
      {"a.stl", stl()},           {"b.STL", binary_stl()},
      {"a.glb", test::glb(kBox)}, {"a.gltf", test::gltf(kBox)},
  };
  for (const auto& [name, bytes] : files) {
    const TriangleMesh mesh = read_mesh(write(name, bytes));
    ASSERT_EQ(mesh.vertices.size(), 8u) << name;
    ASSERT_EQ(mesh.triangles.size(), 12u) << name;
    for (std::size_t t = 0; t < 12; ++t) {
      for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(mesh.vertices[mesh.triangles[t][i]],
                  kBox.vertices[kBox.triangles[t][i]])
            << name << ", triangle " << t;
      }
    }
    EXPECT_TRUE(find_defects(mesh).closed) << name;
  }
}

// A node turned by a right angle about x (y to z), twice as large and 5 m up in its own
// y: what stands at (x, y, z), y up, comes to (2x, 5 − 2z, 2y), which is (2x, −2y, 5 −
// 2z) with z up.
TEST_F(MeshFile, OfGltfStandsWhereItsNodesSay) {
  const TriangleMesh mesh = read_mesh(write(
      "a.glb",
      test::glb(kBox, R"("translation":[0,5,0],"scale":[2,2,2],)"
                      R"("rotation":[0.7071067811865476,0,0,0.7071067811865476])")));
  ASSERT_EQ(mesh.triangles.size(), 12u);
  for (std::size_t t = 0; t < 12; ++t)
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d& p = kBox.vertices[kBox.triangles[t][i]];
      const Eigen::Vector3d up(p.x(), p.z(), -p.y());  // of the file
      EXPECT_LT((mesh.vertices[mesh.triangles[t][i]] -
                 Eigen::Vector3d(2 * up.x(), -2 * up.y(), 5 - 2 * up.z()))
                    .norm(),
                1e-6);
    }
  // By a matrix that mirrors, it isn't inside out.
  const TriangleMesh mirrored = read_mesh(write(
      "b.glb", test::glb(kBox, R"("matrix":[-1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1])")));
  EXPECT_TRUE(find_defects(mirrored).closed);
  EXPECT_FALSE(find_defects(mirrored).inverted);
}

TEST_F(MeshFile, OfGltfSaysWhatIsNotRead) {
  const auto says = [&](const std::string& text) { return refusal("a.gltf", text); };
  EXPECT_NE(says(test::gltf_json(kBox, R"("uri":"a.bin")")).find("write it as one"),
            std::string::npos);
  EXPECT_NE(says(R"({"scenes":[{"nodes":[0]}],"nodes":[{"children":[0]}]})")
                .find("in each other"),
            std::string::npos);
  EXPECT_NE(says(R"({"scenes":[{"nodes":[7]}],"nodes":[]})").find("doesn't have"),
            std::string::npos);
  EXPECT_NE(says("{").find("can't be understood"), std::string::npos);
}

TEST_F(MeshFile, FansPolygons) {
  const TriangleMesh mesh = read_mesh(
      write("a.off", "OFF\n5 1 0\n0 0 0\n2 0 0\n3 1 0\n2 2 0\n0 2 0\n5 0 1 2 3 4\n"));
  const std::vector<std::array<std::uint32_t, 3>> fan{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}};
  EXPECT_EQ(mesh.triangles, fan);
}

TEST_F(MeshFile, TellsHowFarItIs) {
  const auto file = write("a.stl", binary_stl(make_sphere(1, 6)));  // 4 MB
  std::vector<double> told;
  (void)read_mesh(file, [&](double fraction) { told.push_back(fraction); });
  ASSERT_GE(told.size(), 4u);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_GE(told.front(), 0);
  EXPECT_EQ(told.back(), 1);
}

TEST_F(MeshFile, IsRefusedWithTheCause) {
  EXPECT_EQ(refusal("a.dae", "{}"),
            "a.dae: the suffix '.dae' isn't one of .off, .obj, .ply, .stl, .glb and "
            ".gltf");
  for (const char* name : {"a.off", "a.obj", "a.ply", "a.stl"}) {
    EXPECT_EQ(refusal(name, ""), name + std::string(": is empty or can't be read"));
    EXPECT_NE(refusal(name, "hello world\n"), "accepted");
  }
  EXPECT_EQ(refusal("a.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n"),
            "a.off: has no triangle");
  EXPECT_EQ(refusal("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n"),
            "a.off: can't be understood, or ends too early");
  EXPECT_EQ(refusal("a.ply", binary_ply().substr(0, 300)),
            "a.ply: can't be understood, or ends too early");
  EXPECT_EQ(refusal("a.stl", binary_stl().substr(0, 300)),
            "a.stl: can't be understood, or ends too early");
  try {
    (void)read_mesh(folder_ / "none.off");
    FAIL();
  } catch (const std::runtime_error& e) {
    EXPECT_EQ(e.what(), (folder_ / "none.off").string() + ": no such file");
  }
}

TEST_F(MeshFile, WithAVertexThatIsNotFiniteIsRefused) {
  EXPECT_EQ(refusal("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 nan 0\n3 0 1 2\n"),
            "a.off: line 5: 'nan' isn't a finite number");
  EXPECT_EQ(refusal("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1e999 0\nf 1 2 3\n"),
            "a.obj: line 3: '1e999' isn't a finite number");
  std::string text = stl();
  text.replace(text.find("vertex 1"), 8, "vertex -inf");
  EXPECT_EQ(refusal("a.stl", text).substr(0, 12), "a.stl: line ");

  const std::string nan = bytes_of(NAN);
  std::string bytes = binary_ply();
  bytes.replace(ply_header("binary_little_endian").size() + 12 * 3 + 4, 4, nan);
  EXPECT_EQ(refusal("a.ply", bytes), "a.ply: vertex 3 (counted from 0) isn't finite");
  bytes = binary_stl();
  bytes.replace(84 + 50 * 7 + 12 + 12 * 2, 4, nan);
  EXPECT_EQ(refusal("a.stl", bytes),
            "a.stl: vertex 2 of triangle 7 (counted from 0) isn't finite");
}

TEST_F(MeshFile, ThatNamesAMissingVertexIsRefused) {
  EXPECT_EQ(refusal("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"),
            "a.off: a face names a vertex that doesn't exist");
  for (const char* face : {"f 1 2 4", "f 1 2 0", "f 1 2 -4"}) {
    EXPECT_EQ(
        refusal("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n" + std::string(face) + "\n"),
        "a.obj: face 0 (counted from 0) names a vertex that doesn't exist");
  }
  std::string text = ply();
  text.replace(text.rfind("3 "), 7, "3 4 7 8");
  EXPECT_EQ(refusal("a.ply", text),
            "a.ply: face 11 (counted from 0) names a vertex that doesn't exist");
}

TEST_F(MeshFile, ThatIsNotThereMayBeMeantOtherwise) {
  write("quads.obj", obj());
  const auto said = [&](const std::string& name) -> std::string {
    try {
      (void)read_mesh(folder_ / name);
    } catch (const std::runtime_error& e) {
      return std::string(e.what()).substr((folder_ / name).string().size());
    }
    return "";
  };
  EXPECT_EQ(said("Quads.obj"), ": no such file; did you mean 'quads.obj'?");
  EXPECT_EQ(said("meshes\\quads.obj"), ": no such file; folders are separated by '/'");
  EXPECT_EQ(said("no/quads.obj"),
            ": no such file; there is no folder " + (folder_ / "no").string());
}

// PLY headers in an order that they may not have, and without what makes a vertex.
TEST_F(MeshFile, PlyWithADamagedHeaderIsRefused) {
  const char* reason = "a.ply: can't be understood, or ends too early";
  EXPECT_EQ(refusal("a.ply", "ply\nformat ascii 1.0\nproperty float x\n"), reason);
  EXPECT_EQ(
      refusal("a.ply", "ply\nelement vertex 1\nproperty float x\nend_header\n1\n"),
      reason);
  EXPECT_EQ(
      refusal("a.ply", with_replaced(ply(), "property float z", "property half z")),
      reason);
  EXPECT_EQ(
      refusal("a.ply", with_replaced(ply(), "property float z", "property float w")),
      "a.ply: its vertices don't have x, y and z");
  const char* claims = "a.ply: announces more than it holds";
  EXPECT_EQ(refusal("a.ply",
                    with_replaced(ply(), "element face 12", "element face 4000000000")),
            claims);
  // 200 bytes whose one face has 4·10⁹ corners.
  EXPECT_EQ(refusal("a.ply",
                    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                    "property float y\nproperty float z\nelement face 1\n"
                    "property list uint int vertex_indices\nend_header\n"
                    "0 0 0\n1 0 0\n0 1 0\n4000000000 0 1 2\n"),
            claims);
}

// Big-endian, with properties and elements that aren't a surface's.
TEST_F(MeshFile, PlyIsReadAroundWhatIsNoSurface) {
  const auto big = [](auto value) {
    std::string bytes = bytes_of(value);
    std::reverse(bytes.begin(), bytes.end());
    return bytes;
  };
  std::string text =
      "ply\r\nformat binary_big_endian 1.0\r\nobj_info made by hand\r\n"
      "element camera 1\r\nproperty list uchar short f\r\n"
      "element vertex 3\r\nproperty uchar red\r\nproperty double z\r\n"
      "property float x\r\nproperty float y\r\n"
      "element face 1\r\nproperty ushort flags\r\n"
      "property list uchar uint vertex_index\r\nend_header\r\n";
  text += std::string("\2") + big(std::int16_t{7}) + big(std::int16_t{8});
  for (int v = 0; v < 3; ++v)
    text += "\xff" + big(10.0 + v) + big(1.0f * v) + big(-2.0f * v);
  text += big(std::uint16_t{9}) + std::string("\3");
  for (const std::uint32_t corner : {0u, 2u, 1u}) text += big(corner);
  const TriangleMesh mesh = read_mesh(write("a.ply", text));
  ASSERT_EQ(mesh.vertices.size(), 3u);
  EXPECT_EQ(mesh.vertices[2], Eigen::Vector3d(2, -4, 12));
  ASSERT_EQ(mesh.triangles.size(), 1u);
  EXPECT_EQ(mesh.triangles[0], (std::array<std::uint32_t, 3>{0, 2, 1}));
}

TEST_F(MeshFile, OffWithMoreOfAVertexIsReadOrRefused) {
  const std::string faces = "3 0 1 2 255 0 0\n";
  const TriangleMesh mesh =
      read_mesh(write("a.off",
                      "# c\nSTCNOFF # h\n3 1 0\n0 0 0 0 0 1 255 0 0 0.5 0.5\n"
                      "1 0 0 0 0 1 255 0 0 0.5 0.5\n0 2 0 0 0 1 255 0 0 0.5 0.5\n" +
                          faces));
  ASSERT_EQ(mesh.vertices.size(), 3u);
  EXPECT_EQ(mesh.vertices[2], Eigen::Vector3d(0, 2, 0));
  EXPECT_EQ(refusal("b.off", "STCNOFF\n1 0 0\n0 0 0\n"),
            "b.off: can't be understood, or ends too early");
  EXPECT_EQ(refusal("c.off", "COFF\n3 1 0\n0 0\n1 0\n"),
            "c.off: can't be understood, or ends too early");
  // CGAL takes it for STCNOFF.
  EXPECT_EQ(refusal("d.off", "STCNOFFx\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"),
            "d.off: doesn't begin with a header of OFF");
}

TEST_F(MeshFile, ThatAnnouncesTooMuchIsRefused) {
  const char* reason = "a.off: announces more than it holds";
  EXPECT_EQ(refusal("a.off", "OFF\n400000000 1 0\n0 0 0\n"), reason);
  EXPECT_EQ(refusal("a.off", "OFF\n1 400000000 0\n0 0 0\n"), reason);
  EXPECT_EQ(refusal("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n999999999999 0 1 2\n"),
            reason);
}

}  // namespace
}  // namespace delos::test
