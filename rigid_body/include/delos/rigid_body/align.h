// F2: a body's pose from its points, some of which may be false.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "delos/rigid_body/filter.h"

namespace delos::rigid_body {

/// The pose that brings the body's points nearest to those in the world, Σ‖R b + t −
/// w‖²: with the singular value decomposition U D Vᵀ of Σ (w − w̄)(b − b̄)ᵀ,
/// R = U diag(1, 1, |U||V|) Vᵀ, which is a rotation whatever the noise.
/// @pre equally many, three at least, the body's not in one line
/// Sources: Arun, Huang, Blostein (1987), IEEE TPAMI 9(5), 698–700; Umeyama (1991),
/// IEEE TPAMI 13(4), 376–380, Eqs. 40–43, without scale.
[[nodiscard]] BodyPose aligned(std::span<const Eigen::Vector3d> body,
                               std::span<const Eigen::Vector3d> world);

/// A pose, and the pairs that it is of.
struct Alignment {
  BodyPose pose;
  std::vector<std::size_t> kept;  ///< rising
};

/// The same of the largest set of pairs that agree within a distance: every three of
/// them are tried, so that half of them and more may be false.
/// @param within metres, of a pair
/// @returns nothing where fewer than three agree
[[nodiscard]] std::optional<Alignment> aligned_rejecting(
    std::span<const Eigen::Vector3d> body, std::span<const Eigen::Vector3d> world,
    double within);

}  // namespace delos::rigid_body
