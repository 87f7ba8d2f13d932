// Damaged meshes: a mesh that is sound, or one sentence that names the file.
#include "delos/geometry/mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <sstream>
#include <stdexcept>

#include "delos/geometry/defects.h"
#include "delos/geometry/primitives.h"
#include "fuzz/damage.h"
#include "support/gltf.h"

namespace delos::fuzz {
namespace {

const TriangleMesh kBox = make_box({0, 0, 0}, {1, 2, 3});

std::string bytes_of(const auto& value) {
  return std::string(reinterpret_cast<const char*>(&value), sizeof value);
}

std::string vertices_and_faces(const std::string& after_vertex) {
  std::ostringstream out;
  for (const auto& p : kBox.vertices) out << p.transpose() << after_vertex << '\n';
  for (const auto& [a, b, c] : kBox.triangles)
    out << "3 " << a << ' ' << b << ' ' << c << '\n';
  return out.str();
}

std::string ply_of(const std::string& format, const std::string& body) {
  return "ply\nformat " + format +
         " 1.0\ncomment x\nelement vertex 8\nproperty float x\nproperty float y\n"
         "property float z\nelement face 12\nproperty list uchar int vertex_indices\n"
         "end_header\n" +
         body;
}

std::string binary_body() {
  std::string out;
  for (const auto& p : kBox.vertices)
    for (const double x : p) out += bytes_of(static_cast<float>(x));
  for (const auto& triangle : kBox.triangles) {
    out += '\3';
    for (const std::uint32_t corner : triangle) out += bytes_of(corner);
  }
  return out;
}

std::string text_stl() {
  std::ostringstream out;
  out << "solid box\n";
  for (const auto& triangle : kBox.triangles) {
    out << "facet normal 0 0 0\nouter loop\n";
    for (const std::uint32_t corner : triangle)
      out << "vertex " << kBox.vertices[corner].transpose() << '\n';
    out << "endloop\nendfacet\n";
  }
  return out.str() + "endsolid box\n";
}

std::string binary_stl() {
  std::string out(80, ' ');
  out += bytes_of(static_cast<std::uint32_t>(kBox.triangles.size()));
  for (const auto& triangle : kBox.triangles) {
    out += std::string(12, '\0');
    for (const std::uint32_t corner : triangle)
      for (const double x : kBox.vertices[corner])
        out += bytes_of(static_cast<float>(x));
    out += std::string(2, '\0');
  }
  return out;
}

std::string obj() {
  std::ostringstream out;
  for (const auto& p : kBox.vertices) out << "v " << p.transpose() << '\n';
  out << "vn 0 0 1\nvt 0 0\n";
  for (const auto& [a, b, c] : kBox.triangles)
    out << "f " << a + 1 << "/1 " << b + 1 << "//1 " << c + 1 << '\n';
  return out.str();
}

std::string unsound(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) return "a mesh without triangles";
  for (const auto& p : mesh.vertices)
    if (!p.allFinite()) return "a vertex that isn't finite";
  for (const auto& triangle : mesh.triangles)
    for (const std::uint32_t corner : triangle)
      if (corner >= mesh.vertices.size()) return "a corner that isn't there";
  (void)find_defects(mesh);
  return "";
}

void damage_meshes(const std::string& suffix, const std::vector<std::string>& seeds,
                   const std::vector<std::string>& words) {
  const ScratchFile file("." + suffix);
  damage(suffix, seeds, words, [&](const std::string& bytes) -> std::string {
    file.write(bytes);
    try {
      return unsound(read_mesh(file.path()));
    } catch (const std::runtime_error& refusal) {
      const std::string why = refusal.what();
      return why.starts_with(file.path() + ": ") ? "" : "a refusal: " + why;
    } catch (const std::exception& slip) {
      return std::string("an exception of another kind: ") + slip.what();
    }
  });
}

TEST(FuzzMesh, Off) {
  damage_meshes("off",
                {"OFF\n# a box\n8 12 0\n" + vertices_and_faces(""),
                 "COFF\n8 12 0\n" + vertices_and_faces(" 255 0 0 255"),
                 "STCNOFF\n8 12 0\n" + vertices_and_faces(" 0 0 1 255 0 0 255 0 0"),
                 "OFF 4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3 255 0 0\n"},
                {"OFF", "COFF", "NOFF", "STCNOFF", "4OFF", "nOFF", "BINARY", "#"});
}

TEST(FuzzMesh, Obj) {
  damage_meshes("obj", {obj(), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\n"},
                {"v ", "vn ", "f ", "/", "//", "usemtl", "\\\n"});
}

TEST(FuzzMesh, Ply) {
  damage_meshes(
      "ply",
      {ply_of("ascii", vertices_and_faces("")),
       ply_of("binary_little_endian", binary_body())},
      {"element ", "property ", "list ", "uchar ", "double ", "vertex", "face",
       "format ", "end_header\n", "vertex_indices", "binary_big_endian"});
}

TEST(FuzzMesh, Stl) {
  damage_meshes("stl", {text_stl(), binary_stl()},
                {"solid", "facet", "vertex ", "endloop", "endfacet", "normal"});
}

TEST(FuzzMesh, Gltf) {
  damage_meshes("gltf", {test::gltf(kBox)},
                {"nodes", "children", "\"mesh\":0", "-1", "1e999", "5125", "4294967295",
                 "[0]", "{}", "null", "\"matrix\"", "\"byteStride\":1,"});
  damage_meshes("glb", {test::glb(kBox)},
                {"JSON", "BIN", "glTF", "\"byteOffset\":", "[0]", "null", "5121"});
}

}  // namespace
}  // namespace delos::fuzz
