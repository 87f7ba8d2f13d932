#include "render/eye.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>
#include <variant>
#include <vector>

#include "delos/text/units.h"
#include "session/refusal.h"

namespace delos::render {
namespace {

using session::Blame;
using session::Refusal;

/// Half of the smaller side of a picture at a unit distance: 40 degrees, as the page's.
const double kSlope = std::tan(20 * std::numbers::pi / 180);
constexpr double kMargin = 1.06;  ///< of the picture around what is looked at

struct NamedView {
  const char* name;
  Eigen::Vector3d towards;
};
const std::array<NamedView, 7> kViews{{{"corner", {-0.75, -1, 0.62}},
                                       {"top", {0, 0, 1}},
                                       {"below", {0, 0, -1}},
                                       {"front", {0, -1, 0}},
                                       {"back", {0, 1, 0}},
                                       {"right", {1, 0, 0}},
                                       {"left", {-1, 0, 0}}}};

Refusal no_view(const std::string& text) {
  std::string names;
  for (const NamedView& view : kViews) names += std::string(view.name) + ", ";
  return {Blame::question, "view '" + text + "': should be " + names +
                               "or azimuth,elevation[,distance] such as 30,25 or "
                               "'30 deg, 25 deg, 8 m'"};
}

/// Rows right, up and ahead; y is up where the eye looks along z.
Eigen::Matrix3d frame_of(const Eigen::Vector3d& towards) {
  const Eigen::Vector3d ahead = -towards.normalized();
  Eigen::Vector3d right = ahead.cross(Eigen::Vector3d::UnitZ());
  if (right.norm() < 1e-9) right = Eigen::Vector3d::UnitX();
  right.normalize();
  Eigen::Matrix3d R;
  R << right.transpose(), right.cross(ahead).transpose(), ahead.transpose();
  return R;
}

}  // namespace

View view_of(const std::string& text) {
  for (const NamedView& view : kViews)
    if (text == view.name) return {view.towards.normalized()};
  std::vector<double> numbers;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) {
    const bool length = numbers.size() == 2;
    const bool plain = part.find_first_not_of(" +-.0123456789eE") == std::string::npos;
    const auto read =
        parse_quantity(plain && !length ? part + " deg" : part, length ? "m" : "rad");
    if (!std::holds_alternative<double>(read)) throw no_view(text);
    numbers.push_back(std::get<double>(read));
  }
  if (numbers.size() < 2 || numbers.size() > 3) throw no_view(text);
  const double az = numbers[0], el = numbers[1];
  View view{{std::cos(el) * std::cos(az), std::cos(el) * std::sin(az), std::sin(el)}};
  if (std::abs(el) > std::numbers::pi / 2 + 1e-9) throw no_view(text);
  if (numbers.size() == 3) {
    if (!(numbers[2] > 0) || !std::isfinite(numbers[2])) throw no_view(text);
    view.distance = numbers[2];
  }
  return view;
}

Eye::Eye(const View& view, const Eigen::AlignedBox3d& room, const Frame& frame)
    : R_EW_(frame_of(view.towards)),
      centre_(room.center()),
      x0_(0.5 * frame.free),
      y0_(0.5 * frame.height),
      orthographic_(view.orthographic) {
  const double least = std::min(frame.free, frame.height);
  const double half_width = kSlope * frame.free / least / kMargin;
  const double half_height = kSlope * frame.height / least / kMargin;
  size_ = std::max(room.diagonal().norm(), 1e-6);
  double wanted = 1e-3 * size_;  // so far away, and every corner is in the picture
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d p =
        R_EW_ *
        (room.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i)) - centre_);
    const double aside =
        std::max(std::abs(p.x()) / half_width, std::abs(p.y()) / half_height);
    wanted = std::max(wanted, orthographic_ ? aside : aside - p.z());
  }
  distance_ = view.distance.value_or(wanted);
  scale_ = 0.5 * least / kSlope;
  if (orthographic_) scale_ /= distance_;
  nearest_ = orthographic_ ? -std::numeric_limits<double>::infinity() : 1e-3 * size_;
}

Eigen::Vector3d Eye::seen(const Eigen::Vector3d& world) const {
  Eigen::Vector3d p = R_EW_ * (world - centre_);
  p.z() += distance_;
  return p;
}

Spot Eye::spot(const Eigen::Vector3d& seen) const {
  const double weight = orthographic_ ? 1 : 1 / seen.z();
  return {x0_ + scale_ * weight * seen.x(), y0_ - scale_ * weight * seen.y(),
          orthographic_ ? -seen.z() : weight, weight};
}

Ray Eye::ray(double x, double y) const {
  const Eigen::Vector3d ahead = R_EW_.row(2);
  const Eigen::Vector3d aside = ((x - x0_) / scale_) * R_EW_.row(0).transpose() +
                                ((y0_ - y) / scale_) * R_EW_.row(1).transpose();
  const Eigen::Vector3d eye = centre_ - distance_ * ahead;
  if (orthographic_) return {eye + aside, ahead};
  return {eye, ahead + aside};
}

double Eye::ahead(double nearness) const {
  if (orthographic_) return -nearness;
  return nearness > 0 ? 1 / nearness : std::numeric_limits<double>::infinity();
}

double Eye::before(double nearness) const {
  constexpr double kLittle = 2e-3;
  return orthographic_ ? nearness + kLittle * size_ : nearness * (1 + kLittle);
}

}  // namespace delos::render
