// The motion of a rigid body's points over a time, on exponential maps.
#pragma once

#include <Eigen/Core>

namespace delos::rigid_body {

/// ω̃, with ω̃ p = ω × p.
[[nodiscard]] Eigen::Matrix3d skew(const Eigen::Vector3d& w);

/// Where a point p₀ of a body is after Δt that turns at ω about the origin of its
/// coordinates, moves at v and is accelerated by a, both constant:
///
///     p = W p₀ + V v + A a,   p' = ω × p + v + a t
///
///     W = I + sin(θΔt)/θ ω̃ + (1 − cos θΔt)/θ² ω̃²,   V = ∫ W dt,   A = ∫ V dt
///
/// with θ = ‖ω‖. Source: Dorfmüller-Ulhaas (2003), Theorem 1, Eqs. 3–6.
struct BodyMotion {
  Eigen::Matrix3d W, V, A;
};

/// @param w ω, radians a unit of time
/// @param dt Δt, in that unit
[[nodiscard]] BodyMotion body_motion(const Eigen::Vector3d& w, double dt);

/// ∂(W p)/∂ω, ∂(V p)/∂ω, ∂(A p)/∂ω, 3×3 each, for one p: a point, a velocity, an
/// acceleration.
///
/// All three are of F = c₀ I + c₁ ω̃ + c₂ ω̃²,
///
///     ∂(F p)/∂ω = −c₁ p̃ + c₂ [−(ω̃p)~ + (ωᵀp) I − p ωᵀ]
///                + (c₁′/θ) (ω̃p) ωᵀ + (c₂′/θ) (ω̃²p) ωᵀ,   c′ = dc/dθ
///
/// The bracket has the skew matrix *of the product*; the paper's last three equations
/// print a product of skew matrices in one of them, which isn't the derivative.
struct BodyMotionSlopes {
  Eigen::Matrix3d W, V, A;
};
[[nodiscard]] BodyMotionSlopes body_motion_slopes(const Eigen::Vector3d& w, double dt,
                                                  const Eigen::Vector3d& of_W,
                                                  const Eigen::Vector3d& of_V,
                                                  const Eigen::Vector3d& of_A);

}  // namespace delos::rigid_body
