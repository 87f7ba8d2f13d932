// Who goes with whom.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace delos {

/// The one-to-one assignment of rows to columns whose costs have the least sum.
/// @param cost n×n
/// @returns the column of each row
/// @throws std::invalid_argument a cost isn't a number, or is above 1e300
/// @cost n³
///
/// Source: Jonker, Volgenant (1987), Computing 38, 325–340: shortest augmenting paths.
[[nodiscard]] std::vector<std::size_t> cheapest_assignment(const Eigen::MatrixXd& cost);

}  // namespace delos
