#include "delos/model/exposure_model.h"

#include <cmath>

namespace delos {

double motion_variance(ExposureModel model, int order, double exposure) {
  const int k = order;
  const double power = std::pow(exposure, 2 * k - 1);
  const auto factorial = [](int n) { return std::tgamma(n + 1.0); };
  const double of_mean = power / ((2 * k + 1) * factorial(k) * factorial(k)),
               of_end = power / ((2 * k - 1) * factorial(k - 1) * factorial(k - 1));
  switch (model) {
    case ExposureModel::exact:
      break;
    case ExposureModel::instantaneous:
      return of_end;
    case ExposureModel::averaged:
      return of_end / 4;
    case ExposureModel::integrated:
      return exposure * exposure * of_mean;
  }
  return of_mean;
}

}  // namespace delos
