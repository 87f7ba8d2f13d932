#include "scene/sample_shapes.h"

#include <limits>

#include "scene/node_text.h"

namespace delos {
namespace {

using Written = std::optional<Node>;

void read_vector(Reader& reader, const Place& at, Eigen::Vector3d& out) {
  if (const auto v = reader.vector3(at, "m")) out = *v;
}

/// One step for all axes, or a list of three.
void read_step(Reader& reader, const Place& at, VolumeSampling& out) {
  const bool list = at.node().kind == Node::Kind::list;
  const std::size_t before = reader.findings.errors();
  if (list) {
    read_vector(reader, at, out.step);
  } else if (const auto step = reader.number(at, "m")) {
    out.step.setConstant(*step);
  }
  if (reader.findings.errors() != before) return;
  for (std::size_t i = 0; i < (list ? 3 : 1); ++i) {
    if (out.step[static_cast<Eigen::Index>(i)] > 0) continue;
    constexpr const char* kProblem = "must be above 0";
    if (list)
      reader.error(Place(at, kAxes[i], at.node().items[i]), kProblem);
    else
      reader.error(at, kProblem);
  }
}

constexpr std::array<Key<VolumeSampling>, 4> kVolumeKeys = {{
    {"min", Need::required, "corner [x, y, z], metres",
     [](Reader& r, const Place& p, VolumeSampling& v) { read_vector(r, p, v.min); },
     [](const VolumeSampling& v) -> Written { return vector_node(v.min); }},
    {"max", Need::required, "opposite corner [x, y, z], metres",
     [](Reader& r, const Place& p, VolumeSampling& v) { read_vector(r, p, v.max); },
     [](const VolumeSampling& v) -> Written { return vector_node(v.max); }},
    {"step", Need::required, "distance of samples, metres: a number or [x, y, z]",
     read_step,
     [](const VolumeSampling& v) -> Written {
       if (v.step.x() == v.step.y() && v.step.y() == v.step.z())
         return to_node(v.step.x());
       return vector_node(v.step);
     }},
    {"adaptive", Need::later, "refinement where the field bends"},
}};

/// The corners must be in order, and the step must make a countable number of samples.
bool check_box(Reader& reader, const Place& at, const VolumeSampling& v) {
  bool good = true;
  const Place max(at, "max", *at.node().find("max"));
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    if (v.max[axis] >= v.min[axis]) continue;
    const Node& item = max.node().items[i];
    reader.error(Place(max, kAxes[i], item),
                 item.text + " is below min; exchange them");
    good = false;
  }
  // A number of steps that isn't a double leaves nothing to count or to suggest.
  if (((v.max - v.min).array() / v.step.array()).isFinite().all()) return good;
  reader.error(Place(at, "step", *at.node().find("step")), "is too small for this box");
  return false;
}

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
    {"origin", Need::required, "corner [x, y, z], metres",
     [](Reader& r, const Place& p, PlaneSampling& s) { read_vector(r, p, s.origin); },
     [](const PlaneSampling& s) -> Written { return vector_node(s.origin); }},
    {"u", Need::required, "first edge [x, y, z], metres",
     [](Reader& r, const Place& p, PlaneSampling& s) { read_vector(r, p, s.u); },
     [](const PlaneSampling& s) -> Written { return vector_node(s.u); }},
    {"v", Need::required, "second edge [x, y, z], metres",
     [](Reader& r, const Place& p, PlaneSampling& s) { read_vector(r, p, s.v); },
     [](const PlaneSampling& s) -> Written { return vector_node(s.v); }},
    {"counts", Need::required, "samples along u and v, [nu, nv]", read_counts,
     [](const PlaneSampling& s) -> Written {
       return to_node(std::vector<Node>{to_node(s.counts[0]), to_node(s.counts[1])});
     }},
}};

}  // namespace

std::optional<VolumeSampling> read_volume(Reader& reader, const Place& at) {
  const std::size_t before = reader.findings.errors();
  VolumeSampling volume{{0, 0, 0}, {0, 0, 0}, {1, 1, 1}};
  read_map(reader, at, kVolumeKeys, volume);
  if (reader.findings.errors() != before || !check_box(reader, at, volume))
    return std::nullopt;
  return volume;
}

std::optional<PlaneSampling> read_plane(Reader& reader, const Place& at) {
  const std::size_t before = reader.findings.errors();
  PlaneSampling plane{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {1, 1}};
  read_map(reader, at, kPlaneKeys, plane);
  if (reader.findings.errors() != before) return std::nullopt;
  return plane;
}

Node write_volume(const VolumeSampling& volume) {
  return write_map(kVolumeKeys, volume);
}
Node write_plane(const PlaneSampling& plane) { return write_map(kPlaneKeys, plane); }

}  // namespace delos
