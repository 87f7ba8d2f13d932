// What programs write with cv::FileStorage, YAML or XML, and camera_info of ROS, which
// looks like it: a camera's matrix, its coefficients, and a pose by whatever name.
#include "imports/formats.h"

namespace delos::imports {
namespace {

using Names = std::span<const std::string_view>;

/// The first of several names that is there; empty: none.
std::string_view first_of(const Value& map, Names names) {
  for (const std::string_view name : names)
    if (map.find(name) != nullptr) return name;
  return {};
}

constexpr std::string_view kMatrix[] = {
    "camera_matrix",    "cameraMatrix", "Camera_Matrix", "K",
    "intrinsic_matrix", "M1",           "cameraMatrix1"};
constexpr std::string_view kCoefficients[] = {"distortion_coefficients",
                                              "dist_coeffs",
                                              "distCoeffs",
                                              "Distortion_Coefficients",
                                              "dist",
                                              "D",
                                              "D1",
                                              "distCoeffs1"};
constexpr std::string_view kWidth[] = {"image_width", "image_Width", "imageWidth",
                                       "width"};
constexpr std::string_view kHeight[] = {"image_height", "image_Height", "imageHeight",
                                        "height"};
constexpr std::string_view kTurn[] = {"rvec", "rotation_vector", "R", "rotation",
                                      "rotation_matrix"};
constexpr std::string_view kWay[] = {"tvec", "translation_vector", "T", "t",
                                     "translation"};

/// What cv::FileStorage writes in XML stands in one element more.
const Value& storage(const Value& root) {
  const Value* inner = root.find("opencv_storage");
  return inner ? *inner : root;
}

void read_lens_of(const Value& map, std::string_view matrix, std::string_view bend,
                  bool fisheye, CalibratedCamera& c, Source& source) {
  const auto K = numbers(map, matrix, 9, source);
  if (K) set_matrix(c, *K, *map.find(matrix), source);
  if (!bend.empty()) {
    const auto k = numbers_in(*map.find(bend));
    if (k)
      set_distortion(c, *k, fisheye, *map.find(bend), source);
    else
      source.error(*map.find(bend), "'" + std::string(bend) + "' must be numbers");
  }
  const std::string_view width = first_of(map, kWidth), height = first_of(map, kHeight);
  if (width.empty() || height.empty()) return;
  const auto w = number(map, width, source), h = number(map, height, source);
  if (w && h) c.size = {*w, *h};
}

/// R and t by whatever name, from the world to the camera.
std::optional<Pose> pose_of_camera(const Value& map, double unit, Source& source) {
  const std::string_view turn = first_of(map, kTurn), way = first_of(map, kWay);
  if (turn.empty() || way.empty()) return std::nullopt;
  const auto R = rotation_in(map, turn, source);
  const auto t = numbers(map, way, 3, source);
  if (!R || !t) return std::nullopt;
  return from_world_to_camera(*R, unit * Eigen::Vector3d((*t)[0], (*t)[1], (*t)[2]));
}

/// A pair as cv::stereoCalibrate knows it: R and T take the first camera's points to
/// the second.
void read_pair(const Value& map, const ImportOptions& options, Source& source,
               Calibration& out) {
  const auto unit = asked_unit(options, source);
  out.up = "-y";
  out.facts.emplace_back(
      "a stereo pair, in the frame of its first camera, which is taken to be level");
  for (const char* number : {"1", "2"}) {
    CalibratedCamera c;
    c.name = number[0] == '1' ? "left" : "right";
    c.line = map.line;
    const std::string matrix = map.find("M1") ? std::string("M") + number
                                              : std::string("cameraMatrix") + number;
    const std::string bend =
        map.find("M1") ? std::string("D") + number : std::string("distCoeffs") + number;
    read_lens_of(map, matrix, map.find(bend) ? std::string_view(bend) : "", false, c,
                 source);
    c.X_WC = number[0] == '1' ? Pose{} : pose_of_camera(map, unit.value_or(1), source);
    out.cameras.push_back(std::move(c));
  }
}

void read_opencv(const Value& root, const ImportOptions& options, Source& source,
                 Calibration& out) {
  const Value& map = storage(root);
  if (map.find("M2") || map.find("cameraMatrix2"))
    return read_pair(map, options, source, out);
  CalibratedCamera c;
  c.name = "camera";
  c.line = map.line;
  const bool fisheye = text_or_empty(map, "fisheye_model") == "1";
  read_lens_of(map, first_of(map, kMatrix), first_of(map, kCoefficients), fisheye, c,
               source);
  if (!first_of(map, kTurn).empty() && !first_of(map, kWay).empty()) {
    c.X_WC = pose_of_camera(map, asked_unit(options, source).value_or(1), source);
    out.facts.emplace_back(
        "world to camera; which way is up isn't in the file: z is "
        "taken");
  }
  for (const char* key : {"avg_reprojection_error", "Avg_Reprojection_Error"})
    if (const std::string error = text_or_empty(map, key); !error.empty())
      c.residual = error + " px (" + key + ")";
  out.cameras.push_back(std::move(c));
}

void read_ros(const Value& root, const ImportOptions&, Source& source,
              Calibration& out) {
  CalibratedCamera c;
  c.name = text_or_empty(root, "camera_name");
  if (c.name.empty()) c.name = "camera";
  c.line = root.line;
  const std::string model = text_or_empty(root, "distortion_model");
  if (model != "plumb_bob" && model != "rational_polynomial" &&
      model != "equidistant" && model != "fisheye") {
    source.error(*root.find("distortion_model"),
                 "is distorted as '" + model +
                     "', which Delos doesn't know: plumb_bob, rational_polynomial and "
                     "equidistant are");
    return;
  }
  read_lens_of(root, first_of(root, kMatrix), first_of(root, kCoefficients),
               model == "equidistant" || model == "fisheye", c, source);
  out.facts.emplace_back(
      "the lens alone; K is read, and not P, which is of rectified images");
  out.cameras.push_back(std::move(c));
}

}  // namespace

const CalibrationFormat kRos = {"camera_info of ROS (.yaml)",
                                [](const Value& root) {
                                  return root.find("distortion_model") != nullptr &&
                                         !first_of(root, kMatrix).empty();
                                },
                                read_ros};

const CalibrationFormat kOpenCv = {
    "calibration by OpenCV (.yaml, .xml, .json)",
    [](const Value& root) { return !first_of(storage(root), kMatrix).empty(); },
    read_opencv};

}  // namespace delos::imports
