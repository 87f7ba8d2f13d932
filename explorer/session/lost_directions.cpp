#include "session/lost_directions.h"

#include <cmath>
#include <iomanip>
#include <sstream>

#include "delos/model/symmetric.h"
#include "delos/text/format.h"

namespace delos::session {
namespace {

/// Angles, and parts of distances, below which places are in line.
constexpr double kInLine = 1e-6;

/// "x 0.71, y −0.71": the states that take part, the first of them forwards; one alone
/// is named.
std::string states_of(const StateLayout& layout, const StateVector& v) {
  const std::vector<std::string> names = layout.names();
  std::ostringstream text;
  text << std::setprecision(2);
  double sign = 0;
  for (Eigen::Index i = 0; i < v.size(); ++i) {
    if (std::abs(v(i)) < kInLine) continue;
    if (sign == 0) sign = v(i) > 0 ? 1 : -1;
    if (text.tellp() > 0) text << ", ";
    text << names[static_cast<std::size_t>(i)];
    if (std::abs(v(i)) < 1 - kInLine) text << " " << sign * v(i);
  }
  return text.str();
}

/// Lost directions of the position, 3×m, of unit length.
/// @param positions how many coordinates the position has, 2 in a plane
Eigen::Matrix3Xd lost_positions(const StateMatrix& unobservable, int positions) {
  Eigen::Matrix3Xd lost(3, 0);
  for (Eigen::Index i = 0; i < unobservable.cols(); ++i) {
    Eigen::Vector3d p = Eigen::Vector3d::Zero();
    p.head(positions) = unobservable.col(i).head(positions);
    if (p.norm() < 1 - kInLine) continue;
    lost.conservativeResize(3, lost.cols() + 1);
    lost.rightCols<1>() = p.normalized();
  }
  return lost;
}

/// From the point to the devices that see it; empty where one is on the target.
std::vector<Eigen::Vector3d> towards_devices(const System& system,
                                             const PointReport& report) {
  std::vector<Eigen::Vector3d> all;
  for (std::size_t i = 0; i < report.devices.size(); ++i) {
    if (!report.devices[i].visible) continue;
    const PlacedDevice& device = system.devices[i];
    const Span span = device.device->span();
    if (device.carried() || (span != Span::point && span != Span::pose)) return {};
    all.emplace_back(device.X_WS().p - report.pose.p);
  }
  return all;
}

/// ", z = 0 m" where the plane is level or upright, else nothing.
std::string plane_words(const Eigen::Vector3d& normal, const Eigen::Vector3d& p) {
  for (Eigen::Index k = 0; k < 3; ++k)
    if (std::abs(normal[k]) > 1 - kInLine)
      return std::string(", ") + "xyz"[k] + " = " + format_quantity(p[k], "m");
  return "";
}

}  // namespace

std::vector<std::string> lost_directions(const System& system,
                                         const PointReport& report) {
  const StateMatrix& unobservable = report.state.unobservable;
  std::vector<std::string> lines;
  for (Eigen::Index i = 0; i < unobservable.cols(); ++i)
    lines.push_back("lost: " + states_of(system.motion.layout, unobservable.col(i)));
  const int positions = system.motion.layout.positions();
  if (positions == 0) return lines;
  const Eigen::Matrix3Xd lost = lost_positions(unobservable, positions);
  const std::vector<Eigen::Vector3d> arms = towards_devices(system, report);
  if (lost.cols() == 0 || arms.empty()) return lines;

  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (Eigen::Vector3d arm : arms) {
    arm.tail(3 - positions).setZero();  // as it is seen from above the plane
    spread += arm * arm.transpose();
  }
  const SymmetricEigen axes = symmetric_eigen(spread);
  const double least = kInLine * kInLine * axes.values(2);
  const bool line = axes.values(1) < least, plane = !line && axes.values(0) < least;
  const Eigen::Vector3d along = axes.vectors.col(2), normal = axes.vectors.col(0);
  const std::string who =
      "the point and " +
      (arms.size() == 2 ? std::string("both") : "all " + std::to_string(arms.size())) +
      " devices that see it lie ";
  const auto all_lost = [&](auto&& test) {
    for (Eigen::Index i = 0; i < lost.cols(); ++i)
      if (!test(lost.col(i))) return false;
    return true;
  };
  if (plane && lost.cols() == 1 && std::abs(lost.col(0).dot(normal)) > 1 - kInLine)
    lines.push_back(who + "in one plane" + plane_words(normal, report.pose.p) +
                    ", so that small moves out of it change no reading" +
                    (std::abs(normal.z()) > 1 - kInLine
                         ? "; where the target can't make any, 'state: planar' says so"
                         : ""));
  else if (line && arms.size() > 1 && all_lost([&](const Eigen::Vector3d& v) {
             return std::abs(v.dot(along)) < kInLine ||
                    std::abs(v.dot(along)) > 1 - kInLine;
           }))
    lines.push_back(who + "on one line" +
                    (positions == 2 ? " as seen from above" : ""));
  return lines;
}

}  // namespace delos::session
