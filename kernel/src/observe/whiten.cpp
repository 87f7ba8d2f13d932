#include "observe/whiten.h"

#include <algorithm>

#include "delos/model/symmetric.h"

namespace delos {

IndependentNoise independent_noise(const decltype(Observation::R)& R) {
  const SymmetricEigen split = symmetric_eigen(R);
  IndependentNoise noise{split.vectors, split.values};
  const double largest = noise.variance(noise.variance.size() - 1);
  const double floor = std::max(
      std::numeric_limits<double>::min(),
      static_cast<double>(R.rows()) * std::numeric_limits<double>::epsilon() * largest);
  for (Eigen::Index i = 0; i < noise.variance.size(); ++i) {
    if (!(noise.variance(i) > floor)) noise.variance(i) = 0;
  }
  return noise;
}

}  // namespace delos
