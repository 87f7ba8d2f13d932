#include "session/one_more_device.h"

#include <algorithm>
#include <cmath>

#include "delos/field/evaluate.h"
#include "delos/text/format.h"
#include "delos/text/words.h"

namespace delos::session {
namespace {

/// Values that differ by no more are those of places that mirror each other.
constexpr double kSameValue = 1e-9;

/// Of each kind of device that another place would make a difference to, the first.
std::vector<PlacedDevice> kinds_of(const System& system) {
  std::vector<PlacedDevice> kinds;
  for (const PlacedDevice& device : system.devices) {
    const Span span = device.device->span();
    if (device.carried() || (span != Span::point && span != Span::pose)) continue;
    const auto alike = [&](const PlacedDevice& other) {
      return other.type == device.type && other.params == device.params &&
             other.noise == device.noise && other.period == device.period &&
             other.exposure == device.exposure &&
             other.without_sight == device.without_sight;
    };
    if (std::none_of(kinds.begin(), kinds.end(), alike)) kinds.push_back(device);
  }
  return kinds;
}

/// Median distance between the point and what stands in the world, with two digits.
double usual_distance(const System& system, const Eigen::Vector3d& p) {
  std::vector<double> all;
  for (const PlacedDevice& device : system.devices)
    if (!device.carried()) all.push_back((device.X_WS().p - p).norm());
  const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
  std::nth_element(all.begin(), middle, all.end());
  if (*middle == 0) return 1;
  const double digit = std::pow(10, std::floor(std::log10(*middle)) - 1);
  return std::round(*middle / digit) * digit;
}

/// Of two places that do alike, the one above comes first.
std::vector<Eigen::Vector3d> places_around(const Eigen::Vector3d& p, double distance) {
  std::vector<Eigen::Vector3d> places;
  for (const int z : {1, 0, -1})
    for (const int y : {0, 1, -1})
      for (const int x : {0, 1, -1})
        if (x != 0 || y != 0 || z != 0)
          places.emplace_back(p + distance * Eigen::Vector3d(x, y, z));
  return places;
}

}  // namespace

std::optional<Mending> mend_by_one_device(const System& system,
                                          const PointReport& report,
                                          const Eigen::Vector3d& rpy,
                                          const Metric& metric, Solver solver) {
  const std::vector<PlacedDevice> kinds = kinds_of(system);
  if (report.state.status != RiccatiStatus::unobservable || kinds.empty()) return {};
  const Eigen::Vector3d& p = report.pose.p;
  Mending mending{.distance = usual_distance(system, p)};
  const Samples here{{p}, {{"", 0, 1, ScatteredShape{}}}};
  System more = system;
  for (const PlacedDevice& kind : kinds) {
    if (std::find(mending.types.begin(), mending.types.end(), kind.type) ==
        mending.types.end())
      mending.types.push_back(kind.type);
    more.devices.push_back(kind);
    for (const Eigen::Vector3d& at : places_around(p, mending.distance)) {
      more.devices.back().X_WS() = {rotation_from_aim(at, p), at};
      const Field field =
          evaluate_field(more, here, {{rpy}}, metric,
                         {.solver = solver, .threads = 1, .find_inside = false});
      const double value = field.value[0];
      if (!field.observable[0] || !std::isfinite(value)) continue;
      const double least_gain =
          mending.best ? kSameValue * std::abs(mending.best->value) : 0;
      if (mending.best &&
          (metric.larger_is_better ? value - mending.best->value
                                   : mending.best->value - value) <= least_gain)
        continue;
      mending.best = OneMoreDevice{kind.name, kind.type, at, value};
    }
    more.devices.pop_back();
  }
  return mending;
}

std::string words_of(const Mending& mending, const Metric& metric) {
  if (const auto& best = mending.best)
    return "one more " + best->type + " like " + best->like + " at " +
           coordinates(best->at) + " m would mend it: " + metric.name + " " +
           format_quantity(best->value, metric.unit);
  return "one more " + joined(mending.types, " or ") +
         " wouldn't mend it at any of 26 " + "places about " +
         format_quantity(mending.distance, "m") + " away";
}

}  // namespace delos::session
