// Flat cuts through a field, evaluated on themselves.
#pragma once

#include <vector>

#include "session/difference.h"
#include "session/drawn_field.h"

namespace delos::session {

/// A parallelogram origin + a·u + b·v, a and b in [0, 1], world, metres.
struct Section {
  Eigen::Vector3d origin, u, v;
};

/// The metric on cuts, at places of their own: nothing is interpolated between those of
/// the scene's samples.
/// @param most samples of each cut, about; they lie as far apart along u as along v
/// @throws std::invalid_argument as make_steady_solver()
[[nodiscard]] DrawnField draw_sections(const LoadedScene& loaded,
                                       const std::vector<Section>& sections,
                                       std::size_t most, const FieldOptions& options);

/// The same of a design minus what is kept to compare with, as draw_difference().
[[nodiscard]] DrawnField draw_difference_sections(const LoadedScene& loaded,
                                                  const Baseline& baseline,
                                                  const std::vector<Section>& sections,
                                                  std::size_t most,
                                                  const FieldOptions& options);

}  // namespace delos::session
