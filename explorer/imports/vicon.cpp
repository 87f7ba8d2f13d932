// Calibrations of Vicon, .xcp: XML.
//
// POSITION is a camera's centre in mm, ORIENTATION a quaternion x y z w that takes the
// world's axes to the camera's, which looks along +z.
#include <Eigen/Geometry>
#include <cmath>

#include "imports/formats.h"

namespace delos::imports {
namespace {

constexpr double kOfMillimetres = 1e-3;

/// The radial coefficients, normalised: VICON_RADIAL2 "ViconRadial2 cx cy k1 k2 k3", or
/// VICON_RADIAL "k1 k2" per squared pixel.
bool read_radial(const Value& frame, CalibratedCamera& out, Source& source) {
  if (const Value* second = frame.find("VICON_RADIAL2")) {
    Value numbers = *second;
    if (const auto word = numbers.text.find_first_of(" \t");
        numbers.text.starts_with("ViconRadial2") && word != std::string::npos)
      numbers.text.erase(0, word);
    const auto k = numbers_in(numbers);
    if (!k || k->size() != 5) {
      source.error(*second, "'VICON_RADIAL2' must be 'ViconRadial2 cx cy k1 k2 k3'");
      return false;
    }
    set_distortion(out, {(*k)[2], (*k)[3], 0, 0, (*k)[4]}, false, *second, source);
    return true;
  }
  if (frame.find("VICON_RADIAL") == nullptr) return true;
  const auto k = numbers(frame, "VICON_RADIAL", 2, source);
  if (!k) return false;
  const double f2 = out.f.x() * out.f.x();
  set_distortion(out, {(*k)[0] * f2, (*k)[1] * f2 * f2, 0, 0}, false, frame, source);
  return true;
}

void read_frame(const Value& camera, const Value& frame, const ImportOptions& options,
                Source& source, Calibration& out) {
  CalibratedCamera c;
  c.line = camera.line;
  for (const char* key : {"USERID", "DEVICEID", "LABEL", "NAME"})
    if (const std::string name = text_or_empty(camera, key); !name.empty())
      c.name = name;
  const auto size = numbers(camera, "SENSOR_SIZE", 2, source);
  const auto aspect = number_or(camera, "PIXEL_ASPECT_RATIO", 1, source);
  const auto focal = number(frame, "FOCAL_LENGTH", source);
  const auto middle = numbers(frame, "PRINCIPAL_POINT", 2, source);
  const auto q = numbers(frame, "ORIENTATION", 4, source);
  const auto at = numbers(frame, "POSITION", 3, source);
  if (!size || !aspect || !focal || !middle || !q || !at) return;
  const Eigen::Quaterniond world_to_camera((*q)[3], (*q)[0], (*q)[1], (*q)[2]);
  if (!(*aspect > 0) || !(std::abs(world_to_camera.norm() - 1) < 0.02)) {
    source.error(frame, "'" + c.name +
                            "' has an ORIENTATION that isn't of length 1, or "
                            "a PIXEL_ASPECT_RATIO that isn't above 0");
    return;
  }
  c.size = {(*size)[0], (*size)[1]};
  c.f = {*focal, *focal / *aspect};
  c.c = {(*middle)[0], (*middle)[1]};
  if (options.mirrored) c.c = c.size - c.c;
  if (!read_radial(frame, c, source)) return;
  const double unit = options.unit.value_or(kOfMillimetres);
  c.X_WC = Pose{world_to_camera.normalized().toRotationMatrix().transpose(),
                unit * Eigen::Vector3d((*at)[0], (*at)[1], (*at)[2])};
  const std::string error = text_or_empty(frame, "WORLD_ERROR");
  if (!error.empty()) c.residual = error + " (WORLD_ERROR)";
  out.cameras.push_back(std::move(c));
}

void read_vicon(const Value& root, const ImportOptions& options, Source& source,
                Calibration& out) {
  out.facts.emplace_back(
      "places in mm; z up, right-handed; quaternions x y z w, world to camera");
  out.facts.emplace_back(
      options.mirrored ? "principal points count from the opposite corner, as "
                         "--mirrored says"
                       : "principal points are as written; public readers disagree "
                         "whether they count from the opposite corner: hold a "
                         "marker's image against both, and see --mirrored");
  std::size_t without = 0, more = 0, video = 0;
  for (const auto& [name, camera] : root.find("Cameras")->members) {
    if (name != "Camera") continue;
    const Value* frames = camera.find("KeyFrames");
    const Value* frame = frames ? frames->find("KeyFrame") : nullptr;
    if (frame == nullptr || frame->find("POSITION") == nullptr) {
      ++without;
      continue;
    }
    std::size_t count = 0;
    for (const auto& member : frames->members) count += member.first == "KeyFrame";
    more += count > 1;
    const std::string type = text_or_empty(camera, "DISPLAY_TYPE");
    video += type.find("Vue") != std::string::npos ||
             type.find("Video") != std::string::npos;
    read_frame(camera, *frame, options, source, out);
  }
  if (without > 0)
    out.facts.push_back(std::to_string(without) + " without a KeyFrame left out");
  if (more > 0)
    out.facts.push_back(std::to_string(more) +
                        " with several KeyFrames: the first of each counts");
  if (video > 0)
    out.facts.push_back(std::to_string(video) +
                        " are video cameras, among those that track markers");
  for (const CalibratedCamera& camera : out.cameras)
    if (camera.k[0] != 0) {
      out.facts.emplace_back(
          "radial coefficients are taken as OpenCV's, as public readers do");
      break;
    }
}

}  // namespace

const CalibrationFormat kVicon = {
    "calibration of Vicon (.xcp)",
    [](const Value& root) {
      const Value* camera = root.find({"Cameras", "Camera"});
      return camera != nullptr && camera->find("SENSOR_SIZE") != nullptr;
    },
    read_vicon};

}  // namespace delos::imports
