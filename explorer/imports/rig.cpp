#include "imports/rig.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

#include "delos/text/units.h"
#include "delos/text/words.h"

namespace delos::imports {
namespace {

/// Noise of a marker's or a corner's middle, and how often cameras look.
constexpr const char* kSigma = "0.2";
constexpr const char* kRate = "100 Hz";
/// Spectral density of somebody who walks, as in scenes/05-optitrack-lab.yaml.
constexpr const char* kWalk = "{type: position_velocity, q: [0.4, 0.4, 0.1]}";
/// How far ahead lies what a single camera looks at, metres.
constexpr double kAhead = 2;

RigDevice device_of(const CalibratedCamera& camera) {
  RigDevice d;
  d.type = "camera";
  d.rate = kRate;
  d.rate_remark = "assumed, like sigma";
  const Pose X = camera.X_WC.value_or(Pose{});
  d.placement.at = X.p;
  const Eigen::Quaterniond q(X.R);
  d.placement.facing = QuaternionWxyz{{q.w(), q.x(), q.y(), q.z()}};
  const auto add = [&](const char* name, double value) {
    d.params.emplace_back(name, shortest(value));
  };
  d.params.emplace_back("resolution", list_text(camera.size));
  d.params.emplace_back("sigma", kSigma);
  add("f_x", camera.f.x());
  add("f_y", camera.f.y());
  add("c_x", camera.c.x());
  add("c_y", camera.c.y());
  if (camera.lens == Lens::rational) d.params.emplace_back("distortion", "rational");
  if (camera.lens == Lens::fisheye) d.params.emplace_back("distortion", "fisheye");
  constexpr const char* kRadial[] = {"k1", "k2", "k3", "k4", "k5", "k6"};
  for (std::size_t i = 0; i < 6; ++i)
    if (camera.k[i] != 0) add(kRadial[i], camera.k[i]);
  if (camera.p[0] != 0) add("p1", camera.p[0]);
  if (camera.p[1] != 0) add("p2", camera.p[1]);
  return d;
}

/// Names that differ.
void tell_apart(std::vector<RigDevice>& devices) {
  std::set<std::string> taken;
  for (RigDevice& d : devices) {
    const std::string name = d.name;
    for (int i = 2; !taken.insert(d.name).second; ++i)
      d.name = name + "-" + std::to_string(i);
  }
}

/// The place that axes pass nearest to, in the sense of least squares; nullopt where
/// they are nearly parallel.
std::optional<Eigen::Vector3d> common_centre(const std::vector<Pose>& sights) {
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  for (const Pose& X : sights) {
    const Eigen::Vector3d z = X.R.col(2);
    const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - z * z.transpose();
    A += across;
    b += across * X.p;
  }
  constexpr double kSpread = 0.01;  // mean square sine between axes
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(A);
  if (eigen.eigenvalues()(0) < kSpread * static_cast<double>(sights.size()))
    return std::nullopt;
  return A.ldlt().solve(b);
}

/// The centre without one: ahead of the devices' mean.
Eigen::Vector3d centre_ahead(const std::vector<Pose>& sights) {
  Eigen::Vector3d p = Eigen::Vector3d::Zero(), z = p;
  Eigen::AlignedBox3d box;
  for (const Pose& X : sights) {
    p += X.p / static_cast<double>(sights.size());
    z += X.R.col(2);
    box.extend(X.p);
  }
  const double away = std::max(kAhead, 10 * box.diagonal().norm());
  return p + away * (z.norm() > 0 ? Eigen::Vector3d(z.normalized())
                                  : Eigen::Vector3d::Zero().eval());
}

/// 1, 2 or 5 times a power of ten, the nearest below.
double round_step(double step) {
  const double ten = std::pow(10, std::floor(std::log10(step)));
  return ten * (step >= 5 * ten ? 5 : step >= 2 * ten ? 2 : 1);
}

std::string decimal(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.12g", value == 0 ? 0.0 : value);
  return text;
}

std::string corner_text(const Eigen::Vector3d& p) {
  return "[" + decimal(p.x()) + ", " + decimal(p.y()) + ", " + decimal(p.z()) + "]";
}

}  // namespace

std::string list_text(const Eigen::Ref<const Eigen::VectorXd>& numbers) {
  std::vector<std::string> texts;
  for (const double x : numbers) texts.push_back(shortest(x));
  return "[" + joined(texts) + "]";
}

std::string scene_name(std::string name) {
  for (char& c : name)
    if (c == '.' || c == '=' || static_cast<unsigned char>(c) < ' ' || c == '\x7f')
      c = '-';
  const std::size_t begin = name.find_first_not_of(' ');
  if (begin == std::string::npos) return "device";
  return name.substr(begin, name.find_last_not_of(' ') - begin + 1);
}

Rig rig_of(const Calibration& calibration, const std::string& kind) {
  Rig rig;
  rig.kind = kind;
  rig.facts = calibration.facts;
  bool unplaced = false;
  for (const CalibratedCamera& camera : calibration.cameras) {
    rig.devices.push_back(device_of(camera));
    rig.devices.back().name = scene_name(camera.name);
    if (!camera.residual.empty())
      rig.facts.push_back(rig.devices.back().name + ": residual " + camera.residual);
    if (camera.X_WC) continue;
    // Level, along the world's y axis.
    unplaced = true;
    rig.devices.back().placement = {};
    rig.devices.back().placement.facing = Aim{{0, 1, 0}};
  }
  tell_apart(rig.devices);
  rig.assumed.emplace_back(
      "cameras look 100 times a second and know a middle on their image to 0.2 px; a "
      "calibration's residual is no noise of a reading");
  if (unplaced)
    rig.assumed.emplace_back(
        "a camera whose place the file doesn't say stands at the "
        "origin and looks along y");
  if (rig.devices.size() == 1)
    rig.assumed.emplace_back("one camera alone sees no distance: add another");
  return rig;
}

void assume_rest(Rig& rig, const std::vector<Pose>& sights, Source& source) {
  if (rig.motion.empty()) {
    rig.motion = kWalk;
    rig.assumed.emplace_back("the target moves as somebody who walks");
  }
  if (!rig.sample.empty() || sights.empty()) return;
  const auto common = common_centre(sights);
  const Eigen::Vector3d centre = common ? *common : centre_ahead(sights);
  std::vector<double> distances;
  std::vector<std::string> away;
  for (std::size_t i = 0; i < sights.size(); ++i) {
    distances.push_back((centre - sights[i].p).norm());
    if ((centre - sights[i].p).dot(sights[i].R.col(2)) <= 0)
      away.push_back(rig.devices[i].name);
  }
  if (common && sights.size() > 2 && away.size() == sights.size()) {
    source.error(0,
                 "all devices look away from the place that their axes pass nearest "
                 "to, " +
                     coordinates(centre) +
                     " m: their axes, or world to camera, are the wrong way round");
    return;
  }
  if (!away.empty())
    source.warning(0, listed(away) + (away.size() == 1 ? " looks" : " look") +
                          " away from the place that all axes pass nearest to, " +
                          coordinates(centre) + " m");
  std::nth_element(
      distances.begin(),
      distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2),
      distances.end());
  const double reach = std::max(distances[distances.size() / 2], 1e-3);
  constexpr double kPart = 0.3;  // of the way to the devices, on each side
  constexpr int kSteps = 10;
  const double step = round_step(2 * kPart * reach / kSteps);
  const int steps = static_cast<int>(std::floor(2 * kPart * reach / step + 1e-9));
  const Eigen::Vector3d min =
      ((centre.array() - steps * step / 2) / step).round() * step;
  rig.sample = "volume: {min: " + corner_text(min) +
               ", max: " + corner_text(min.array() + steps * step) +
               ", step: " + decimal(step) + "}";
  rig.assumed.emplace_back(common ? "samples fill a box around the place that the "
                                    "devices' axes pass nearest to"
                                  : "samples fill a box ahead of the devices");
}

}  // namespace delos::imports
