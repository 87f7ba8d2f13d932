#include "session/stored_field.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>

#include "output/write.h"
#include "session/json.h"

namespace delos::session {
namespace {

static_assert(std::endian::native == std::endian::little,
              "arrays are written as they are");

constexpr int kFormat = 1;

[[noreturn]] void damaged(const std::string& what) { throw std::runtime_error(what); }

// ----------------------------------------------------------------------------- arrays

template <class T>
Json bytes_of(const T* data, std::size_t count) {
  Json::binary_t::container_type raw(count * sizeof(T));
  if (count > 0) std::memcpy(raw.data(), data, raw.size());
  return Json::binary(std::move(raw));
}

template <class T>
Json bytes_of(const std::vector<T>& all) {
  return bytes_of(all.data(), all.size());
}

template <class T>
std::vector<T> array_of(const Json& json, const char* key) {
  const auto& raw = json.at(key).get_binary();
  if (raw.size() % sizeof(T) != 0) damaged(std::string(key) + " is cut short");
  std::vector<T> all(raw.size() / sizeof(T));
  if (!raw.empty()) std::memcpy(all.data(), raw.data(), raw.size());
  return all;
}

/// One a point, or none where that is allowed.
template <class T>
std::vector<T> of_points(const Json& json, const char* key, std::size_t points,
                         bool may_be_empty = false) {
  std::vector<T> all = array_of<T>(json, key);
  if (all.size() != points && !(may_be_empty && all.empty()))
    damaged(std::string(key) + " has another length than the points");
  return all;
}

Json three_json(const Eigen::Vector3d& v) { return bytes_of(v.data(), 3); }

Eigen::Vector3d three_of(const Json& json, const char* key) {
  const auto all = array_of<double>(json, key);
  if (all.size() != 3) damaged(std::string(key) + " isn't three numbers");
  return {all[0], all[1], all[2]};
}

// ---------------------------------------------------------------------------- samples

struct StoredShape {
  Json operator()(const GridShape& s) const {
    return {{"kind", "grid"},
            {"origin", three_json(s.origin)},
            {"step", three_json(s.step)},
            {"counts", bytes_of(s.counts.data(), 3)}};
  }
  Json operator()(const PlaneShape& s) const {
    return {{"kind", "plane"},
            {"origin", three_json(s.origin)},
            {"u", three_json(s.u)},
            {"v", three_json(s.v)},
            {"counts", bytes_of(s.counts.data(), 2)}};
  }
  Json operator()(const SurfaceShape& s) const {
    return {{"kind", "surface"}, {"triangles", bytes_of(s.triangles)}};
  }
  Json operator()(const ScatteredShape&) const { return {{"kind", "scattered"}}; }
  Json operator()(const OctreeShape& s) const {
    return {{"kind", "octree"},
            {"cells", bytes_of(s.cells)},
            {"levels", bytes_of(s.levels)}};
  }
};

template <std::size_t N>
std::vector<std::array<std::uint32_t, N>> corners_of(const Json& json, const char* key,
                                                     std::size_t points) {
  auto all = array_of<std::array<std::uint32_t, N>>(json, key);
  for (const auto& corners : all)
    for (const std::uint32_t corner : corners)
      if (corner >= points)
        damaged(std::string(key) + " name a point that isn't there");
  return all;
}

/// Samples along each side, whose product is the part's.
template <class Count, std::size_t N>
std::array<Count, N> counts_of(const Json& json, std::size_t points) {
  const auto all = array_of<Count>(json, "counts");
  std::array<Count, N> counts{};
  std::size_t left = points;
  if (all.size() != N) damaged("counts have another length");
  for (std::size_t i = 0; i < N; ++i) {
    counts[i] = all[i];
    const auto n = static_cast<std::size_t>(all[i]);
    if (all[i] < 1 || n > left || left % n != 0)
      damaged("counts aren't those of the points");
    left /= n;
  }
  if (left != 1) damaged("counts aren't those of the points");
  return counts;
}

decltype(SamplePart::shape) shape_of(const Json& json, std::size_t points) {
  const std::string kind = json.at("kind").get<std::string>();
  if (kind == "scattered") return ScatteredShape{};
  if (kind == "surface") return SurfaceShape{corners_of<3>(json, "triangles", points)};
  if (kind == "octree") {
    OctreeShape shape{corners_of<8>(json, "cells", points),
                      array_of<int>(json, "levels")};
    if (shape.levels.size() != shape.cells.size())
      damaged("levels have another length than cells");
    return shape;
  }
  if (kind == "grid") {
    const auto n = counts_of<std::int64_t, 3>(json, points);
    return GridShape{
        three_of(json, "origin"), three_of(json, "step"), {n[0], n[1], n[2]}};
  }
  if (kind != "plane") damaged("there is no shape '" + kind + "'");
  const auto n = counts_of<int, 2>(json, points);
  return PlaneShape{
      three_of(json, "origin"), three_of(json, "u"), three_of(json, "v"), {n[0], n[1]}};
}

Json samples_json(const Samples& samples) {
  Json parts = Json::array();
  for (const SamplePart& part : samples.parts)
    parts.push_back({{"name", part.name},
                     {"count", part.count},
                     {"shape", std::visit(StoredShape(), part.shape)}});
  return {{"points", bytes_of(samples.points)}, {"parts", parts}};
}

Samples samples_of(const Json& json) {
  Samples samples;
  static_assert(sizeof(Eigen::Vector3d) == 3 * sizeof(double));
  samples.points = array_of<Eigen::Vector3d>(json, "points");
  std::size_t first = 0;
  for (const Json& part : json.at("parts")) {
    const auto count = part.at("count").get<std::size_t>();
    if (count > samples.points.size() - first)
      damaged("parts have more than all points");
    samples.parts.push_back({part.at("name").get<std::string>(), first, count,
                             shape_of(part.at("shape"), count)});
    first += count;
  }
  if (first != samples.points.size()) damaged("parts have fewer than all points");
  return samples;
}

// ------------------------------------------------------------------------- definition

/// The value of an enumeration whose word this is, counted from 0.
template <class Word>
Word word_of(const Json& json, const char* key, Word last) {
  const std::string text = json.at(key).get<std::string>();
  for (int i = 0; i <= static_cast<int>(last); ++i)
    if (text == to_string(static_cast<Word>(i))) return static_cast<Word>(i);
  damaged(std::string(key) + " '" + text + "' isn't known");
}

Json definition_json(const Definition& d) {
  return {{"fusion", to_string(d.fusion)},
          {"covariance", to_string(d.covariance)},
          {"lag", d.lag},
          {"error", d.error ? Json(to_string(*d.error)) : Json()}};
}

Definition definition_of_stored(const Json& json) {
  Definition d;
  d.fusion = word_of(json, "fusion", Fusion::artemis);
  d.covariance = word_of(json, "covariance", CovarianceKind::single);
  d.lag = json.at("lag").get<double>();
  if (!json.at("error").is_null()) d.error = word_of(json, "error", ErrorPart::bias);
  return d;
}

// ------------------------------------------------------------------------------ field

Json stored_json(const Field& f) {
  Json json{{"scene", f.scene},
            {"metric", f.metric},
            {"unit", f.unit},
            {"definition", definition_json(f.definition)},
            {"larger_is_better", f.larger_is_better},
            {"samples", samples_json(f.samples)},
            {"value", bytes_of(f.value)},
            {"observable", bytes_of(f.observable)},
            {"lost", bytes_of(f.lost)},
            {"inside", bytes_of(f.inside)},
            {"weight", bytes_of(f.weight)},
            {"spread", f.spread ? stored_json(*f.spread) : Json()},
            {"discretization_error",
             f.discretization_error ? Json(*f.discretization_error) : Json()},
            {"evaluations", f.evaluations},
            {"threads", f.threads},
            {"seconds", f.seconds},
            {"cancelled", f.cancelled},
            {"evaluated", f.evaluated}};
  return json;
}

Field field_of_stored(const Json& json, bool may_spread) {
  Field f;
  f.scene = json.at("scene").get<std::string>();
  f.metric = json.at("metric").get<std::string>();
  f.unit = json.at("unit").get<std::string>();
  f.definition = definition_of_stored(json.at("definition"));
  f.larger_is_better = json.at("larger_is_better").get<bool>();
  f.samples = samples_of(json.at("samples"));
  const std::size_t n = f.samples.points.size();
  f.value = of_points<double>(json, "value", n);
  f.observable = of_points<unsigned char>(json, "observable", n);
  f.lost = of_points<unsigned char>(json, "lost", n, true);
  f.inside = of_points<unsigned char>(json, "inside", n, true);
  f.weight = of_points<double>(json, "weight", n, true);
  if (const Json& spread = json.at("spread"); !spread.is_null()) {
    if (!may_spread) damaged("a spread has a spread");
    f.spread = std::make_shared<const Field>(field_of_stored(spread, false));
    if (f.spread->value.size() % 2 != 0) damaged("the spread isn't one of pairs");
  }
  if (const Json& error = json.at("discretization_error"); !error.is_null())
    f.discretization_error = error.get<double>();
  f.evaluations = json.at("evaluations").get<std::size_t>();
  f.threads = json.at("threads").get<int>();
  f.seconds = json.at("seconds").get<double>();
  f.cancelled = json.at("cancelled").get<bool>();
  f.evaluated = json.at("evaluated").get<std::size_t>();
  if (f.evaluated > n) damaged("more points are evaluated than there are");
  return f;
}

StoredField stored_of(const Json& json) {
  if (json.at("delos_field").get<int>() != kFormat)
    damaged("it is of another version of Delos");
  StoredField stored{field_of_stored(json.at("field"), true), {}};
  for (const Json& device : json.at("devices")) {
    Marker marker{device.at("name").get<std::string>(), three_of(device, "at"), {}};
    if (device.contains("faces")) marker.faces = three_of(device, "faces");
    stored.devices.push_back(std::move(marker));
  }
  return stored;
}

}  // namespace

bool is_stored_field(const std::filesystem::path& file) {
  return file.extension() == ".field";
}

std::string store_field(const Field& field, const std::vector<Marker>& devices,
                        const std::filesystem::path& file) {
  Json json{{"delos_field", kFormat}, {"field", stored_json(field)}};
  json["devices"] = Json::array();
  for (const Marker& marker : devices) {
    json["devices"].push_back({{"name", marker.name}, {"at", three_json(marker.p)}});
    if (marker.faces) json["devices"].back()["faces"] = three_json(*marker.faces);
  }
  std::string bytes;
  Json::to_cbor(json, bytes);
  return write_text(file, bytes);
}

std::variant<StoredField, std::string> read_field(const std::filesystem::path& file) {
  const auto refused = [&](const std::string& why) {
    return file.string() + " can't be read as a field: " + why;
  };
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error))
    return refused("there is no such file");
  std::ifstream in(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  if (in.bad()) return refused("reading failed");
  try {
    return stored_of(Json::from_cbor(bytes));
  } catch (const Json::exception&) {
    return refused("it isn't one of delos field --out, or is damaged");
  } catch (const std::runtime_error& failure) {
    return refused(failure.what());
  }
}

}  // namespace delos::session
