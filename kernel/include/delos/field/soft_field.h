// Fields whose edges are soft, and how they change with the devices: for searches.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "delos/api.h"
#include "delos/model/metric.h"
#include "delos/model/pose.h"
#include "delos/rig/system.h"
#include "delos/sampling/samples.h"
#include "delos/steady/metric_slopes.h"

namespace delos {

/// Numbers of a field, or slopes of J with respect to them: metrics × samples.
using FieldValues = std::vector<std::vector<double>>;

/// Metrics of a system at samples, with soft edges of views and shadows, and the slopes
/// of any function J of them, by the adjoint: docs/theory.md, section "Derivatives".
///
///     S = Σ_i v_i S_i,   v = v_view v_shadow
///     v_view = 1/(1 + exp(−4 m/w)),   m the device's margin (SmoothRows)
///     v_shadow = 3x² − 2x³ up to 1,   x = 3 c/(w l),  c how far the sight line of
///                length l passes from what hides; 0 where it is hidden
///
/// with w = width. Coverage is Σ_i v_i; of several markers, Σ_i 1 − Π (1 − v). Eigmax
/// is replaced by (Σ λ^p)^(1/2p), p = 16, which has slopes where eigenvalues meet; it
/// is above eigmax by 3.5 % at most.
class DELOS_API SoftField {
 public:
  /// @pre slope_problem() is empty for every metric; none is coverage where the
  ///      information of several orientations is averaged, see combine
  SoftField(Samples samples, Orientations orientations, std::vector<Metric> metrics,
            int threads = 0);
  ~SoftField();

  /// @param width radians, about how wide edges are; 0: hard
  /// @param failing devices of the system, by index: what is left where each of them
  ///                alone fails is worked out too, and no device is asked again for it
  /// @returns +∞ where a metric has no finite value
  /// @pre the metrics are of the system's layout
  const FieldValues& evaluate(const System& system, double width,
                              std::span<const std::size_t> failing = {});

  /// The field last evaluated where each device that was `failing` fails: S − S_device.
  [[nodiscard]] std::span<const FieldValues> failure_values() const;

  /// Take over ∂J/∂value at the field last evaluated.
  /// @param of_failures with respect to failure_values(); empty: J doesn't depend on
  ///                    them
  void adjoin(const FieldValues& slopes, std::span<const FieldValues> of_failures = {});

  /// Of all devices. Exact where they have observe_smoothly(), else by central
  /// differences of each device's own information.
  [[nodiscard]] std::vector<PoseSlope> pose_slopes() const;

  /// Σ ⟨∂J/∂S_device, S_device⟩ + ∂J/∂v_device v_device over all poses, of a device of
  /// the system as it is or changed: its differences in anything that only this device
  /// depends on are those of J, to first order.
  [[nodiscard]] double contraction(std::size_t index, const PlacedDevice& device) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace delos
