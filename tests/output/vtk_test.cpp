// .vti and .vtp files read back by a small reader of its own: XML by a stack of tags,
// base64 by table look-up from RFC 4648.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <map>
#include <sstream>

#include "output/fields.h"
#include "output/write.h"

namespace delos {
namespace {

std::string decode_base64(const std::string& text) {
  static const std::string digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0;
  int pending = 0;
  EXPECT_EQ(text.size() % 4, 0u);
  for (const char c : text) {
    if (c == '=') break;
    const std::size_t digit = digits.find(c);
    EXPECT_NE(digit, std::string::npos) << "not base64: " << c;
    bits = bits << 6 | static_cast<unsigned>(digit);
    pending += 6;
    if (pending < 8) continue;
    pending -= 8;
    bytes += static_cast<char>(bits >> pending & 0xFF);
  }
  return bytes;
}

struct Element {
  std::string name;
  std::map<std::string, std::string> attributes;
  std::string text;
};

/// All elements of a document without comments and entities in text, in order. Expects
/// tags to close in order.
std::vector<Element> read_xml(const std::string& xml) {
  std::vector<Element> elements;
  std::vector<std::string> open;
  const std::string head = "<?xml version=\"1.0\"?>\n";
  EXPECT_EQ(xml.substr(0, head.size()), head);
  for (std::size_t at = head.size(); (at = xml.find('<', at)) != std::string::npos;) {
    const std::size_t end = xml.find('>', at);
    const std::string tag = xml.substr(at + 1, end - at - 1);
    at = end;
    if (tag[0] == '/') {
      if (open.empty() || open.back() != tag.substr(1)) {
        ADD_FAILURE() << "unexpected </" << tag.substr(1) << ">";
        return elements;
      }
      open.pop_back();
      continue;
    }
    Element element;
    element.name = tag.substr(0, tag.find(' '));
    for (std::size_t quote = tag.find('"'); quote != std::string::npos;) {
      const std::size_t close = tag.find('"', quote + 1);
      const std::size_t name = tag.rfind(' ', quote) + 1;
      element.attributes[tag.substr(name, quote - 1 - name)] =
          tag.substr(quote + 1, close - quote - 1);
      quote = tag.find('"', close + 1);
    }
    element.text = xml.substr(end + 1, xml.find('<', end) - end - 1);
    open.push_back(element.name);
    elements.push_back(element);
  }
  EXPECT_TRUE(open.empty());
  return elements;
}

const Element& find(const std::vector<Element>& elements, const std::string& name) {
  for (const Element& element : elements)
    if (element.name == name) return element;
  throw std::runtime_error("no element " + name);
}

/// Numbers of the DataArray of that name, little endian behind their length in bytes.
template <typename T>
std::vector<T> array(const std::vector<Element>& elements, const std::string& name,
                     const std::string& type) {
  for (const Element& element : elements) {
    if (element.name != "DataArray" || element.attributes.at("Name") != name) continue;
    EXPECT_EQ(element.attributes.at("type"), type);
    EXPECT_EQ(element.attributes.at("format"), "binary");
    const std::string bytes = decode_base64(element.text);
    std::uint64_t length = 0;
    std::memcpy(&length, bytes.data(), sizeof length);
    EXPECT_EQ(length, bytes.size() - sizeof length);
    std::vector<T> numbers(length / sizeof(T));
    // Copying nothing to nowhere is undefined, even so.
    if (length > 0) std::memcpy(numbers.data(), bytes.data() + sizeof length, length);
    return numbers;
  }
  throw std::runtime_error("no array " + name);
}

void expect_values(const std::vector<Element>& elements, const Field& field) {
  const auto values = array<double>(elements, "eigmax [m]", "Float64");
  const auto observable = array<unsigned char>(elements, "observable", "UInt8");
  ASSERT_EQ(values.size(), field.value.size());
  EXPECT_EQ(observable, field.observable);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isfinite(field.value[i]))
      EXPECT_EQ(values[i], field.value[i]) << i;
    else
      EXPECT_TRUE(std::isnan(values[i])) << i;
  }
}

std::vector<double> numbers(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<double>(stream), {}};
}

TEST(Vti, HoldsGridAndValues) {
  const Folder folder;
  Field field = volume(
      {{-0.3, 0.1, 2}, {0.1, 0.2, 1.0 / 3}, {5, 3, 2}}, [](const Eigen::Vector3d& p) {
        return p.x() > 0.05 ? kBlind : p.x() + 10 * p.y() + 100 * p.z();
      });
  field.observable[0] = 0;  // finite, and yet some direction isn't observed
  ASSERT_EQ(write_field(field, folder / "f.vti"), "");
  const std::vector<Element> elements = read_xml(bytes_of(folder / "f.vti"));

  const auto& file = elements.front().attributes;
  EXPECT_EQ(file.at("type"), "ImageData");
  EXPECT_EQ(file.at("byte_order"), "LittleEndian");
  EXPECT_EQ(file.at("header_type"), "UInt64");
  const auto& image = find(elements, "ImageData").attributes;
  EXPECT_EQ(image.at("WholeExtent"), "0 4 0 2 0 1");
  EXPECT_EQ(image.at("Origin"), "-0.3 0.1 2");
  EXPECT_EQ(numbers(image.at("Spacing")), (std::vector<double>{0.1, 0.2, 1.0 / 3}));
  EXPECT_EQ(find(elements, "Piece").attributes.at("Extent"), "0 4 0 2 0 1");
  EXPECT_EQ(find(elements, "PointData").attributes.at("Scalars"), "eigmax [m]");
  expect_values(elements, field);
}

TEST(Vti, TakesAxesOfOneSample) {
  const Folder folder;
  const Field field = volume({{1, 2, 3}, {0.1, 0.1, 0.1}, {1, 1, 1}},
                             [](const Eigen::Vector3d&) { return 0.5; });
  ASSERT_EQ(write_field(field, folder / "f.vti"), "");
  const std::vector<Element> elements = read_xml(bytes_of(folder / "f.vti"));
  EXPECT_EQ(find(elements, "ImageData").attributes.at("WholeExtent"), "0 0 0 0 0 0");
  expect_values(elements, field);
}

TEST(Vtp, HoldsPointsAndValues) {
  const Folder folder;
  const Field field = scattered({0.1, kBlind, 0.3, std::nan("")});
  ASSERT_EQ(write_field(field, folder / "f.vtp"), "");
  const std::vector<Element> elements = read_xml(bytes_of(folder / "f.vtp"));
  EXPECT_EQ(elements.front().attributes.at("type"), "PolyData");
  EXPECT_EQ(find(elements, "Piece").attributes.at("NumberOfPoints"), "4");
  EXPECT_EQ(find(elements, "Piece").attributes.at("NumberOfVerts"), "4");
  expect_values(elements, field);

  const auto points = array<double>(elements, "Points", "Float64");
  ASSERT_EQ(points.size(), 12u);
  for (std::size_t i = 0; i < 4; ++i)
    for (int k = 0; k < 3; ++k)
      EXPECT_EQ(points[3 * i + k], field.samples.points[i][k]);
  EXPECT_EQ(array<std::int64_t>(elements, "connectivity", "Int64"),
            (std::vector<std::int64_t>{0, 1, 2, 3}));
  EXPECT_EQ(array<std::int64_t>(elements, "offsets", "Int64"),
            (std::vector<std::int64_t>{1, 2, 3, 4}));
}

TEST(Vtp, DrawsTheTrianglesOfMeshes) {
  const Folder folder;
  Field field = scattered({1, 2});
  add_part(field, {"hull", 0, 0, SurfaceShape{{{0, 1, 2}, {2, 1, 3}}}},
           {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {3, 4, 5, 6});
  ASSERT_EQ(write_field(field, folder / "f.vtp"), "");
  const std::string text = bytes_of(folder / "f.vtp");
  const std::vector<Element> elements = read_xml(text);
  const auto& piece = find(elements, "Piece").attributes;
  EXPECT_EQ(piece.at("NumberOfPoints"), "6");
  EXPECT_EQ(piece.at("NumberOfVerts"), "2");
  EXPECT_EQ(piece.at("NumberOfPolys"), "2");
  expect_values(elements, field);
  // Dots for the two samples before the mesh, whose corners count from the first of
  // all.
  const auto after = [&](const char* element) {
    const auto begin =
        std::find_if(elements.begin(), elements.end(),
                     [&](const Element& e) { return e.name == element; });
    return std::vector<Element>(begin, elements.end());
  };
  const auto verts = after("Verts"), polys = after("Polys");
  EXPECT_EQ(array<std::int64_t>(verts, "connectivity", "Int64"),
            (std::vector<std::int64_t>{0, 1}));
  EXPECT_EQ(array<std::int64_t>(verts, "offsets", "Int64"),
            (std::vector<std::int64_t>{1, 2}));
  EXPECT_EQ(array<std::int64_t>(polys, "connectivity", "Int64"),
            (std::vector<std::int64_t>{2, 3, 4, 4, 3, 5}));
  EXPECT_EQ(array<std::int64_t>(polys, "offsets", "Int64"),
            (std::vector<std::int64_t>{3, 6}));
}

TEST(Vtp, NumbersTheSampleSets) {
  const Folder folder;
  Field field = scattered({1, 2});
  add_part(field, {"b", 0, 0, ScatteredShape{}}, {{0, 0, 7}}, {3});
  ASSERT_EQ(write_field(field, folder / "f.vtp"), "");
  EXPECT_EQ(array<std::int32_t>(read_xml(bytes_of(folder / "f.vtp")), "part", "Int32"),
            (std::vector<std::int32_t>{0, 0, 1}));
}

TEST(Vtp, EscapesNames) {
  const Folder folder;
  Field field = scattered({1});
  field.metric = "a<b>&\"c\"";
  ASSERT_EQ(write_field(field, folder / "f.vtp"), "");
  EXPECT_EQ(array<double>(read_xml(bytes_of(folder / "f.vtp")),
                          "a&lt;b&gt;&amp;&quot;c&quot; [m]", "Float64"),
            std::vector<double>{1});
}

TEST(Vtp, OfNoSamplesIsAFile) {
  const Folder folder;
  ASSERT_EQ(write_field(empty_field(), folder / "f.vtp"), "");
  EXPECT_TRUE(
      array<double>(read_xml(bytes_of(folder / "f.vtp")), "Points", "Float64").empty());
}

// An octree of one halved root: 27 nodes, eight voxels.
TEST(Vtu, HoldsTheLeavesOfAnOctree) {
  Field field = empty_field();
  std::vector<Eigen::Vector3d> points;
  std::vector<double> values;
  for (int n = 0; n < 27; ++n) {
    points.emplace_back(n % 3, n / 3 % 3, n / 9);
    values.push_back(n == 13 ? kBlind : 0.5 + n);
  }
  OctreeShape octree;
  for (std::uint32_t c = 0; c < 8; ++c) {
    const std::uint32_t base = (c & 1) + 3 * (c >> 1 & 1) + 9 * (c >> 2);
    octree.cells.push_back({base, base + 1, base + 3, base + 4, base + 9, base + 10,
                            base + 12, base + 13});
    octree.levels.push_back(1);
  }
  add_part(field, {"", 0, 0, octree}, points, values);
  field.lost.assign(27, 0);
  field.lost[13] = 2;

  const Folder folder;
  ASSERT_EQ(write_field(field, folder / "f.vtu"), "");
  const std::vector<Element> xml = read_xml(bytes_of(folder / "f.vtu"));
  EXPECT_EQ(find(xml, "VTKFile").attributes.at("type"), "UnstructuredGrid");
  EXPECT_EQ(find(xml, "Piece").attributes.at("NumberOfPoints"), "27");
  EXPECT_EQ(find(xml, "Piece").attributes.at("NumberOfCells"), "8");
  expect_values(xml, field);
  EXPECT_EQ(array<unsigned char>(xml, "lost directions", "UInt8"), field.lost);
  EXPECT_EQ(array<std::int32_t>(xml, "level", "Int32"), octree.levels);
  EXPECT_EQ(array<unsigned char>(xml, "types", "UInt8"),
            std::vector<unsigned char>(8, 11));
  const auto corners = array<std::int64_t>(xml, "connectivity", "Int64");
  ASSERT_EQ(corners.size(), 64u);
  for (std::size_t i = 0; i < 64; ++i) {
    EXPECT_EQ(corners[i], octree.cells[i / 8][i % 8]);
  }
  EXPECT_EQ(array<std::int64_t>(xml, "offsets", "Int64"),
            (std::vector<std::int64_t>{8, 16, 24, 32, 40, 48, 56, 64}));
  EXPECT_NE(write_field(field, folder / "f.vti").find(".vtu takes them"),
            std::string::npos);
}

}  // namespace
}  // namespace delos
