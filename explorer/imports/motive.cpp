// Calibrations of OptiTrack Motive from 3.2 on, .mcal: XML in UTF-16.
//
// A camera's centre is in metres, y up; OrientMatrix takes its axes, x right, y up, z
// backward, to the world's. k1 to k3 take what is distorted to what isn't:
//
//   r_u = r_d (1 + k1 r_d² + k2 r_d⁴ + k3 r_d⁶)
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "delos/text/units.h"
#include "imports/formats.h"

namespace delos::imports {
namespace {

/// The way back, from what isn't distorted to what is, which a rational model comes
/// near to: with s = r_u² and g = r_d/r_u, (1 + a₁ s + a₂ s² + a₃ s³)/(1 + b₁ s + b₂ s²
/// + b₃ s³) = g is linear in a and b. Radii beyond the corner are left out.
/// @param corner the greatest r_d, normalised
/// @returns the greatest error, normalised; NaN where the model has no way back
double invert_radial(const std::array<double, 3>& k, double corner,
                     CalibratedCamera& out) {
  constexpr int kSamples = 200;
  Eigen::MatrixXd A(kSamples, 6);
  Eigen::VectorXd y(kSamples), radius(kSamples);
  double before = 0;
  for (int i = 0; i < kSamples; ++i) {
    const double r = corner * (i + 1) / kSamples, s = r * r;
    radius(i) = r * (1 + s * (k[0] + s * (k[1] + s * k[2])));
    if (!(radius(i) > before)) return NAN;
    before = radius(i);
  }
  const double scale = radius(kSamples - 1);  // so that columns are alike
  for (int i = 0; i < kSamples; ++i) {
    const double s = std::pow(radius(i) / scale, 2);
    const double g = corner * (i + 1) / kSamples / radius(i);
    A.row(i) << s, s * s, s * s * s, -g * s, -g * s * s, -g * s * s * s;
    y(i) = g - 1;
  }
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> fit;
  fit.setThreshold(1e-13);
  const Eigen::VectorXd x = fit.compute(A).solve(y);
  double worst = 0;
  for (int i = 0; i < kSamples; ++i) {
    const double s = std::pow(radius(i) / scale, 2);
    const double g = (1 + s * (x(0) + s * (x(1) + s * x(2)))) /
                     (1 + s * (x(3) + s * (x(4) + s * x(5))));
    worst = std::max(worst, std::abs(radius(i) * g - corner * (i + 1) / kSamples));
  }
  out.lens = Lens::rational;
  for (int i = 0; i < 6; ++i)
    out.k[static_cast<std::size_t>(i)] = x(i) / std::pow(scale, 2 * (i % 3 + 1));
  return worst;
}

void read_lens(const Value& lens, CalibratedCamera& c, double& worst, Source& source) {
  const auto k1 = number_or(lens, "k1", 0, source),
             k2 = number_or(lens, "k2", 0, source),
             k3 = number_or(lens, "k3", 0, source),
             across = number_or(lens, "TangentialX", 0, source),
             down = number_or(lens, "TangentialY", 0, source);
  if (!k1 || !k2 || !k3 || !across || !down) return;
  if (*across != 0 || *down != 0)
    source.warning(lens, "'" + c.name +
                             "' has tangential distortion, which is left "
                             "out: its axes aren't documented");
  if (*k1 == 0 && *k2 == 0 && *k3 == 0) return;
  if (!(c.f.array() > 0).all()) return;  // told by check()
  const double corner = std::hypot(std::max(c.c.x(), c.size.x() - c.c.x()) / c.f.x(),
                                   std::max(c.c.y(), c.size.y() - c.c.y()) / c.f.y());
  const double error = invert_radial({*k1, *k2, *k3}, corner, c) * c.f.maxCoeff();
  if (std::isfinite(error)) {
    worst = std::max(worst, error);
  } else {
    source.error(lens, "'" + c.name +
                           "' has coefficients that fold its image before "
                           "its corner");
  }
}

void read_motive(const Value& root, const ImportOptions& options, Source& source,
                 Calibration& out) {
  const double unit = options.unit.value_or(1);
  out.up = "y";
  out.facts.emplace_back(
      "places in m; right-handed, y up; a camera looks along its -z");
  double worst = 0;
  for (const auto& [name, camera] :
       root.find({"calibrationProfile", "Calibration", "Cameras"})->members) {
    if (name != "Camera") continue;
    CalibratedCamera c;
    c.name = text_or_empty(camera, "Serial");
    c.line = camera.line;
    const Value* image = camera.find("Attributes");
    const Value* lens = camera.find("Intrinsic");
    const Value* pose = camera.find("Extrinsic");
    if (image == nullptr || lens == nullptr || pose == nullptr) {
      source.error(camera, "camera '" + c.name +
                               "' lacks Attributes, Intrinsic or "
                               "Extrinsic; is the file cut off?");
      continue;
    }
    bool whole = true;
    const auto take = [&](const Value& from, const std::string& key) {
      const auto value = number(from, key, source);
      whole = whole && value;
      return value.value_or(0);
    };
    c.size = {take(*image, "ImagerPixelWidth"), take(*image, "ImagerPixelHeight")};
    c.f = {take(*lens, "HorizontalFocalLength"), take(*lens, "VerticalFocalLength")};
    c.c = {take(*lens, "LensCenterX"), take(*lens, "LensCenterY")};
    const Eigen::Vector3d at(take(*pose, "X"), take(*pose, "Y"), take(*pose, "Z"));
    std::vector<double> m;
    for (int i = 0; i < 9; ++i)
      m.push_back(take(*pose, "OrientMatrix" + std::to_string(i)));
    const auto R = whole ? rotation_of(m, *pose, source) : std::nullopt;
    if (!R) continue;
    c.X_WC = Pose{*R * Eigen::Vector3d(1, -1, -1).asDiagonal(), unit * at};
    read_lens(*lens, c, worst, source);
    out.cameras.push_back(std::move(c));
  }
  if (worst > 0) {
    char text[160];
    std::snprintf(text, sizeof text,
                  "Motive's k1 to k3 undistort; they were turned round by a rational "
                  "model, which is off by %.2g px at most",
                  worst);
    out.facts.emplace_back(text);
  }
}

}  // namespace

const CalibrationFormat kMotive = {
    "calibration of OptiTrack Motive (.mcal)",
    [](const Value& root) {
      return root.find({"calibrationProfile", "Calibration", "Cameras"}) != nullptr;
    },
    read_motive};

}  // namespace delos::imports
