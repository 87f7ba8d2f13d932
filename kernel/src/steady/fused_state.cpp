#include "delos/steady/fused_state.h"

namespace delos {

const char* to_string(CovarianceOf of) {
  switch (of) {
    case CovarianceOf::every_update:
      return "that of every update";
    case CovarianceOf::all_times:
      return "the same at all times";
    case CovarianceOf::time_average:
      return "the mean over time, by the trapezoid rule";
    case CovarianceOf::turn_average:
      return "the mean over the devices' turns";
    case CovarianceOf::summed_psi:
      return "what the sum of Ψ matrices gives: no filter's covariance";
  }
  return "";
}

}  // namespace delos
