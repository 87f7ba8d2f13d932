#include "session/drawn_field.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "delos/sampling/samples.h"
#include "output/write.h"
#include "session/packing.h"

namespace delos::session {
namespace {

/// Samples of the grid that an octree is drawn on.
constexpr std::size_t kOctreeSamples = 120'000;

VolumeSampling coarser_volume(const VolumeSampling& box, std::size_t most) {
  // A step that doesn't divide the box leaves a rest without samples.
  const Eigen::Vector3d last =
      ((box.max - box.min).cwiseQuotient(box.step).array() + 1e-9).floor();
  return grid_over(box.min, box.min + last.cwiseProduct(box.step), most);
}

Eigen::Vector2i coarser_counts(const Eigen::Vector2i& counts, std::size_t most) {
  const double part =
      std::sqrt(static_cast<double>(most) / counts.cast<double>().prod());
  return (counts.cast<double>() * part)
      .array()
      .floor()
      .max(2)
      .min(counts.cast<double>().array())
      .cast<int>();
}

std::size_t count_of(const std::vector<SampleSet>& sets) {
  std::size_t count = 0;
  for (const SampleSet& set : sets)
    count += static_cast<std::size_t>(sample_count(set));
  return count;
}

/// Adds what is particular to a shape.
struct ShapeJson {
  const Field& field;
  const SamplePart& part;
  Arrays& arrays;
  Json& json;

  void operator()(const GridShape& grid) const {
    json["kind"] = "grid";
    json["origin"] = numbers(grid.origin);
    json["step"] = numbers(grid.step);
    json["counts"] = {grid.counts(0), grid.counts(1), grid.counts(2)};
  }
  void operator()(const PlaneShape& plane) const {
    json["kind"] = "plane";
    json["origin"] = numbers(plane.origin);
    json["u"] = numbers(plane.u);
    json["v"] = numbers(plane.v);
    json["counts"] = {plane.counts(0), plane.counts(1)};
  }
  void operator()(const SurfaceShape& surface) const {
    points("surface");
    std::vector<std::uint32_t> corners;
    for (const auto& triangle : surface.triangles)
      corners.insert(corners.end(), triangle.begin(), triangle.end());
    json["triangles"] = arrays.add<std::uint32_t>(corners);
    json["corners"] = corners.size();
  }
  void operator()(const ScatteredShape&) const { points("points"); }
  void operator()(const OctreeShape&) const { points("points"); }

  void points(const char* kind) const {
    json["kind"] = kind;
    std::vector<double> places;
    for (std::size_t i = part.first; i < part.first + part.count; ++i)
      places.insert(places.end(), field.samples.points[i].begin(),
                    field.samples.points[i].end());
    json["positions"] = arrays.add<float>(places);
  }
};

std::size_t leaf_count(const DrawnField& drawn) {
  return drawn.leaves
             ? std::get<OctreeShape>(drawn.leaves->parts.front().shape).cells.size()
             : 0;
}

}  // namespace

VolumeSampling grid_over(const Eigen::Vector3d& min, const Eigen::Vector3d& max,
                         std::size_t most) {
  const Eigen::Array3d size = (max - min).array();
  const auto cells_at = [&](double step) {
    return (size / step).floor().max((size > 0).cast<double>()).eval();
  };
  double fine = size.maxCoeff() * 1e-4, rough = size.maxCoeff();
  for (int i = 0; i < 40 && rough > 0; ++i) {
    const double step = std::sqrt(fine * rough);
    ((cells_at(step) + 1).prod() > static_cast<double>(most) ? fine : rough) = step;
  }
  const Eigen::Array3d cells = rough > 0 ? cells_at(rough) : Eigen::Array3d::Ones();
  const Eigen::Array3d step = (size > 0).select(size / cells.max(1), 1.0);
  // Rounding must not lose the last layer.
  return {min, max + 1e-9 * step.matrix(), step.matrix()};
}

std::vector<SampleSet> coarser(std::vector<SampleSet> sets, std::size_t most) {
  const std::size_t each = std::max<std::size_t>(8, most / sets.size());
  for (SampleSet& set : sets) {
    const auto count = static_cast<std::size_t>(sample_count(set));
    if (const auto* box = std::get_if<AdaptiveSampling>(&set.shape))
      set.shape = grid_over(box->min, box->max, each);
    else if (const auto* grid = std::get_if<VolumeSampling>(&set.shape);
             grid && count > each)
      set.shape = coarser_volume(*grid, each);
    else if (auto* plane = std::get_if<PlaneSampling>(&set.shape);
             plane && count > each)
      plane->counts = coarser_counts(plane->counts, each);
  }
  return sets;
}

Samples drawn_samples(const Scene& scene, std::size_t most, bool& fewer) {
  fewer = most > 0 && count_of(scene.samples) > most;
  if (adaptive_sampling(scene))
    return make_samples(coarser(scene.samples, most > 0 ? most : kOctreeSamples));
  return make_samples(fewer ? coarser(scene.samples, most) : scene.samples);
}

std::vector<Drawn> drawn_as(const Field& field) {
  std::vector<Drawn> mask;
  mask.reserve(field.value.size());
  for (std::size_t i = 0; i < field.value.size(); ++i) {
    const bool inside = !field.inside.empty() && field.inside[i] != 0;
    mask.push_back(inside                          ? Drawn::inside
                   : std::isfinite(field.value[i]) ? Drawn::value
                                                   : Drawn::blind);
  }
  return mask;
}

DrawnField draw_field(const LoadedScene& loaded, std::size_t most,
                      const FieldOptions& options) {
  DrawnField drawn;
  const bool adaptive = adaptive_sampling(loaded.scene) != nullptr;
  if (most > 0 && (adaptive || count_of(loaded.scene.samples) > most)) {
    drawn.field =
        evaluate_field(loaded.system, make_samples(coarser(loaded.scene.samples, most)),
                       loaded.scene.orientations, loaded.metric, options);
    drawn.field.scene = loaded.scene.name;
    drawn.summary = field_answer(loaded, drawn.field);
    drawn.coarse = true;
    drawn.mask = drawn_as(drawn.field);
    return drawn;
  }
  return drawn_of(loaded, evaluate_scene(loaded, options));
}

DrawnField drawn_of(const LoadedScene& loaded, Evaluation evaluation) {
  DrawnField drawn;
  drawn.summary = field_answer(loaded, evaluation.field);
  if (evaluation.octree) {
    drawn.field = evaluation.octree->read(
        make_samples(coarser(loaded.scene.samples, kOctreeSamples)),
        ShadowEdges::exact);
    drawn.leaves = std::make_shared<const Samples>(std::move(evaluation.field.samples));
  } else {
    drawn.field = std::move(evaluation.field);
  }
  drawn.mask = drawn_as(drawn.field);
  return drawn;
}

DrawnField drawn_over(Field field) {
  DrawnField drawn;
  drawn.summary = Json::parse(field_json(field));
  drawn.mask = drawn_as(field);
  drawn.field = std::move(field);
  return drawn;
}

std::string packed(const DrawnField& drawn, std::size_t revision) {
  const Field& field = drawn.field;
  Arrays arrays;
  std::vector<double> values = field.value;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (drawn.mask[i] != Drawn::value)
      values[i] = std::numeric_limits<double>::quiet_NaN();
  Json head{{"revision", revision},
            {"level", drawn.coarse ? "coarse" : "full"},
            {"larger_is_better", field.larger_is_better},
            {"definition", to_string(field.definition)},
            {"summary", drawn.summary},
            {"leaves", leaf_count(drawn)}};
  head["values"] = {{"at", arrays.add<float>(values)}, {"count", values.size()}};
  head["mask"] = {{"at", arrays.add<unsigned char>(drawn.mask)},
                  {"count", drawn.mask.size()}};
  head["parts"] = Json::array();
  for (const SamplePart& part : field.samples.parts) {
    Json json{{"name", part.name}, {"first", part.first}, {"count", part.count}};
    std::visit(ShapeJson{field, part, arrays, json}, part.shape);
    head["parts"].push_back(std::move(json));
  }
  return packed_text("DLF1", head, arrays);
}

}  // namespace delos::session
