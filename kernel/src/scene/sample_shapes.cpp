#include "scene/sample_shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "delos/text/number_text.h"
#include "document/node_text.h"
#include "scene/body_keys.h"
#include "scene/mesh_keys.h"
#include "scene/point_file.h"

namespace delos {
namespace {

using namespace shapes;
using Written = std::optional<Node>;

// ---- volume ----

/// A box as its keys say it; `near` is read once the metric is known.
struct Volume {
  Eigen::Vector3d min = Eigen::Vector3d::Zero(), max = Eigen::Vector3d::Zero();
  std::optional<Eigen::Vector3d> step;
  std::optional<AdaptiveSampling> adaptive;
};

constexpr Bounds kStep = above(0), kNear = above(0);

/// One step for all axes, or a list of three.
void read_step(Reader& reader, const Place& at, Volume& out) {
  const bool list = at.node().kind == Node::Kind::list;
  const std::size_t before = reader.findings.errors();
  Eigen::Vector3d& step = out.step.emplace(Eigen::Vector3d::Ones());
  if (list) {
    read_vector(reader, at, step);
  } else if (const auto all = reader.number(at, "m")) {
    step.setConstant(*all);
  }
  if (reader.findings.errors() != before) return;
  for (std::size_t i = 0; i < (list ? 3 : 1); ++i) {
    const Place place = list ? Place(at, kAxes[i], at.node().items[i]) : at;
    reader.within(place, step[static_cast<Eigen::Index>(i)], kStep, "m");
  }
}

Written write_if(const std::optional<double>& value) {
  if (!value) return std::nullopt;
  return to_node(*value);
}

constexpr std::array<Key<AdaptiveSampling>, 6> kAdaptiveKeys = {{
    member_key<&AdaptiveSampling::tolerance>(
        "tolerance", Need::optional, "relative error of the metric, such as 2 %",
        number("1", {.least = 0,
                     .greatest = 1,
                     .above = true,
                     .below = true,
                     .why = ", such as 2 %"})),
    member_key<&AdaptiveSampling::depth>("depth", Need::optional,
                                         "how often the box may be halved, 1 to 12",
                                         integer(1, 12)),
    {"evaluations", Need::optional, "stop after about so many", integer(1),
     [](Reader& r, const Place& p, AdaptiveSampling& a) {
       if (const auto most = r.integer(p)) a.evaluations = *most;
     },
     [](const AdaptiveSampling& a) -> Written {
       if (!a.evaluations) return std::nullopt;
       return to_node(static_cast<int>(*a.evaluations));
     }},
    other_key<&AdaptiveSampling::seconds>(
        "seconds", Need::optional, "stop after about so long", number("s", above(0))),
    {"near", Need::optional, "refine only around this value of the metric",
     number(nullptr, kNear), nullptr,
     [](const AdaptiveSampling& a) { return write_if(a.near_value); }},
    {"within", Need::optional, "refine only in this box: its corners min and max",
     map(box_keys),
     [](Reader& r, const Place& p, AdaptiveSampling& a) {
       if (const auto box = read_box(r, p)) a.within.emplace(box->min, box->max);
     },
     [](const AdaptiveSampling& a) -> Written {
       if (!a.within) return std::nullopt;
       return write_box({a.within->min(), a.within->max()});
     }},
}};

std::vector<Shape> step_forms() {
  return {number("m", kStep), numbers("m", 3, 3, kStep)};
}

constexpr std::array<Key<Volume>, 4> kVolumeKeys = {{
    member_key<&Volume::min>("min", Need::required, "corner [x, y, z], metres",
                             vector("m")),
    member_key<&Volume::max>("max", Need::required, "opposite corner [x, y, z], metres",
                             vector("m")),
    {"step", Need::optional, "distance of samples, metres: a number or [x, y, z]",
     either(step_forms), read_step,
     [](const Volume& v) -> Written {
       if (!v.step) return std::nullopt;
       if (v.step->x() == v.step->y() && v.step->y() == v.step->z())
         return to_node(v.step->x());
       return vector_node(*v.step);
     }},
    {"adaptive", Need::optional, "samples only where the field needs them",
     map<kAdaptiveKeys>(),
     [](Reader& r, const Place& p, Volume& v) {
       read_map(r, p, kAdaptiveKeys, v.adaptive.emplace());
     },
     [](const Volume& v) -> Written {
       if (!v.adaptive) return std::nullopt;
       return write_map(kAdaptiveKeys, *v.adaptive);
     }},
}};

/// Exactly one key says where the samples are.
void check_density(Reader& reader, const Place& at) {
  const Node* step = at.node().find("step");
  const Node* adaptive = at.node().find("adaptive");
  if (step && adaptive)
    reader.error_within(at, adaptive->mark, "adaptive",
                        "the samples are given by 'step' already; keep one");
  else if (!step && !adaptive)
    reader.error_within(at, at.node().mark, "step",
                        "missing: distance of samples, metres: a number or [x, y, z]; "
                        "or give 'adaptive'");
}

/// The corners must be in order, and the step must make a countable number of samples.
void check_box(Reader& reader, const Place& at, const Volume& v) {
  const std::size_t before = reader.findings.errors();
  const Place max(at, "max", *at.node().find("max"));
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    const Node& item = max.node().items[i];
    if (v.max[axis] < v.min[axis])
      reader.error(Place(max, kAxes[i], item),
                   item.text + " is below min; exchange them");
    else if (v.adaptive && v.max[axis] == v.min[axis])
      reader.error(
          Place(max, kAxes[i], item),
          item.text + " is min too; adaptive samples need a box, so give a step");
  }
  // A number of steps that isn't a double leaves nothing to count or to suggest.
  const Eigen::Vector3d extent = v.max - v.min;
  if (v.step && !(extent.array() / v.step->array()).isFinite().all())
    reader.error(Place(at, "step", *at.node().find("step")),
                 "is too small for this box");
  if (!v.adaptive || reader.findings.errors() != before) return;
  const Place adaptive(at, "adaptive", *at.node().find("adaptive"));
  if (!extent.allFinite())
    reader.error(max, "is further from min than a double can tell");
  if (v.adaptive->within &&
      !v.adaptive->within->intersects(Eigen::AlignedBox3d(v.min, v.max)))
    reader.error_within(adaptive, adaptive.node().find("within")->mark, "within",
                        "is outside of the volume");
}

// ---- mesh ----

constexpr std::array<Key<MeshShape>, 2> kMeshKeys = {{
    {"file", Need::required,
     "a .off, .obj, .ply, .stl, .glb or .gltf file, relative to the scene", text(),
     read_mesh_file, [](const MeshShape& m) -> Written { return to_node(m.file); }},
    {"scale", Need::optional, "metres per unit of the file", kScaleShape, read_scale,
     write_scale},
}};

// ---- plane ----

void read_counts(Reader& reader, const Place& at, PlaneSampling& out) {
  if (!reader.expect(at, Node::Kind::list, "two whole numbers [nu, nv]")) return;
  const auto& items = at.node().items;
  if (items.size() != 2) {
    reader.error(at, "expected two whole numbers [nu, nv], not " +
                         std::to_string(items.size()) + " members");
    return;
  }
  for (std::size_t i = 0; i < 2; ++i)
    if (const auto n = reader.integer(Place(at, std::to_string(i), items[i]), 1,
                                      std::numeric_limits<int>::max()))
      out.counts[static_cast<Eigen::Index>(i)] = *n;
}

constexpr std::array<Key<PlaneSampling>, 4> kPlaneKeys = {{
    member_key<&PlaneSampling::origin>("origin", Need::required,
                                       "corner [x, y, z], metres", vector("m")),
    member_key<&PlaneSampling::u>("u", Need::required, "first edge [x, y, z], metres",
                                  vector("m")),
    member_key<&PlaneSampling::v>("v", Need::required, "second edge [x, y, z], metres",
                                  vector("m")),
    {"counts", Need::required, "samples along u and v, [nu, nv]",
     numbers("1", 2, 2, at_least(1)), read_counts,
     [](const PlaneSampling& s) -> Written {
       return to_node(std::vector<Node>{to_node(s.counts[0]), to_node(s.counts[1])});
     }},
}};

// ---- path ----

void read_waypoints(Reader& reader, const Place& at, PathSampling& out) {
  const auto written = reader.word(at);
  if (!written) return;
  out.file = reader.file_name(at, *written);
  const auto rows =
      read_row_file(reader, at, out.file, {{"x", "y", "z"}, {3}}, "waypoints");
  if (!rows) return;
  for (const auto& row : *rows) out.waypoints.emplace_back(row[0], row[1], row[2]);
}

constexpr std::array<Key<PathSampling>, 4> kPathKeys = {{
    {"points", Need::optional, "waypoints in order [[x, y, z], …], metres", points(),
     [](Reader& r, const Place& p, PathSampling& s) {
       if (auto points = r.vectors3(p, "m")) s.waypoints = std::move(*points);
     },
     [](const PathSampling& s) -> Written {
       if (!s.file.empty()) return std::nullopt;
       return to_node(s.waypoints);
     }},
    {"file", Need::optional, "waypoints in a .ptl or .csv file, relative to the scene",
     text(), read_waypoints,
     [](const PathSampling& s) -> Written {
       if (s.file.empty()) return std::nullopt;
       return to_node(s.file);
     }},
    other_key<&PathSampling::step>("step", Need::optional,
                                   "distance of samples along the path, metres",
                                   number("m", above(0))),
    other_key<&PathSampling::count>("count", Need::optional,
                                    "samples at equal distances from end to end",
                                    integer(2)),
}};

/// What only the keys together tell.
void check_path(Reader& reader, const Place& at, const PathSampling& path) {
  const Node* points = at.node().find("points");
  const Node* file = at.node().find("file");
  const Node* step = at.node().find("step");
  const Node* count = at.node().find("count");
  if (points && file)
    reader.error_within(at, file->mark, "file",
                        "the waypoints are given by 'points' already; keep one");
  else if (!points && !file && at.node().kind == Node::Kind::map)
    reader.error(at, "there are no waypoints; give points or file");
  else if (path.waypoints.size() < 2)
    reader.error(at, "a path has two waypoints or more");
  else if ((step || count) &&
           std::all_of(path.waypoints.begin(), path.waypoints.end(),
                       [&](const auto& p) { return p == path.waypoints.front(); }))
    reader.error(at, "has no length: all its waypoints are one");
  if (step && count)
    reader.error_within(at, count->mark, "count",
                        "the samples are given by 'step' already; keep one");
}

}  // namespace

std::vector<KeyShape> volume_keys() { return keys_of<kVolumeKeys>(); }
std::vector<KeyShape> plane_keys() { return keys_of<kPlaneKeys>(); }
std::vector<Shape> mesh_sample_forms() { return {text(), map<kMeshKeys>()}; }
std::vector<Shape> path_forms() { return {text(), map<kPathKeys>()}; }

std::optional<std::variant<VolumeSampling, AdaptiveSampling>> read_volume(
    Reader& reader, const Place& at) {
  const std::size_t before = reader.findings.errors();
  Volume volume;
  if (read_map(reader, at, kVolumeKeys, volume)) check_density(reader, at);
  if (reader.findings.errors() == before) check_box(reader, at, volume);
  if (reader.findings.errors() != before) return std::nullopt;
  if (volume.step) return VolumeSampling{volume.min, volume.max, *volume.step};
  volume.adaptive->min = volume.min;
  volume.adaptive->max = volume.max;
  return *volume.adaptive;
}

std::optional<MeshSampling> read_mesh_samples(Reader& reader, const Place& at) {
  const std::size_t before = reader.findings.errors();
  MeshShape mesh;
  const bool map = at.node().kind == Node::Kind::map;
  if (map)
    read_map(reader, at, kMeshKeys, mesh);
  else
    read_mesh_file(reader, at, mesh);
  if (reader.findings.errors() != before) return std::nullopt;
  check_mesh_size(reader, map ? Place(at, "file", *at.node().find("file")) : at, mesh);
  if (reader.findings.errors() != before) return std::nullopt;
  return MeshSampling{std::move(mesh)};
}

std::optional<PathSampling> read_path(Reader& reader, const Place& at) {
  const std::size_t before = reader.findings.errors();
  PathSampling path;
  if (at.node().kind == Node::Kind::map)
    read_map(reader, at, kPathKeys, path);
  else
    read_waypoints(reader, at, path);
  if (reader.findings.errors() == before) check_path(reader, at, path);
  if (reader.findings.errors() != before) return std::nullopt;
  return path;
}

std::optional<double> read_near_value(Reader& reader, const Place& at,
                                      std::string_view unit) {
  const auto value = reader.number(at, unit);
  if (!value || !reader.within(at, *value, kNear, unit)) return std::nullopt;
  return value;
}

std::optional<PlaneSampling> read_plane(Reader& reader, const Place& at) {
  const std::size_t before = reader.findings.errors();
  PlaneSampling plane{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {1, 1}};
  read_map(reader, at, kPlaneKeys, plane);
  if (reader.findings.errors() != before) return std::nullopt;
  return plane;
}

void check_reach(Reader& reader, const Place& at, const VolumeSampling& volume) {
  constexpr double kWorthSaying = 0.05;  // of the volume
  const Eigen::Vector3d extent = volume.max - volume.min;
  double reached = 1;
  std::string along, better;
  for (Eigen::Index i = 0; i < 3; ++i) {
    // As make_samples() counts; 4 digits, downwards, keep the count.
    const double steps = extent[i] / volume.step[i], whole = std::floor(steps + 1e-9);
    double step = volume.step[i];
    if (extent[i] > 0 && whole < steps * (1 - 1e-9)) {
      reached *= whole / steps;
      along += (along.empty() ? "" : ", ") + std::string(kAxes[i]) + " by " +
               rounded(extent[i] - whole * volume.step[i], 3) + " m";
      step = extent[i] / std::ceil(steps);
      const double unit = std::pow(10, std::floor(std::log10(step)) - 3);
      step = std::floor(step / unit * (1 + 1e-12)) * unit;
    }
    better += (i > 0 ? ", " : "[") + rounded(step, 4);
  }
  if (1 - reached < kWorthSaying) return;
  reader.warning(Place(at, "step", *at.node().find("step")),
                 "leaves " + rounded(100 * (1 - reached), 2) +
                     " % of the volume without samples: the last ones miss max along " +
                     along + "; " + better + "] reaches it");
}

Node write_volume(const VolumeSampling& volume) {
  return write_map(kVolumeKeys, Volume{volume.min, volume.max, volume.step, {}});
}
Node write_volume(const AdaptiveSampling& volume) {
  return write_map(kVolumeKeys, Volume{volume.min, volume.max, {}, volume});
}
Node write_plane(const PlaneSampling& plane) { return write_map(kPlaneKeys, plane); }
Node write_path(const PathSampling& path) {
  const bool whole = path.file.empty() || path.step || path.count;
  return whole ? write_map(kPathKeys, path) : to_node(path.file);
}
Node write_mesh_samples(const MeshSampling& mesh) {
  if (mesh.surface.scale == 1) return to_node(mesh.surface.file);
  return write_map(kMeshKeys, mesh.surface);
}

}  // namespace delos
