#include "imports/camera_export.h"

#include <cctype>
#include <nlohmann/json.hpp>

#include "delos/device/camera_model.h"
#include "delos/text/units.h"

namespace delos::imports {
namespace {

using ExportJson = nlohmann::ordered_json;

bool has_param(const ParamValues& params, std::string_view name) {
  for (const auto& [key, value] : params.all())
    if (key == name) return true;
  return false;
}

/// By the table of delos/device/camera_table.h.
void set_calibrated(const ParamValues& p, CalibratedCamera& c) {
  const CameraModel model(p);
  c.size = p.matrix("resolution");
  c.f = {model.f_across(), model.f_down()};
  c.c = {p["c_x"] == 0 ? c.size.x() / 2 : p["c_x"],
         p["c_y"] == 0 ? c.size.y() / 2 : p["c_y"]};
  c.lens = model.fisheye()                        ? Lens::fisheye
           : p.choice("distortion") == "rational" ? Lens::rational
                                                  : Lens::brown_conrady;
  c.k = {p["k1"], p["k2"], p["k3"], p["k4"], p["k5"], p["k6"]};
  c.p = {p["p1"], p["p2"]};
}

Eigen::Matrix3d camera_matrix(const CalibratedCamera& c) {
  Eigen::Matrix3d K;
  K << c.f.x(), 0, c.c.x(), 0, c.f.y(), c.c.y(), 0, 0, 1;
  return K;
}

/// In OpenCV's order: k1 k2 p1 p2 k3 [k4 k5 k6], or k1 … k4 of a fisheye.
std::vector<double> coefficients(const CalibratedCamera& c) {
  if (c.lens == Lens::fisheye) return {c.k[0], c.k[1], c.k[2], c.k[3]};
  std::vector<double> k = {c.k[0], c.k[1], c.p[0], c.p[1], c.k[2]};
  if (c.lens == Lens::rational) k.insert(k.end(), {c.k[3], c.k[4], c.k[5]});
  return k;
}

const char* word_of(Lens lens) {
  return lens == Lens::fisheye    ? "fisheye"
         : lens == Lens::rational ? "rational"
                                  : "brown_conrady";
}

/// Numbers row by row, with something between them.
std::string by_rows(const Eigen::Ref<const Eigen::MatrixXd>& M, const char* between) {
  std::string text;
  for (Eigen::Index i = 0; i < M.rows(); ++i)
    for (Eigen::Index j = 0; j < M.cols(); ++j)
      text += (text.empty() ? "" : between) + shortest(M(i, j));
  return text;
}

ExportJson json_rows(const Eigen::Ref<const Eigen::MatrixXd>& M) {
  ExportJson rows = ExportJson::array();
  for (Eigen::Index i = 0; i < M.rows(); ++i) {
    ExportJson row = ExportJson::array();
    for (Eigen::Index j = 0; j < M.cols(); ++j) row.push_back(M(i, j));
    rows.push_back(std::move(row));
  }
  return rows;
}

std::string as_json(const std::vector<CalibratedCamera>& cameras) {
  ExportJson all = ExportJson::array();
  for (const CalibratedCamera& c : cameras) {
    const Pose X_CW = c.X_WC->inverse();
    all.push_back({{"name", c.name},
                   {"width", c.size.x()},
                   {"height", c.size.y()},
                   {"K", json_rows(camera_matrix(c))},
                   {"distortion",
                    {{"model", word_of(c.lens)}, {"coefficients", coefficients(c)}}},
                   {"R", json_rows(X_CW.R)},
                   {"t", {X_CW.p.x(), X_CW.p.y(), X_CW.p.z()}},
                   {"P", json_rows(projection(c))}});
  }
  return all.dump(1, ' ', false, ExportJson::error_handler_t::replace) + "\n";
}

std::string as_csv(const std::vector<CalibratedCamera>& cameras) {
  std::string text =
      "name,width,height,f_x,f_y,c_x,c_y,distortion,k1,k2,k3,k4,k5,k6,p1,p2,"
      "R11,R12,R13,R21,R22,R23,R31,R32,R33,t1,t2,t3,"
      "P11,P12,P13,P14,P21,P22,P23,P24,P31,P32,P33,P34\n";
  for (const CalibratedCamera& c : cameras) {
    std::string name = "\"";
    for (const char letter : c.name)
      name += letter == '"' ? "\"\"" : std::string(1, letter);
    const Pose X_CW = c.X_WC->inverse();
    Eigen::Matrix<double, 1, 6> lens;
    lens << c.size.transpose(), c.f.transpose(), c.c.transpose();
    text += name + "\"," + by_rows(lens, ",") + "," + word_of(c.lens);
    for (const double k : c.k) text += "," + shortest(k);
    for (const double p : c.p) text += "," + shortest(p);
    text += "," + by_rows(X_CW.R, ",") + "," + by_rows(X_CW.p, ",") + "," +
            by_rows(projection(c), ",") + "\n";
  }
  return text;
}

std::string as_matrices(const std::vector<CalibratedCamera>& cameras) {
  std::string text;
  for (const CalibratedCamera& c : cameras) {
    text += "# " + c.name + "\n";
    const auto P = projection(c);
    for (Eigen::Index i = 0; i < 3; ++i) text += by_rows(P.row(i), " ") + "\n";
  }
  return text;
}

std::string storage_matrix(const std::string& name,
                           const Eigen::Ref<const Eigen::MatrixXd>& M) {
  return name + ": !!opencv-matrix\n   rows: " + std::to_string(M.rows()) +
         "\n   cols: " + std::to_string(M.cols()) + "\n   dt: d\n   data: [ " +
         by_rows(M, ", ") + " ]\n";
}

std::string as_opencv(const std::vector<CalibratedCamera>& cameras) {
  std::string names = "%YAML:1.0\n---\nnames:\n", text;
  for (const CalibratedCamera& c : cameras) {
    std::string name;  // cv::FileStorage takes letters, digits, '-' and '_'
    for (const char letter : c.name)
      name += std::isalnum(static_cast<unsigned char>(letter)) || letter == '-' ? letter
                                                                                : '_';
    names += "   - \"" + name + "\"\n";
    const Pose X_CW = c.X_WC->inverse();
    const std::vector<double> k = coefficients(c);
    text += storage_matrix("K_" + name, camera_matrix(c)) +
            storage_matrix("dist_" + name,
                           Eigen::Map<const Eigen::RowVectorXd>(
                               k.data(), static_cast<Eigen::Index>(k.size()))) +
            "fisheye_" + name + ": " + (c.lens == Lens::fisheye ? "1" : "0") + "\nW_" +
            name + ": " + shortest(c.size.x()) + "\nH_" + name + ": " +
            shortest(c.size.y()) + "\n" + storage_matrix("Rot_" + name, X_CW.R) +
            storage_matrix("T_" + name, X_CW.p);
  }
  return names + text;
}

}  // namespace

std::vector<CalibratedCamera> cameras_of(const System& system) {
  std::vector<CalibratedCamera> cameras;
  for (const PlacedDevice& device : system.devices) {
    if (device.carried()) continue;
    const ParamValues& p = device.params;
    CalibratedCamera c;
    c.name = device.name;
    c.X_WC = device.X_WS();
    if (has_param(p, "f_x") && has_param(p, "distortion")) {
      set_calibrated(p, c);
    } else if (has_param(p, "focal") && has_param(p, "pitch") &&
               has_param(p, "resolution")) {
      c.size = p.matrix("resolution");
      c.f = Eigen::Vector2d::Constant(p["focal"] / p["pitch"]);
      c.c = c.size / 2;
    } else {
      continue;
    }
    cameras.push_back(std::move(c));
  }
  return cameras;
}

Eigen::Matrix<double, 3, 4> projection(const CalibratedCamera& camera) {
  const Pose X_CW = camera.X_WC->inverse();
  Eigen::Matrix<double, 3, 4> Rt;
  Rt << X_CW.R, X_CW.p;
  return camera_matrix(camera) * Rt;
}

std::string matrices_text(const std::vector<CalibratedCamera>& cameras,
                          MatrixFormat format) {
  switch (format) {
    case MatrixFormat::opencv_yaml:
      return as_opencv(cameras);
    case MatrixFormat::json:
      return as_json(cameras);
    case MatrixFormat::csv:
      return as_csv(cameras);
    case MatrixFormat::matrix:
      return as_matrices(cameras);
  }
  return {};
}

}  // namespace delos::imports
