// Fields over an octree that is only as fine as the field needs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>

#include "delos/api.h"
#include "delos/field/evaluate.h"

namespace delos {

/// How an adaptive field decides, between nodes, on which side of a shadow's edge a
/// point lies. Edges of fields of view are exact where they are convex or the device
/// says where they run, by view_of_ball().
enum class ShadowEdges {
  nearest,  ///< as the nearest corner of its cell, which is as fine as `depth` allows
  exact,    ///< a ray for the point itself, where its cell leaves a doubt
};

/// Why refinement ended.
enum class AdaptiveStop { tolerance, depth, evaluations, deadline, cancelled };
[[nodiscard]] DELOS_API const char* to_string(AdaptiveStop stop);

/// How a field is sampled adaptively.
struct AdaptiveOptions {
  FieldOptions field;
  /// Called after each level with the field so far, coarse first.
  std::function<void(const Field&)> on_level;
  /// Points, away from the nodes, at which the error is measured at the end; 0: none.
  int held_back = 2000;
  /// About how many points the statistics over the volume are from, each evaluated. 0,
  /// or where that takes more than half of the evaluations that the sampling allows:
  /// none, and they are over the nodes.
  int spread = 16'000;
  std::uint64_t seed = 1;  ///< of the points
};

/// What adaptive sampling did.
struct AdaptiveReport {
  AdaptiveStop stop = AdaptiveStop::tolerance;
  int levels = 0;  ///< halvings of the smallest cell
  std::size_t leaves = 0;
  std::size_t nodes = 0;
  std::uint64_t rays = 0;  ///< sight lines that were looked along
  /// Sight lines that needn't be: whole cells were known to be clear or hidden.
  std::uint64_t rays_saved = 0;
};

/// A field over an octree.
///
/// Nodes hold what each device knows; cells, what they see as a whole. Between nodes
/// the *information* is interpolated, by triquadratic functions over each eight
/// siblings, and the metric solved from it: information is smooth where the metric has
/// kinks, and a blind point stays blind. Fields of view are tested at each point. At
/// nodes that hang on a coarser cell the coarser function holds, so that what is
/// continuous in the world is continuous here.
class DELOS_API AdaptiveField {
 public:
  AdaptiveField(AdaptiveField&&) noexcept;
  AdaptiveField& operator=(AdaptiveField&&) noexcept;
  ~AdaptiveField();

  /// The metric at the nodes, cells, weights by volume, and the error: the 95th
  /// percentile over held-back points of |interpolated/true − 1|, 1 where only one of
  /// the two is blind.
  [[nodiscard]] const Field& field() const;
  [[nodiscard]] const AdaptiveReport& report() const;

  /// The metric in between.
  /// @pre points are in the box
  [[nodiscard]] Field read(const Samples& samples,
                           ShadowEdges edges = ShadowEdges::nearest) const;

 private:
  friend DELOS_API AdaptiveField evaluate_adaptive(const System&,
                                                   const AdaptiveSampling&,
                                                   const Orientations&, const Metric&,
                                                   const AdaptiveOptions&);
  struct State;
  explicit AdaptiveField(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// Evaluate a metric over a box, level by level: estimate each leaf's error, mark what
/// is too coarse, halve it.
///
/// A leaf is too coarse where its parent interpolated the metric badly at its corners,
/// or where the edge of a shadow that matters may cross it. The result doesn't depend
/// on the number of threads. Cancelled, it is the field of the levels before.
/// @throws std::invalid_argument as make_steady_solver()
[[nodiscard]] DELOS_API AdaptiveField
evaluate_adaptive(const System& system, const AdaptiveSampling& sampling,
                  const Orientations& orientations, const Metric& metric,
                  const AdaptiveOptions& options = {});

}  // namespace delos
