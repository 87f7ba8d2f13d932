// Whether a sampling is fine enough: the observed order of accuracy.
#pragma once

#include <cstddef>
#include <vector>

#include "delos/api.h"
#include "delos/field/evaluate.h"

namespace delos {

/// A field read between its samples at one resolution.
struct Resolution {
  /// Between samples, metres; of an octree, the edge of the cube that each has.
  double spacing = 0;
  std::size_t evaluations = 0;
  /// Discretisation error: root mean square over random points of what is read less
  /// what is solved there, in the metric's unit, where both are finite.
  double error = 0;
};

/// Three resolutions of one sampling, coarse first.
///
///     DE = C hᵖ + …,   p = ln(DE₂/DE₁)/ln(h₂/h₁)
///
/// Source: Allen (2007), Eq. 54–55.
struct Verification {
  std::vector<Resolution> resolutions;
  /// p from the coarsest to the one between, and from there to the finest; not finite
  /// where both have the same samples or no error.
  double first_order = 0, second_order = 0;
};

/// Verify a volume or plane at four times, twice and once its spacing, read by linear
/// interpolation of the metric; an adaptive volume at sixteen times, four times and
/// once its tolerance, with two levels less, one and none, read as it reads itself.
/// @returns no resolutions where the set is neither, has fewer than five samples along
///          an axis, or was cancelled
[[nodiscard]] DELOS_API Verification verify_sampling(const System& system,
                                                     const SampleSet& set,
                                                     const Orientations& orientations,
                                                     const Metric& metric,
                                                     const FieldOptions& options = {});

}  // namespace delos
