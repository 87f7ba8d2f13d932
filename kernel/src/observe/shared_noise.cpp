#include "observe/shared_noise.h"

#include <cmath>

#include "observe/answers.h"

namespace delos {

// R = diag(v) + c 11ᵀ, so that with w = Σ 1/v_a and h̄ = Σ h_a/(v_a w), R^(−1/2) H has
// the rows
//
//   (h_a − κ h̄)/√v_a,   κ = 1 − 1/√(1 + c w)
//
// since (I + c u uᵀ)^(−1/2) = I − κ u uᵀ/w for u = diag(v)^(−1/2) 1, uᵀu = w.
void part_shared_noise(const PlacedDevice& placed, std::size_t stride,
                       std::vector<StateRow>& rows) {
  if (rows.empty()) return;
  const Eigen::Vector3d shared = placed.noise * placed.device->shared_variance();
  for (std::size_t r = 0; r < stride; ++r) {
    const double c = r < 3 ? shared(static_cast<Eigen::Index>(r)) : 0.0;
    if (c == 0) continue;
    double w = 0;
    decltype(StateRow::h) mean = decltype(StateRow::h)::Zero(rows.front().h.size());
    for (std::size_t a = r; a < rows.size(); a += stride) {
      rows[a].variance -= c;
      if (!(rows[a].variance > 0))
        blame(placed, "shares more noise between points than a reading has");
      w += 1 / rows[a].variance;
      mean += rows[a].h / rows[a].variance;
    }
    mean *= (1 - 1 / std::sqrt(1 + c * w)) / w;
    for (std::size_t a = r; a < rows.size(); a += stride) rows[a].h -= mean;
  }
}

}  // namespace delos
