// Models of mrcal, .cameramodel: one camera, a mapping of Python, which is YAML too.
//
// intrinsics are f_x f_y c_x c_y and the coefficients in OpenCV's order; extrinsics are
// a Rodrigues vector and t that take the reference's points to the camera's.
#include "imports/formats.h"

namespace delos::imports {
namespace {

void read_mrcal(const Value& root, const ImportOptions& options, Source& source,
                Calibration& out) {
  CalibratedCamera c;
  c.name = "camera";
  c.line = root.line;
  const std::string model = text_or_empty(root, "lensmodel");
  struct Known {
    const char* name;
    std::size_t coefficients;
  };
  constexpr Known kKnown[] = {{"LENSMODEL_PINHOLE", 0},
                              {"LENSMODEL_OPENCV4", 4},
                              {"LENSMODEL_OPENCV5", 5},
                              {"LENSMODEL_OPENCV8", 8},
                              {"LENSMODEL_OPENCV12", 12}};
  const Known* known = nullptr;
  for (const Known& each : kKnown)
    if (model == each.name) known = &each;
  if (known == nullptr) {
    source.error(*root.find("lensmodel"),
                 "'" + model +
                     "' isn't a lens that Delos has: LENSMODEL_PINHOLE and "
                     "LENSMODEL_OPENCV4 to OPENCV8 are; mrcal-convert-lensmodel "
                     "makes one of the other");
    return;
  }
  const auto lens = numbers(root, "intrinsics", 4 + known->coefficients, source);
  const auto size = numbers(root, "imagersize", 2, source);
  // Named so from mrcal 2.5 on.
  const char* pose = root.find("rt_cam_ref") ? "rt_cam_ref" : "extrinsics";
  const auto rt = numbers(root, pose, 6, source);
  if (!lens || !size || !rt) return;
  const std::vector<double>& v = *lens;
  c.f = {v[0], v[1]};
  c.c = {v[2], v[3]};
  c.size = {(*size)[0], (*size)[1]};
  set_distortion(c, {v.begin() + 4, v.end()}, false, *root.find("intrinsics"), source);
  const Eigen::Map<const Eigen::Vector3d> r(rt->data()), t(rt->data() + 3);
  const double angle = r.norm();
  const Eigen::Matrix3d R = angle > 0
                                ? Eigen::AngleAxisd(angle, r / angle).toRotationMatrix()
                                : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
  c.X_WC = from_world_to_camera(R, options.unit.value_or(1) * t);
  out.facts.emplace_back(
      "places in m, in the frame of its reference; which way is up isn't in the file: "
      "z "
      "is taken");
  out.cameras.push_back(std::move(c));
}

}  // namespace

const CalibrationFormat kMrcal = {
    "camera of mrcal (.cameramodel)",
    [](const Value& root) { return root.find("lensmodel") != nullptr; }, read_mrcal};

}  // namespace delos::imports
