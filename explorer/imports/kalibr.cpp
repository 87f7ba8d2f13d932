// Chains of cameras by Kalibr, camchain.yaml: YAML.
//
// intrinsics are f_x f_y c_x c_y; T_cn_cnm1 takes points of the camera before to this
// one, T_cam_imu points of the IMU to the camera. The world is the IMU, or else the
// first camera.
#include "imports/formats.h"

namespace delos::imports {
namespace {

/// A pose of 4×4 numbers.
std::optional<Pose> pose_in(const Value& map, std::string_view name, double unit,
                            Source& source) {
  const auto T = numbers(map, name, 16, source);
  if (!T) return std::nullopt;
  const std::vector<double>& m = *T;
  const auto R = rotation_of({m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]},
                             *map.find(name), source);
  if (!R) return std::nullopt;
  return Pose{*R, unit * Eigen::Vector3d(m[3], m[7], m[11])};
}

void read_kalibr_lens(const Value& camera, CalibratedCamera& c, Source& source) {
  const std::string model = text_or_empty(camera, "camera_model"),
                    bend = text_or_empty(camera, "distortion_model");
  if (model != "pinhole" && !model.empty()) {
    source.error(*camera.find("camera_model"),
                 "'" + c.name + "' is of the model '" + model +
                     "', which Delos doesn't have; calibrate it as pinhole-equi, or "
                     "pinhole-radtan");
    return;
  }
  const auto f = numbers(camera, "intrinsics", 4, source);
  const auto size = numbers(camera, "resolution", 2, source);
  if (!f || !size) return;
  c.f = {(*f)[0], (*f)[1]};
  c.c = {(*f)[2], (*f)[3]};
  c.size = {(*size)[0], (*size)[1]};
  if (bend == "none") return;
  if (bend != "radtan" && bend != "equidistant") {
    source.error(camera, "'" + c.name + "' is distorted as '" + bend +
                             "', which Delos doesn't know: radtan and equidistant are");
    return;
  }
  if (const auto k = numbers(camera, "distortion_coeffs", 4, source))
    set_distortion(c, *k, bend == "equidistant", *camera.find("distortion_coeffs"),
                   source);
}

void read_kalibr(const Value& root, const ImportOptions& options, Source& source,
                 Calibration& out) {
  const double unit = options.unit.value_or(1);
  const bool imu = root.find({"cam0", "T_cam_imu"}) != nullptr;
  out.up = imu ? "z" : "-y";
  out.facts.emplace_back(
      imu ? "places in m, in the frame of the IMU, whose z is taken to be up"
          : "places in m, in the frame of cam0, which is taken to be level");
  std::optional<Pose> before = Pose{};
  for (const auto& [name, camera] : root.members) {
    if (!name.starts_with("cam") || camera.find("intrinsics") == nullptr) continue;
    CalibratedCamera c;
    c.name = name;
    c.line = camera.line;
    read_kalibr_lens(camera, c, source);
    if (imu) {
      const auto T = pose_in(camera, "T_cam_imu", unit, source);
      if (T) c.X_WC = T->inverse();
    } else if (out.cameras.empty()) {
      c.X_WC = Pose{};
    } else if (before) {
      // X_WC = X_WB X_BC, where T_cn_cnm1 is X_CB of the camera before, B.
      const auto T = pose_in(camera, "T_cn_cnm1", unit, source);
      if (T) c.X_WC = *before * T->inverse();
    }
    before = c.X_WC;
    out.cameras.push_back(std::move(c));
  }
}

}  // namespace

const CalibrationFormat kKalibr = {
    "chain of cameras by Kalibr (camchain.yaml)",
    [](const Value& root) {
      return root.find({"cam0", "intrinsics"}) != nullptr;
    },
    read_kalibr};

}  // namespace delos::imports
