#include "session/written_field.h"

#include <algorithm>
#include <cmath>

#include "delos/model/infinity.h"
#include "delos/text/format.h"
#include "session/stored_field.h"

namespace delos::session {
namespace {

bool is_picture(const std::filesystem::path& file) {
  const std::string suffix = file.extension().string();
  return suffix == ".png" || suffix == ".PNG";
}

/// A level plane through an adaptive volume, fine enough for a picture.
Samples level_plane(const AdaptiveSampling& box, double z) {
  constexpr double kMost = 320;  // samples along the longer side
  const Eigen::Vector3d size = box.max - box.min;
  const double step = std::max(size.x(), size.y()) / kMost;
  const auto count = [step](double length) {
    return static_cast<int>(std::lround(length / step)) + 1;
  };
  return make_samples({{"", PlaneSampling{{box.min.x(), box.min.y(), z},
                                          {size.x(), 0, 0},
                                          {0, size.y(), 0},
                                          {count(size.x()), count(size.y())}}}});
}

/// The slice that is asked for, or that through the best sample.
double slice_height(const Field& field, const AdaptiveSampling& box,
                    const PictureOptions& picture) {
  const FieldStatistics s = summarize(field);
  const double z = picture.has_slice ? picture.slice_z : s.best().at.z();
  return std::clamp(z, box.min.z(), box.max.z());
}

}  // namespace

Samples planned_samples(const Scene& scene) {
  if (!adaptive_sampling(scene)) return make_samples(scene.samples);
  Samples samples;
  samples.parts.push_back({"", 0, 0, OctreeShape{}});
  return samples;
}

std::string missed_by_slice(const Scene& scene, const Samples& samples, double z) {
  double least = kInfinity, greatest = -kInfinity;
  if (const AdaptiveSampling* box = adaptive_sampling(scene)) {
    least = box->min.z();
    greatest = box->max.z();
  }
  for (const Eigen::Vector3d& p : samples.points) {
    least = std::min(least, p.z());
    greatest = std::max(greatest, p.z());
  }
  const double rounding = 1e-9 * std::max(std::abs(least), std::abs(greatest));
  if (z >= least - rounding && z <= greatest + rounding) return "";
  return "the field reaches from z = " + format_quantity(least, "m") + " to " +
         format_quantity(greatest, "m");
}

bool is_scene(const std::filesystem::path& file) {
  const std::string suffix = file.extension().string();
  return suffix == ".yaml" || suffix == ".yml";
}

std::string drawable(const Scene& scene, const Samples& samples,
                     const std::filesystem::path& file) {
  if (is_stored_field(file)) return "";
  const AdaptiveSampling* box = adaptive_sampling(scene);
  return box && is_picture(file) ? writable(level_plane(*box, box->min.z()), file)
                                 : writable(samples, file);
}

Field picture_field(const Evaluation& evaluation, const Scene& scene,
                    const PictureOptions& picture) {
  const AdaptiveSampling* box = adaptive_sampling(scene);
  if (!box || !evaluation.octree) return evaluation.field;
  Field slice = evaluation.octree->read(
      level_plane(*box, slice_height(evaluation.field, *box, picture)),
      ShadowEdges::exact);
  slice.scene = evaluation.field.scene;
  return slice;
}

std::string write_evaluation(const Evaluation& evaluation, const Scene& scene,
                             const std::filesystem::path& file,
                             const PictureOptions& picture) {
  if (is_stored_field(file))
    return store_field(evaluation.field, picture.devices, file);
  if (!is_picture(file)) return write_field(evaluation.field, file, picture);
  PictureOptions of_part = picture;
  of_part.whole = summarize(evaluation.field);
  return write_field(picture_field(evaluation, scene, picture), file, of_part);
}

}  // namespace delos::session
