#include "imports/written_rigs.h"

#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>

namespace delos::test {
namespace {

std::string digits(double x) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", x);
  return text;
}

/// Numbers with something between them.
std::string row(const Eigen::Ref<const Eigen::VectorXd>& v,
                const char* between = ", ") {
  std::string text;
  for (const double x : v) text += (text.empty() ? "" : between) + digits(x);
  return text;
}

std::string list(const Eigen::Ref<const Eigen::VectorXd>& v) {
  return "[" + row(v) + "]";
}

Eigen::VectorXd by_rows(const Eigen::Ref<const Eigen::MatrixXd>& M) {
  const Eigen::MatrixXd T = M.transpose();
  return Eigen::Map<const Eigen::VectorXd>(T.data(), T.size());
}

std::string nested(const Eigen::Ref<const Eigen::MatrixXd>& M) {
  std::string text;
  for (Eigen::Index i = 0; i < M.rows(); ++i)
    text += (i > 0 ? ", " : "") + list(M.row(i).transpose());
  return "[" + text + "]";
}

Eigen::Matrix3d K_of(const TrueCamera& c) {
  Eigen::Matrix3d K;
  K << c.f.x(), 0, c.c.x(), 0, c.f.y(), c.c.y(), 0, 0, 1;
  return K;
}

Eigen::VectorXd k_of(const TrueCamera& c, int n) {
  return Eigen::Map<const Eigen::VectorXd>(c.k.data(), n);
}

Eigen::Vector3d vector_of(const Eigen::Matrix3d& R) {
  const Eigen::AngleAxisd turn(R);
  return turn.angle() * turn.axis();
}

Eigen::Matrix4d matrix_of(const TrueCamera& c) {
  Eigen::Matrix4d T = Eigen::Matrix4d::Identity();
  T.topLeftCorner<3, 3>() = c.R;
  T.topRightCorner<3, 1>() = c.t;
  return T;
}

std::string attribute(const std::string& name, double x) {
  return " " + name + "=\"" + digits(x) + "\"";
}

std::string number(std::size_t i) { return std::to_string(i); }

std::string qualisys(const std::vector<TrueCamera>& rig) {
  std::string text = "<?xml version='1.0'?>\n<calibration>\n<cameras>\n";
  for (std::size_t i = 0; i < rig.size(); ++i) {
    const TrueCamera& c = rig[i];
    const Eigen::Matrix3d r = Eigen::Vector3d(1, -1, -1).asDiagonal() * c.R;
    const Eigen::Vector3d at = -1000 * (c.R.transpose() * c.t);
    text += "<camera active=\"1\" serial=\"c" + number(i) +
            "\" avg-residual=\"0.4\">\n" + "<fov_marker left=\"0\" top=\"0\"" +
            attribute("right", c.size.x() - 1) + attribute("bottom", c.size.y() - 1) +
            "/>\n<transform";
    for (int a = 0; a < 3; ++a) {
      text += attribute(std::string(1, static_cast<char>('x' + a)), at(a));
      for (int b = 0; b < 3; ++b)
        text += attribute("r" + std::to_string(a + 1) + std::to_string(b + 1), r(a, b));
    }
    text += "/>\n<intrinsic" + attribute("focalLengthU", 64 * c.f.x()) +
            attribute("focalLengthV", 64 * c.f.y()) +
            attribute("centerPointU", 64 * c.c.x()) +
            attribute("centerPointV", 64 * c.c.y()) +
            attribute("sensorMaxU", 64 * (c.size.x() - 1)) +
            attribute("sensorMaxV", 64 * (c.size.y() - 1)) +
            attribute("radialDistortion1", c.k[0]) +
            attribute("radialDistortion2", c.k[1]) +
            attribute("radialDistortion3", c.k[4]) +
            attribute("tangentalDistortion1", c.k[2]) +
            attribute("tangentalDistortion2", c.k[3]) + " skew=\"0\"/>\n</camera>\n";
  }
  return text + "</cameras>\n</calibration>\n";
}

std::string vicon(const std::vector<TrueCamera>& rig) {
  std::string text = "<?xml version=\"1.0\"?>\n<Cameras>\n";
  for (std::size_t i = 0; i < rig.size(); ++i) {
    const TrueCamera& c = rig[i];
    const Eigen::Quaterniond q(c.R);
    text += "<Camera DEVICEID=\"" + number(i) + "\" SENSOR_SIZE=\"" + row(c.size, " ") +
            "\"" + attribute("PIXEL_ASPECT_RATIO", c.f.x() / c.f.y()) +
            ">\n<KeyFrames><KeyFrame" + attribute("FOCAL_LENGTH", c.f.x()) +
            " PRINCIPAL_POINT=\"" + row(c.c, " ") + "\" ORIENTATION=\"" +
            row(q.coeffs(), " ") + "\" POSITION=\"" +
            row(-1000 * (c.R.transpose() * c.t), " ") +
            "\" VICON_RADIAL2=\"ViconRadial2 0 0 " +
            row(Eigen::Vector3d(c.k[0], c.k[1], c.k[4]), " ") +
            "\"/></KeyFrames>\n</Camera>\n";
  }
  return text + "</Cameras>\n";
}

std::string utf16(const std::string& ascii) {
  std::string wide = "\xFF\xFE";
  for (const char c : ascii) wide += {c, '\0'};
  return wide;
}

/// y up: (x, y, z) of the truth is (x, z, −y) there.
std::string motive(const std::vector<TrueCamera>& rig) {
  Eigen::Matrix3d turn;
  turn << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  std::string text =
      "<?xml version=\"1.0\" encoding=\"UTF-16\"?>\n"
      "<calibrationProfile><Calibration><Cameras>\n";
  for (std::size_t i = 0; i < rig.size(); ++i) {
    const TrueCamera& c = rig[i];
    const Eigen::Matrix3d R =
        turn * c.R.transpose() * Eigen::Vector3d(1, -1, -1).asDiagonal();
    const Eigen::Vector3d at = -(turn * c.R.transpose() * c.t);
    text += "<Camera Serial=\"M" + number(i) + "\"><Attributes" +
            attribute("ImagerPixelWidth", c.size.x()) +
            attribute("ImagerPixelHeight", c.size.y()) + "/><Intrinsic" +
            attribute("LensCenterX", c.c.x()) + attribute("LensCenterY", c.c.y()) +
            attribute("HorizontalFocalLength", c.f.x()) +
            attribute("VerticalFocalLength", c.f.y()) +
            " k1=\"0\" k2=\"0\" k3=\"0\"/><Extrinsic" + attribute("X", at.x()) +
            attribute("Y", at.y()) + attribute("Z", at.z());
    for (int a = 0; a < 9; ++a)
      text += attribute("OrientMatrix" + std::to_string(a), R(a / 3, a % 3));
    text += "/></Camera>\n";
  }
  return utf16(text + "</Cameras></Calibration></calibrationProfile>\n");
}

/// @param extra lines of each camera
std::string toml(const std::vector<TrueCamera>& rig, const std::string& section,
                 int coefficients, bool matrix, double unit, const std::string& extra) {
  std::string text;
  for (std::size_t i = 0; i < rig.size(); ++i) {
    const TrueCamera& c = rig[i];
    text += "[" + section + number(i) + "]\nname = \"cam" + number(i) +
            "\"\nsize = " + list(c.size) + "\nmatrix = " + nested(K_of(c)) +
            "\ndistortions = " + list(k_of(c, coefficients)) +
            "\nrotation = " + (matrix ? nested(c.R) : list(vector_of(c.R))) +
            "\ntranslation = " + list(c.t / unit) + "\n" + extra + "\n";
  }
  return text;
}

/// @param chain poses from camera to camera, or each from the IMU
std::string kalibr(const std::vector<TrueCamera>& rig, bool chain) {
  std::string text;
  for (std::size_t i = 0; i < rig.size(); ++i) {
    const TrueCamera& c = rig[i];
    text += "cam" + number(i) + ":\n  camera_model: pinhole\n  distortion_model: " +
            (c.fisheye ? "equidistant" : "radtan") +
            "\n  distortion_coeffs: " + list(k_of(c, 4)) + "\n  intrinsics: [" +
            row(c.f) + ", " + row(c.c) + "]\n  resolution: " + list(c.size) + "\n";
    if (!chain) text += "  T_cam_imu: " + nested(matrix_of(c)) + "\n";
    if (chain && i > 0)
      text += "  T_cn_cnm1: " + nested(matrix_of(c) * matrix_of(rig[i - 1]).inverse()) +
              "\n";
  }
  return text;
}

std::string human36m(const std::vector<TrueCamera>& rig) {
  std::string lenses, places;
  for (std::size_t i = 0; i < rig.size(); ++i) {
    const TrueCamera& c = rig[i];
    const std::string comma = i > 0 ? ", " : "";
    lenses += comma + "\"5" + number(i) +
              "\": {\"calibration_matrix\": " + nested(K_of(c)) +
              ", \"distortion\": " + list(k_of(c, 5)) + "}";
    places += comma + "\"5" + number(i) + "\": {\"R\": " + nested(c.R) +
              ", \"t\": " + nested(1000 * c.t) + "}";
  }
  return "{\"extrinsics\": {\"S1\": {}, \"S5\": {" + places + "}}, \"intrinsics\": {" +
         lenses + "}}\n";
}

std::string mrcal(const TrueCamera& c) {
  Eigen::VectorXd lens(12), rt(6);
  lens << c.f, c.c, k_of(c, 8);
  rt << vector_of(c.R), c.t;
  return "{\n    'lensmodel':  'LENSMODEL_OPENCV8',\n    # f, c, k\n    'intrinsics': "
         "[ " +
         row(lens) + ",],\n    'extrinsics': [ " + row(rt) +
         ", ],\n    'imagersize': [ " + row(c.size) + " ]\n}\n";
}

/// As cv::FileStorage writes a matrix.
std::string storage(const std::string& name,
                    const Eigen::Ref<const Eigen::MatrixXd>& M) {
  return name + ": !!opencv-matrix\n   rows: " + std::to_string(M.rows()) +
         "\n   cols: " + std::to_string(M.cols()) +
         "\n   dt: d\n   data: " + list(by_rows(M)) + "\n";
}

std::string opencv(const TrueCamera& c) {
  return "%YAML:1.0\n---\nimage_width: " + digits(c.size.x()) +
         "\nimage_height: " + digits(c.size.y()) + "\n" +
         storage("camera_matrix", K_of(c)) +
         storage("distortion_coefficients", k_of(c, 5).transpose()) +
         storage("rvec", vector_of(c.R)) + storage("tvec", 1000 * c.t);
}

std::string opencv_xml(const TrueCamera& c) {
  const auto matrix = [](const std::string& name, const Eigen::MatrixXd& M) {
    return "<" + name + " type_id=\"opencv-matrix\"><rows>" + std::to_string(M.rows()) +
           "</rows><cols>" + std::to_string(M.cols()) + "</cols><dt>d</dt><data>\n" +
           row(by_rows(M), " ") + "</data></" + name + ">\n";
  };
  return "<?xml version=\"1.0\"?>\n<opencv_storage>\n<image_Width>" +
         digits(c.size.x()) + "</image_Width>\n<image_Height>" + digits(c.size.y()) +
         "</image_Height>\n" + matrix("Camera_Matrix", K_of(c)) +
         matrix("Distortion_Coefficients", k_of(c, 5)) + matrix("R", c.R) +
         matrix("T", c.t) + "</opencv_storage>\n";
}

std::string ros(const TrueCamera& c, const std::string& model, int n) {
  const auto matrix = [](const std::string& name, const Eigen::MatrixXd& M) {
    return name + ":\n  rows: " + std::to_string(M.rows()) +
           "\n  cols: " + std::to_string(M.cols()) + "\n  data: " + list(by_rows(M)) +
           "\n";
  };
  Eigen::MatrixXd P = Eigen::MatrixXd::Ones(3, 4);
  return "image_width: " + digits(c.size.x()) +
         "\nimage_height: " + digits(c.size.y()) + "\ncamera_name: head\n" +
         matrix("camera_matrix", K_of(c)) + "distortion_model: " + model + "\n" +
         matrix("distortion_coefficients", k_of(c, n).transpose()) +
         matrix("projection_matrix", P);
}

std::pair<std::string, std::string> easymocap(const std::vector<TrueCamera>& rig) {
  std::string names = "%YAML:1.0\n---\nnames:\n", lenses, places;
  for (std::size_t i = 0; i < rig.size(); ++i) {
    names += "   - \"0" + number(i) + "\"\n";
    lenses += storage("K_0" + number(i), K_of(rig[i])) +
              storage("dist_0" + number(i), k_of(rig[i], 5).transpose());
    places += storage("R_0" + number(i), vector_of(rig[i].R)) +
              storage("Rot_0" + number(i), rig[i].R) +
              storage("T_0" + number(i), rig[i].t);
  }
  return {names + lenses, names + places};
}

std::pair<std::string, std::string> colmap(const std::vector<TrueCamera>& rig) {
  std::string cameras = "# Camera list with one line of data per camera:\n",
              images = "# Image list with two lines of data per image:\n";
  for (std::size_t i = 0; i < rig.size(); ++i) {
    const TrueCamera& c = rig[i];
    const Eigen::Quaterniond q(c.R);
    cameras += number(i) + " OPENCV " + row(c.size, " ") + " " + row(c.f, " ") + " " +
               row(c.c.array() + 0.5, " ") + " " + row(k_of(c, 4), " ") + "\n";
    images += number(i) + " " + row(Eigen::Vector4d(q.w(), q.x(), q.y(), q.z()), " ") +
              " " + row(c.t, " ") + " " + number(i) + " a/c" + number(i) + ".jpg\n" +
              (i == 1 ? "" : "1.5 2.5 -1") + "\n";
  }
  return {cameras, images};
}

/// z of the scene was -y: that of a camera's frame.
Pose turned_from_y_down() {
  Pose X;
  X.R << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  return X;
}

}  // namespace

Eigen::Vector2d TrueCamera::image(const Eigen::Vector3d& p_W) const {
  const Eigen::Vector3d p = R * p_W + t;
  const double x = p.x() / p.z(), y = p.y() / p.z(), r2 = x * x + y * y;
  if (fisheye) {
    const double r = std::sqrt(r2), a = std::atan(r), a2 = a * a;
    const double d = a * (1 + k[0] * a2 + k[1] * a2 * a2 + k[2] * std::pow(a, 6) +
                          k[3] * std::pow(a, 8));
    return {f.x() * x * d / r + c.x(), f.y() * y * d / r + c.y()};
  }
  const double g = (1 + k[0] * r2 + k[1] * r2 * r2 + k[4] * r2 * r2 * r2) /
                   (1 + k[5] * r2 + k[6] * r2 * r2 + k[7] * r2 * r2 * r2);
  return {f.x() * (x * g + 2 * k[2] * x * y + k[3] * (r2 + 2 * x * x)) + c.x(),
          f.y() * (y * g + k[2] * (r2 + 2 * y * y) + 2 * k[3] * x * y) + c.y()};
}

std::vector<TrueCamera> true_rig(int coefficients, bool fisheye) {
  const std::array<double, 8> k = {-0.11,  0.06, 0.0012, -0.0007,
                                   -0.008, 0.02, -0.01,  0.003};
  std::vector<TrueCamera> rig;
  for (int i = 0; i < 3; ++i) {
    TrueCamera c;
    c.f = {901.5 + 20 * i, 903.25 + 20 * i};
    c.c = {633.4 + 3 * i, 518.2 - 2 * i};
    c.size = {1280, 1024};
    for (int n = 0; n < coefficients; ++n)
      c.k[static_cast<std::size_t>(n)] = k[static_cast<std::size_t>(n)] * (1 + 0.1 * i);
    c.fisheye = fisheye;
    const double around = 2.1 * i + 0.3;
    const Eigen::Vector3d at(3 * std::cos(around), 3 * std::sin(around), 2.2 + 0.2 * i);
    const Eigen::Matrix3d R_WC = rotation_from_aim(at, {0, 0, 1}) *
                                 Eigen::AngleAxisd(0.1 * i, Eigen::Vector3d::UnitZ());
    c.R = R_WC.transpose();
    c.t = -c.R * at;
    rig.push_back(c);
  }
  return rig;
}

std::vector<WrittenRig> written_rigs() {
  const auto none = true_rig(0), four = true_rig(4), five = true_rig(5);
  const auto fisheye = true_rig(4, true);
  auto radial = five, eight = true_rig(8);
  for (TrueCamera& c : radial) c.k[2] = c.k[3] = 0;
  eight.resize(1);
  auto one = five;
  one.resize(1);
  imports::ImportOptions mm, m, with_size, s5;
  mm.unit = 1e-3;
  m.unit = 1;
  with_size.resolution = Eigen::Vector2d(1280, 1024);
  s5.subject = "S5";
  s5.resolution = Eigen::Vector2d(1280, 1024);
  const Pose turned = turned_from_y_down();
  const auto mocap = easymocap(five);
  const auto model = colmap(four);
  const Pose from_first = turned * Pose{four[0].R, four[0].t};
  return {
      {"Qualisys", {{"a.qca.txt", qualisys(five)}}, {}, five},
      {"Vicon", {{"a.xcp", vicon(radial)}}, {}, radial},
      {"Motive", {{"a.mcal", motive(none)}}, {}, none},
      {"Caliscope",
       {{"a.toml", toml(five, "cameras.", 5, true, 1, "rotation_count = 1")}},
       {},
       five},
      {"Pose2Sim",
       {{"a.toml", toml(four, "cam_0", 4, false, 1, "fisheye = false")}},
       {},
       four},
      {"aniposelib", {{"a.toml", toml(five, "cam_", 5, false, 1e-3, "")}}, mm, five},
      {"aniposelib, fisheye",
       {{"a.toml", toml(fisheye, "cam_", 4, false, 1e-3, "fisheye = true")}},
       mm,
       fisheye},
      {"Kalibr, IMU", {{"camchain.yaml", kalibr(fisheye, false)}}, {}, fisheye},
      {"Kalibr, chain", {{"camchain.yaml", kalibr(four, true)}}, {}, four, from_first},
      {"Human3.6M", {{"a.json", human36m(five)}}, s5, five},
      {"mrcal", {{"a.cameramodel", mrcal(eight[0])}}, {}, eight},
      {"OpenCV", {{"a.yaml", opencv(one[0])}}, mm, one},
      {"OpenCV XML", {{"a.xml", opencv_xml(one[0])}}, m, one},
      {"ROS", {{"a.yaml", ros(one[0], "plumb_bob", 5)}}, {}, one, {}, false},
      {"ROS, rational",
       {{"a.yaml", ros(eight[0], "rational_polynomial", 8)}},
       {},
       eight,
       {},
       false},
      {"EasyMocap",
       {{"intri.yml", mocap.first}, {"extri.yml", mocap.second}},
       with_size,
       five},
      {"COLMAP",
       {{"images.txt", model.second}, {"cameras.txt", model.first}},
       m,
       four,
       turned},
  };
}

}  // namespace delos::test
