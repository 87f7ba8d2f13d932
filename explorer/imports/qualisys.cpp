// Calibrations of Qualisys Track Manager, .qca.txt: XML.
//
// Focal lengths, the principal point and the sensor's limits are in 1/64 px; a camera's
// place is in mm; the rows of r are its axes in the world, x right, y up, z backward:
// p_C = diag(1, −1, −1) r (p_W − t).
#include <cmath>

#include "imports/formats.h"

namespace delos::imports {
namespace {

constexpr double kSubpixels = 64, kMillimetre = 1e-3;

/// The part of the sensor that is read, pixels, and whether lengths are in 1/64 px as
/// its limits say.
bool read_image(const Value& camera, const Value& lens, CalibratedCamera& out,
                Eigen::Vector2d& corner, Source& source) {
  const Value* view = camera.find("fov_marker");
  const auto max_u = number(lens, "sensorMaxU", source),
             max_v = number(lens, "sensorMaxV", source);
  if (!max_u || !max_v) return false;
  if (view == nullptr) {
    out.size = {*max_u / kSubpixels + 1, *max_v / kSubpixels + 1};
    return true;
  }
  const auto left = number(*view, "left", source),
             right = number(*view, "right", source), top = number(*view, "top", source),
             bottom = number(*view, "bottom", source);
  if (!left || !right || !top || !bottom) return false;
  out.size = {*right - *left + 1, *bottom - *top + 1};
  corner = {*left, *top};
  if (*max_u < 2 * (*right + 1)) {
    source.error(lens, "'sensorMaxU' is " + text_or_empty(lens, "sensorMaxU") +
                           " where the image ends at pixel " +
                           text_or_empty(*view, "right") +
                           ": its lens is in pixels, as Theia writes it, and not in "
                           "1/64 px; export the calibration from QTM");
    return false;
  }
  return true;
}

void read_camera(const Value& camera, double unit, Source& source, Calibration& out) {
  CalibratedCamera c;
  c.name = text_or_empty(camera, "serial");
  c.line = camera.line;
  const Value* pose = camera.find("transform");
  const Value* lens = camera.find("intrinsic");
  if (pose == nullptr || lens == nullptr) {
    source.error(camera, "camera '" + c.name + "' lacks its " +
                             (pose ? "intrinsic" : "transform"));
    return;
  }
  Eigen::Vector2d corner = Eigen::Vector2d::Zero();
  if (!read_image(camera, *lens, c, corner, source)) return;
  std::vector<double> r, t, k;
  bool whole = true;
  const auto take = [&](const Value& from, const std::string& name,
                        std::vector<double>& to) {
    const auto value = number(from, name, source);
    whole = whole && value;
    to.push_back(value.value_or(0));
  };
  for (const char* row : {"1", "2", "3"})
    for (const char* column : {"1", "2", "3"})
      take(*pose, std::string("r") + row + column, r);
  for (const char* axis : {"x", "y", "z"}) take(*pose, axis, t);
  // "tangental" is how QTM spells it.
  for (const char* name :
       {"radialDistortion1", "radialDistortion2", "tangentalDistortion1",
        "tangentalDistortion2", "radialDistortion3"})
    take(*lens, name, k);
  std::vector<double> pixels;
  for (const char* name :
       {"focalLengthU", "focalLengthV", "centerPointU", "centerPointV"})
    take(*lens, name, pixels);
  const auto skew = number_or(*lens, "skew", 0, source);
  const auto R = whole ? rotation_of(r, *pose, source) : std::nullopt;
  if (!R || !skew) return;
  c.f = Eigen::Vector2d(pixels[0], pixels[1]) / kSubpixels;
  c.c = Eigen::Vector2d(pixels[2], pixels[3]) / kSubpixels - corner;
  c.skew = *skew / kSubpixels;
  set_distortion(c, k, false, *lens, source);
  const Eigen::Matrix3d R_CW = Eigen::Vector3d(1, -1, -1).asDiagonal() * *R;
  c.X_WC = Pose{R_CW.transpose(), unit * Eigen::Vector3d(t[0], t[1], t[2])};
  const std::string residual = text_or_empty(camera, "avg-residual");
  if (!residual.empty()) c.residual = residual + " (avg-residual)";
  out.cameras.push_back(std::move(c));
}

void read_qualisys(const Value& root, const ImportOptions& options, Source& source,
                   Calibration& out) {
  const double unit = options.unit.value_or(kMillimetre);
  out.facts.emplace_back(
      "places in mm, lenses in 1/64 px; z up, right-handed; a camera's axes in its "
      "file "
      "are x right, y up, z backward");
  bool turned = false;
  for (const auto& [name, camera] : root.find({"calibration", "cameras"})->members) {
    if (name != "camera") continue;
    if (text_or_empty(camera, "active") == "0") {
      out.facts.push_back("'" + text_or_empty(camera, "serial") +
                          "' isn't active, and left out");
      continue;
    }
    const std::string rotation = text_or_empty(camera, "viewrotation");
    turned = turned || (!rotation.empty() && rotation != "0");
    read_camera(camera, unit, source, out);
  }
  if (turned)
    out.facts.emplace_back(
        "viewrotation turns what QTM shows, not the sensor: it isn't read");
}

}  // namespace

const CalibrationFormat kQualisys = {
    "calibration of Qualisys Track Manager (.qca.txt)",
    [](const Value& root) {
      return root.find({"calibration", "cameras"}) != nullptr;
    },
    read_qualisys};

}  // namespace delos::imports
