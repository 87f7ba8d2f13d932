// What is given up for what: best designs for many limits, or for many devices.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "delos/optimize/optimize.h"

namespace delos {

/// The best design that was found under one limit.
struct FrontPoint {
  double limit = 0;        ///< SI
  double used = 0;         ///< what the design makes of it: limit less slack, SI
  double objective = 0;    ///< on all samples
  bool kept = false;       ///< all constraints are
  bool dominated = false;  ///< another point is as good in both, and better in one
  Scene scene;             ///< with the best values
};

/// Told how many searches are done.
using SearchesDone = std::function<void(std::size_t done, std::size_t of)>;

/// The front of the objective against the limit of one constraint (ε-constraint
/// method): at each level a search for the least objective, begun at the neighbour's
/// best design, from the loosest to the tightest. Then back: where a tighter limit has
/// found a better design than a looser one, which it keeps too, the search is repeated
/// from there. So the front is monotone.
///
/// Source: Haimes, Lasdon, Wismer (1971), IEEE Trans. SMC 1(3), 296–297.
/// @param constraint its name
/// @param levels     one or more, in any order
/// @returns a point a level, from the loosest to the tightest
/// @throws std::invalid_argument as optimize(); or there is no such constraint
[[nodiscard]] std::vector<FrontPoint> search_front(const Scene& given,
                                                   PluginRegistry& plugins,
                                                   const std::string& constraint,
                                                   std::vector<double> levels,
                                                   const OptimizeOptions& options,
                                                   const SearchesDone& progress = {});

/// The limit of a constraint, by its name: what its one number is, SI.
/// @throws std::invalid_argument there is none of that name
[[nodiscard]] double& constraint_limit(Scene& scene, const std::string& constraint);

/// The best design that was found for one number of devices.
struct DeviceCountPoint {
  std::size_t devices = 0;
  double price = 0;      ///< of all devices
  double objective = 0;  ///< on all samples
  bool kept = false;     ///< all constraints are
  std::vector<ConstraintReport> constraints;
  Scene scene;  ///< with the best values
};

/// Prices of devices, by name or by type; others cost 1.
using Prices = std::map<std::string, double>;
[[nodiscard]] double price_of(const Scene& scene, const Prices& prices);

/// The best designs of `from` to `to` devices.
///
/// The scene as it stands is searched first. Fewer: the device that is missed least is
/// left out, then all are searched for from where they stand; and so on. More: a copy
/// of the device, and among random values of its variables those that help most, are
/// added. At last neighbours are compared, and searched again where adding to the
/// smaller or taking from the larger kit gives a better design. So more devices are
/// never worse, where no constraint speaks against one more. All points have the fusion
/// of the scene as it stands; where rates vary and it doesn't say, continuous.
/// @returns a point for each number, the least first
/// @throws std::invalid_argument as optimize(); a device that the variables move moves
///         others with it; none has variables of its own; or too few would be left
[[nodiscard]] std::vector<DeviceCountPoint> search_counts(
    const Scene& given, PluginRegistry& plugins, std::size_t from, std::size_t to,
    const Prices& prices, const OptimizeOptions& options,
    const SearchesDone& progress = {});

/// The inverse question: the cheapest kit that keeps all constraints, such as "eigmax
/// at most 1 mm everywhere"; of equal prices the better one.
/// @returns null where none does
[[nodiscard]] const DeviceCountPoint* cheapest_kept(
    const std::vector<DeviceCountPoint>& points);

}  // namespace delos
