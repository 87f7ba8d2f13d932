#include "geometry/mesh/gltf.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <string_view>

#include "geometry/mesh/ply.h"

namespace delos {
namespace {

using Json = nlohmann::json;

/// Deeper than any scene is built.
constexpr int kMostNested = 1000;
/// More corners than anybody hides behind: a small file may name the same ones often.
constexpr std::size_t kMostCorners = 30'000'000;

[[noreturn]] void refuse_gltf(const std::string& why) { throw MeshProblem{why}; }

std::uint32_t little_endian(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (int i = 0; i < 4; ++i)
    value |= std::uint32_t{static_cast<unsigned char>(
                 bytes[at + static_cast<std::size_t>(i)])}
             << (8 * i);
  return value;
}

/// RFC 4648, section 4.
std::string from_base64(std::string_view text) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t group = 0;
  int bits = 0;
  for (const char c : text) {
    if (c == '=') break;
    const std::size_t digit = kDigits.find(c);
    if (digit == std::string_view::npos) refuse_gltf("has a buffer that isn't base64");
    group = group << 6 | static_cast<std::uint32_t>(digit);
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes += static_cast<char>(group >> bits & 0xFF);
  }
  return bytes;
}

/// The parts of a file.
struct Gltf {
  Json json;
  std::vector<std::string> buffers;

  /// Member `index` of a list by name.
  [[nodiscard]] const Json& member(const char* list, const Json& index) const {
    const auto found = json.find(list);
    if (found == json.end() || !found->is_array() || !index.is_number_unsigned() ||
        index.get<std::size_t>() >= found->size())
      refuse_gltf("names one of its '" + std::string(list) + "' that it doesn't have");
    const Json& one = (*found)[index.get<std::size_t>()];
    if (!one.is_object()) refuse_gltf("has '" + std::string(list) + "' that are none");
    return one;
  }
};

/// A whole number of an object.
std::size_t count_in(const Json& object, const char* key, std::size_t otherwise) {
  const auto found = object.find(key);
  if (found == object.end()) return otherwise;
  if (!found->is_number_unsigned())
    refuse_gltf("has a '" + std::string(key) + "' that is no whole number");
  return found->get<std::size_t>();
}

/// A key's value; an empty one where it isn't there.
const Json& value_in(const Json& object, const char* key) {
  static const Json kNothing;
  const auto found = object.find(key);
  return found == object.end() ? kNothing : *found;
}

bool read_parts(const std::string& bytes, Gltf& out) {
  constexpr std::uint32_t kJson = 0x4E4F534A, kBinary = 0x004E4942;
  std::string_view text = bytes, binary;
  const bool in_one = text.starts_with("glTF");
  if (in_one) {
    if (text.size() < 12 || little_endian(text, 4) != 2) return false;
    std::string_view chunks = text.substr(12);
    text = {};
    while (chunks.size() >= 8) {
      const std::size_t length = little_endian(chunks, 0);
      const std::uint32_t kind = little_endian(chunks, 4);
      if (length > chunks.size() - 8) return false;
      if (kind == kJson) text = chunks.substr(8, length);
      if (kind == kBinary) binary = chunks.substr(8, length);
      chunks.remove_prefix(8 + length);
    }
  }
  out.json = Json::parse(text, nullptr, false);
  if (!out.json.is_object()) return false;
  for (const Json& buffer : value_in(out.json, "buffers")) {
    if (!buffer.is_object()) return false;
    const Json& uri = value_in(buffer, "uri");
    if (!uri.is_string()) {
      out.buffers.emplace_back(binary);
      continue;
    }
    const auto& where = uri.get_ref<const std::string&>();
    const std::size_t comma = where.find(";base64,");
    if (!where.starts_with("data:") || comma == std::string::npos)
      refuse_gltf("keeps its numbers in another file; write it as one, as .glb");
    out.buffers.push_back(from_base64(std::string_view(where).substr(comma + 8)));
  }
  return true;
}

/// Numbers of one kind, one after the other or in steps.
class Accessor {
 public:
  /// @param components of each: 3 of a vector
  Accessor(const Gltf& file, const Json& index, std::size_t components) {
    const Json& accessor = file.member("accessors", index);
    if (accessor.contains("sparse"))
      refuse_gltf("has sparse accessors, which aren't read");
    const Json& view = file.member("bufferViews", value_in(accessor, "bufferView"));
    type_ = count_in(accessor, "componentType", 0);
    const std::size_t size = type_ == 5126 || type_ == 5125 ? 4
                             : type_ == 5123                ? 2
                             : type_ == 5121                ? 1
                                                            : 0;
    if (size == 0) refuse_gltf("has numbers of a kind that isn't read");
    const std::size_t buffer = count_in(view, "buffer", 0);
    if (buffer >= file.buffers.size())
      refuse_gltf("names one of its 'buffers' that it doesn't have");
    bytes_ = file.buffers[buffer];
    const std::size_t from = count_in(view, "byteOffset", 0);
    const std::size_t length = count_in(view, "byteLength", 0);
    if (from > bytes_.size() || length > bytes_.size() - from)
      refuse_gltf("announces more than it holds");
    bytes_ = bytes_.substr(from, length);
    first_ = count_in(accessor, "byteOffset", 0);
    step_ = count_in(view, "byteStride", size * components);
    count_ = count_in(accessor, "count", 0);
    const std::size_t each = size * components;
    // A step of nothing would be any number of corners in no bytes.
    if (step_ < each || first_ > length ||
        (count_ > 0 &&
         (length - first_ < each || (count_ - 1) > (length - first_ - each) / step_)))
      refuse_gltf("announces more than it holds");
  }

  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] bool holds_floats() const { return type_ == 5126; }

  [[nodiscard]] float number(std::size_t i, std::size_t component) const {
    return read<float>(i, component);
  }
  [[nodiscard]] std::size_t whole(std::size_t i) const {
    if (type_ == 5121) return read<std::uint8_t>(i, 0);
    return type_ == 5123 ? read<std::uint16_t>(i, 0) : read<std::uint32_t>(i, 0);
  }

 private:
  template <class T>
  [[nodiscard]] T read(std::size_t i, std::size_t component) const {
    T value;
    std::memcpy(&value, bytes_.data() + first_ + i * step_ + component * sizeof(T),
                sizeof(T));
    return value;
  }

  std::string_view bytes_;
  std::size_t type_ = 0, first_ = 0, step_ = 0, count_ = 0;
};

template <int n>
Eigen::Matrix<double, n, 1> numbers_in(const Json& node, const char* key,
                                       const Eigen::Matrix<double, n, 1>& otherwise) {
  const Json& list = value_in(node, key);
  if (list.is_null()) return otherwise;
  Eigen::Matrix<double, n, 1> out;
  if (!list.is_array() || list.size() != n)
    refuse_gltf("has a '" + std::string(key) + "' of a node that isn't one");
  for (int i = 0; i < n; ++i) {
    const Json& number = list[static_cast<std::size_t>(i)];
    if (!number.is_number()) refuse_gltf("has a node that isn't placed by numbers");
    out(i) = number.get<double>();
  }
  return out;
}

/// Where a node is in its parent.
Eigen::Affine3d placement_of(const Json& node) {
  Eigen::Affine3d at = Eigen::Affine3d::Identity();
  if (node.contains("matrix")) {
    const auto m = numbers_in<16>(node, "matrix", Eigen::Matrix<double, 16, 1>::Zero());
    at.matrix() = Eigen::Map<const Eigen::Matrix4d>(m.data());  // column by column
    return at;
  }
  const auto q = numbers_in<4>(node, "rotation", {0, 0, 0, 1});  // x, y, z, w
  return Eigen::Translation3d(numbers_in<3>(node, "translation", {0, 0, 0})) *
         Eigen::Quaterniond(q(3), q(0), q(1), q(2)).normalized() *
         Eigen::Scaling(numbers_in<3>(node, "scale", {1, 1, 1}));
}

/// Gathers the triangles of nodes.
class Gatherer {
 public:
  Gatherer(const Gltf& file, SoupPoints& points, SoupPolygons& polygons)
      : file_(file), points_(points), polygons_(polygons) {}

  void node(const Json& index, const Eigen::Affine3d& parent, int depth) {
    const Json& node = file_.member("nodes", index);
    if (depth > kMostNested || !met_.insert(index.get<std::size_t>()).second)
      refuse_gltf("has nodes that are in each other, or in two others");
    const Eigen::Affine3d at = parent * placement_of(node);
    if (node.contains("mesh")) mesh(file_.member("meshes", node["mesh"]), at);
    for (const Json& child : value_in(node, "children"))
      this->node(child, at, depth + 1);
  }

 private:
  void mesh(const Json& mesh, const Eigen::Affine3d& at) {
    for (const Json& primitive : value_in(mesh, "primitives")) {
      if (!primitive.is_object()) refuse_gltf("has a mesh that is none");
      if (value_in(primitive, "extensions").contains("KHR_draco_mesh_compression"))
        refuse_gltf("is compressed by Draco, which isn't read; write it plainly");
      const std::size_t mode = count_in(primitive, "mode", 4);
      if (mode < 4 || mode > 6) continue;  // points and lines
      triangles(primitive, mode, at);
    }
  }

  void triangles(const Json& primitive, std::size_t mode, const Eigen::Affine3d& at) {
    const Json& attributes = value_in(primitive, "attributes");
    const Accessor places(file_, value_in(attributes, "POSITION"), 3);
    if (!places.holds_floats()) refuse_gltf("has places that are no float numbers");
    std::vector<std::size_t> corners;
    const Json& indices = value_in(primitive, "indices");
    if (indices.is_null()) {
      for (std::size_t i = 0; i < places.count(); ++i) corners.push_back(i);
    } else {
      const Accessor order(file_, indices, 1);
      if (order.holds_floats()) refuse_gltf("has corners that are no whole numbers");
      for (std::size_t i = 0; i < order.count(); ++i) corners.push_back(order.whole(i));
    }
    corners_ += corners.size();
    if (corners_ > kMostCorners) refuse_gltf("has more corners than can be read");
    for (std::size_t& corner : corners) {
      if (corner >= places.count())
        refuse_gltf("has a face that names a vertex that doesn't exist");
      const Eigen::Vector3d p(places.number(corner, 0), places.number(corner, 1),
                              places.number(corner, 2));
      corner = vertex(at * p);
    }
    // A mirror turns faces inside out.
    const bool mirrors = at.linear().determinant() < 0;
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
      if (mirrors) std::swap(b, c);
      Claimed<std::size_t> face;
      face.assign({corners[a], corners[b], corners[c]});
      polygons_.push_back(std::move(face));
    };
    for (std::size_t i = 2; i < corners.size(); i += mode == 4 ? 3 : 1) {
      if (mode == 4) add(i - 2, i - 1, i);
      if (mode == 5) add(i - 2, i - 1 + i % 2, i - i % 2);
      if (mode == 6) add(0, i - 1, i);
    }
  }

  std::size_t vertex(const Eigen::Vector3d& p) {
    if (!p.allFinite())
      refuse_gltf("has vertex " + std::to_string(points_.size()) +
                  " (counted from 0), which isn't finite");
    const std::array<double, 3> place = {p.x(), -p.z(), p.y()};
    const auto [known, is_new] = numbers_.emplace(place, points_.size());
    if (is_new) points_.push_back({place[0], place[1], place[2]});
    return known->second;
  }

  const Gltf& file_;
  SoupPoints& points_;
  SoupPolygons& polygons_;
  std::map<std::array<double, 3>, std::size_t> numbers_;
  std::set<std::size_t> met_;  ///< nodes
  std::size_t corners_ = 0;
};

}  // namespace

bool read_gltf(std::istream& in, SoupPoints& points, SoupPolygons& polygons) {
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  Gltf file;
  if (!read_parts(bytes, file)) return false;
  Gatherer gatherer(file, points, polygons);
  const Json first = std::size_t{0};
  const Json& scene =
      file.member("scenes", file.json.contains("scene") ? file.json["scene"] : first);
  for (const Json& node : value_in(scene, "nodes"))
    gatherer.node(node, Eigen::Affine3d::Identity(), 0);
  return true;
}

}  // namespace delos
