#include "scene/sample_keys.h"

#include <algorithm>
#include <set>

#include "delos/sampling/samples.h"
#include "document/node_text.h"
#include "scene/point_file.h"
#include "scene/sample_limit.h"
#include "scene/sample_shapes.h"
#include "scene/words.h"

namespace delos {
namespace {

using namespace shapes;
using Written = std::optional<Node>;

// ---- orientations ----

constexpr std::array<Key<Orientations>, 2> kOrientationKeys = {{
    {"rpy", Need::optional,
     "target orientations tried at each point, [[roll, pitch, yaw], …]",
     list([] { return vector("rad"); }, 1),
     [](Reader& r, const Place& p, Orientations& o) {
       if (auto rpy = r.vectors3(p, "rad", kAngles)) o.rpy = std::move(*rpy);
     },
     [](const Orientations& o) -> Written { return to_node(o.rpy); }},
    {"combine", Need::optional, "how they become one value: worst, mean or information",
     choice<kOrientationRuleWords>(),
     [](Reader& r, const Place& p, Orientations& o) {
       if (const auto rule = r.choice(p, kOrientationRuleWords)) o.combine = *rule;
     },
     [](const Orientations& o) -> Written {
       return to_node(word_of(kOrientationRuleWords, o.combine));
     }},
}};

// ---- one set ----

/// A set as its keys say it; orientations stand beside the shape of a single set.
struct SampleSetDraft {
  SampleSet set;
  bool complete = false;  ///< its shape was read without findings
  bool single = false;    ///< `sample` is this mapping, not a list
  std::optional<Orientations> orientations;
};

void read_volume_set(Reader& reader, const Place& at, SampleSetDraft& out) {
  const auto volume = read_volume(reader, at);
  out.complete = volume.has_value();
  if (!volume) return;
  std::visit([&](const auto& shape) { out.set.shape = shape; }, *volume);
  if (const auto* grid = std::get_if<VolumeSampling>(&*volume))
    check_reach(reader, at, *grid);
}

void read_plane_set(Reader& reader, const Place& at, SampleSetDraft& out) {
  const auto plane = read_plane(reader, at);
  out.complete = plane.has_value();
  if (plane) out.set.shape = *plane;
}

void read_mesh_set(Reader& reader, const Place& at, SampleSetDraft& out) {
  auto mesh = read_mesh_samples(reader, at);
  out.complete = mesh.has_value();
  if (mesh) out.set.shape = std::move(*mesh);
}

void read_points(Reader& reader, const Place& at, SampleSetDraft& out) {
  auto points = reader.vectors3(at, "m");
  if (!points) return;
  out.set.shape = PointSampling{{}, std::move(*points)};
  out.complete = true;
}

void read_file(Reader& reader, const Place& at, SampleSetDraft& out) {
  const auto written = reader.word(at);
  if (!written) return;
  PointSampling points{reader.file_name(at, *written), {}};
  const auto rows =
      read_row_file(reader, at, points.file, {{"x", "y", "z"}, {3}}, "points");
  if (!rows) return;
  for (const auto& row : *rows) points.points.emplace_back(row[0], row[1], row[2]);
  out.set.shape = std::move(points);
  out.complete = true;
}

constexpr std::array<Key<SampleSetDraft>, 8> kSampleSetKeys = {{
    {"name", Need::optional, "name of the set", name(),
     [](Reader& r, const Place& p, SampleSetDraft& d) {
       if (auto name = r.name(p)) d.set.name = std::move(*name);
     },
     [](const SampleSetDraft& d) -> Written {
       if (d.set.name.empty()) return std::nullopt;
       return to_node(d.set.name);
     }},
    {"volume", Need::optional, "samples in a box", map(volume_keys), read_volume_set,
     [](const SampleSetDraft& d) -> Written {
       if (const auto* v = std::get_if<VolumeSampling>(&d.set.shape))
         return write_volume(*v);
       if (const auto* v = std::get_if<AdaptiveSampling>(&d.set.shape))
         return write_volume(*v);
       return std::nullopt;
     }},
    {"plane", Need::optional, "samples on a parallelogram", map(plane_keys),
     read_plane_set,
     [](const SampleSetDraft& d) -> Written {
       const auto* p = std::get_if<PlaneSampling>(&d.set.shape);
       if (!p) return std::nullopt;
       return write_plane(*p);
     }},
    {"points", Need::optional, "given points [[x, y, z], …], metres", points(),
     read_points,
     [](const SampleSetDraft& d) -> Written {
       const auto* p = std::get_if<PointSampling>(&d.set.shape);
       if (!p || !p->file.empty()) return std::nullopt;
       return to_node(p->points);
     }},
    {"file", Need::optional, "points in a .ptl or .csv file, relative to the scene",
     text(), read_file,
     [](const SampleSetDraft& d) -> Written {
       const auto* p = std::get_if<PointSampling>(&d.set.shape);
       if (!p || p->file.empty()) return std::nullopt;
       return to_node(p->file);
     }},
    {"mesh", Need::optional, "vertices of a mesh: a file, or file and scale",
     either(mesh_sample_forms), read_mesh_set,
     [](const SampleSetDraft& d) -> Written {
       const auto* m = std::get_if<MeshSampling>(&d.set.shape);
       if (!m) return std::nullopt;
       return write_mesh_samples(*m);
     }},
    {"path", Need::optional,
     "samples along a line through waypoints: a file, or points, step, count",
     either(path_forms),
     [](Reader& r, const Place& p, SampleSetDraft& d) {
       auto path = read_path(r, p);
       d.complete = path.has_value();
       if (path) d.set.shape = std::move(*path);
     },
     [](const SampleSetDraft& d) -> Written {
       const auto* path = std::get_if<PathSampling>(&d.set.shape);
       if (!path) return std::nullopt;
       return write_path(*path);
     }},
    {"orientations", Need::optional, "target orientations tried at each point",
     map(orientation_keys),
     [](Reader& r, const Place& p, SampleSetDraft& d) {
       if (!d.single)
         r.error(p, "orientations hold for all sets; put them beside 'sample'");
       else
         read_orientations(r, p, d.orientations.emplace());
     },
     [](const SampleSetDraft& d) -> Written {
       if (!d.orientations) return std::nullopt;
       return write_map(kOrientationKeys, *d.orientations);
     }},
}};

/// Exactly one key says which shape a set has.
bool check_one_shape(Reader& reader, const Place& at) {
  const std::vector<std::string> shapes = {"volume", "plane", "points",
                                           "file",   "mesh",  "path"};
  std::string given;
  bool one = true;
  for (const std::string& shape : shapes) {
    const Node* node = at.node().find(shape);
    if (!node) continue;
    if (!given.empty()) {
      reader.error_within(
          at, node->mark, shape,
          "the set is given by '" + given + "' already; make a list of sets");
      one = false;
    }
    given = shape;
  }
  if (!given.empty()) return one;
  reader.error(at, "nothing to sample; give volume, plane, points, file, path or mesh");
  return false;
}

/// Where to report that a set is too large: at what makes it so.
void report_too_many(Reader& reader, const Place& at, const SampleSet& set) {
  const std::string problem = too_many_samples(set, kMostSamples);
  const auto within = [&](const char* shape, const char* key) {
    const Node& node = *at.node().find(shape);
    const Place place(at, shape, node);
    if (key)
      reader.error(Place(place, key, *node.find(key)), problem);
    else
      reader.error(place, problem);
  };
  if (std::holds_alternative<VolumeSampling>(set.shape))
    return within("volume", "step");
  if (std::holds_alternative<PlaneSampling>(set.shape))
    return within("plane", "counts");
  if (std::holds_alternative<MeshSampling>(set.shape)) return within("mesh", nullptr);
  if (const auto* path = std::get_if<PathSampling>(&set.shape))
    return within("path", path->step ? "step" : path->count ? "count" : nullptr);
  within(std::get<PointSampling>(set.shape).file.empty() ? "points" : "file", nullptr);
}

/// Read one set. @returns its samples, 0 where it has findings or is adaptive.
std::int64_t read_set(Reader& reader, const Place& at, bool single, Scene& out) {
  SampleSetDraft draft;
  draft.single = single;
  if (!read_map(reader, at, kSampleSetKeys, draft)) return 0;
  if (draft.orientations) out.orientations = std::move(*draft.orientations);
  if (!check_one_shape(reader, at) || !draft.complete) return 0;
  const std::int64_t count = sample_count(draft.set);
  if (count > kMostSamples) {
    report_too_many(reader, at, draft.set);
    return 0;
  }
  out.samples.push_back(std::move(draft.set));
  return count;
}

/// The node of a set's `volume.adaptive`, with its place; nothing where it has none.
template <class Use>
void with_adaptive(const Place& set, const Use& use) {
  const Node* volume = set.node().find("volume");
  const Node* adaptive = volume ? volume->find("adaptive") : nullptr;
  if (!adaptive) return;
  const Place place(set, "volume", *volume);
  use(Place(place, "adaptive", *adaptive));
}

bool stand_in_set(const Scene& scene) { return scene.samples.size() == 1; }

Shape sample_set_shape() { return map<kSampleSetKeys>(); }

}  // namespace

std::vector<KeyShape> orientation_keys() { return keys_of<kOrientationKeys>(); }
std::vector<Shape> sample_forms() {
  return {sample_set_shape(), list(sample_set_shape, 1)};
}

void read_orientations(Reader& reader, const Place& at, Orientations& out) {
  read_map(reader, at, kOrientationKeys, out);
}

void read_samples(Reader& reader, const Place& at, Scene& out) {
  const Node& node = at.node();
  if (node.kind != Node::Kind::list) {
    read_set(reader, at, true, out);
    return;
  }
  if (node.items.empty()) reader.error(at, "the list is empty; give at least one set");
  std::int64_t total = 0;
  std::set<std::string> names;
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    const Place place(at, member_name(node.items[i], i), node.items[i]);
    total += read_set(reader, place, false, out);
    if (node.items.size() > 1)
      with_adaptive(place, [&](const Place& adaptive) {
        reader.error(adaptive,
                     "must be the only set of its scene; keep this set alone, or give "
                     "it a step");
      });
    const Node* name = node.items[i].find("name");
    if (name && name->kind == Node::Kind::scalar && !names.insert(name->text).second)
      reader.error_within(place, name->mark, "name",
                          '\'' + name->text + "' is another set's name already");
  }
  if (total > kMostSamples)
    reader.error(at, too_many_samples(total, kMostSamples) + ": make the sets coarser");
}

void read_near(Reader& reader, const Place& at, std::string_view unit, Scene& out) {
  const auto read = [&](const Place& set) {
    with_adaptive(set, [&](const Place& adaptive) {
      const Node* near = adaptive.node().find("near");
      if (!near || near->kind == Node::Kind::null) return;
      const auto value = read_near_value(reader, Place(adaptive, "near", *near), unit);
      if (!value || out.samples.empty()) return;
      if (auto* a = std::get_if<AdaptiveSampling>(&out.samples.front().shape))
        a->near_value = value;
    });
  };
  const Node& node = at.node();
  if (node.kind != Node::Kind::list) return read(at);
  for (std::size_t i = 0; i < node.items.size(); ++i)
    read(Place(at, member_name(node.items[i], i), node.items[i]));
}

Node write_samples(const Scene& scene) {
  std::vector<Node> sets;
  for (const SampleSet& set : scene.samples) {
    SampleSetDraft draft{set, true, stand_in_set(scene), std::nullopt};
    if (draft.single && scene.orientations != Orientations{})
      draft.orientations = scene.orientations;
    sets.push_back(write_map(kSampleSetKeys, draft));
  }
  if (stand_in_set(scene)) return std::move(sets.front());
  return to_node(std::move(sets));
}

std::optional<Node> write_orientations(const Scene& scene) {
  if (stand_in_set(scene) || scene.orientations == Orientations{}) return std::nullopt;
  return write_map(kOrientationKeys, scene.orientations);
}

}  // namespace delos
