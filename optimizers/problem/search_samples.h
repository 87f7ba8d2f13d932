// The samples that a search looks at.
#pragma once

#include <functional>
#include <vector>

#include "delos/field/field.h"
#include "delos/sampling/samples.h"

namespace delos {

/// Samples, and what set of the scene each is of.
struct SearchSamples {
  Samples samples;
  std::vector<std::size_t> set;  ///< one a sample
  std::vector<double>
      multiplicity;  ///< one a sample: how many of its set it stands for
};

/// The field of an octree over a box.
using Octrees = std::function<Field(const AdaptiveSampling&)>;

/// Samples of the sets that the objective or a limit looks at.
/// @param most thin the largest sets evenly to about so many samples in all; 0: all
/// @param octrees adaptive sets become their nodes, each as much as its volume; null:
///                points spread evenly over their box, `most`, or a fine grid
[[nodiscard]] SearchSamples search_samples(const Scene& scene, std::size_t most,
                                           const Octrees& octrees = {});

/// Samples of all sets; adaptive ones become fine grids.
[[nodiscard]] Samples all_samples(const Scene& scene);

/// Weights of a term, one a sample, which sum to 1; 0 where `inside` a solid.
[[nodiscard]] std::vector<double> term_weights(
    const ObjectiveTerm& term, const Scene& scene, const SearchSamples& samples,
    const std::vector<unsigned char>& inside);

}  // namespace delos
