#include "problem/guess.h"

#include <algorithm>
#include <cmath>

#include "delos/field/evaluate.h"
#include "delos/model/symmetric.h"

namespace delos {

double typical_guess(const System& system, const Samples& samples,
                     const Orientations& orientations) {
  constexpr double kWorse = 100;
  constexpr std::size_t kBlocks = 16;  // poses of a few blocks are enough
  std::vector<TargetPose> poses = field_poses(samples, orientations);
  const std::size_t step = std::max<std::size_t>(1, poses.size() / (kBlocks * kLanes));
  std::vector<TargetPose> some;
  for (std::size_t i = 0; i < poses.size(); i += step) some.push_back(poses[i]);
  const InformationLayers layers(system, std::move(some), {.threads = 1});
  const auto stride =
      static_cast<std::size_t>(packed_index(information_size(system), 0)) * kLanes;
  const int size = system.motion.layout.block();
  if (size == 0) return 1;
  std::vector<double> known;
  LayerBlock scratch;
  for (std::size_t b = 0; b < layers.block_count(); ++b) {
    const LayerBlock& block = layers.block(b, scratch);
    for (std::size_t i = 0; i < system.devices.size(); ++i) {
      for (int lane = 0; lane < block.lanes; ++lane) {
        if (!(block.seen[i] >> lane & 1)) continue;
        StateMatrix S(size, size);
        for (int r = 0; r < size; ++r)
          for (int c = 0; c <= r; ++c)
            S(r, c) = S(c, r) =
                block.layers[i * stride + static_cast<std::size_t>(
                                              packed_index(r, c) * kLanes + lane)];
        const double largest = symmetric_eigenvalues(S)(size - 1);
        if (largest > 0) known.push_back(largest);
      }
    }
  }
  if (known.empty()) return 1;
  const auto middle = known.begin() + static_cast<std::ptrdiff_t>(known.size() / 2);
  std::nth_element(known.begin(), middle, known.end());
  return kWorse / std::sqrt(*middle);
}

double guess_information(const System& system, double sigma) {
  if (system.fusion == Fusion::sequential || system.fusion == Fusion::artemis) return 0;
  return information_weight(system, system.devices.front()) / (sigma * sigma);
}

}  // namespace delos
