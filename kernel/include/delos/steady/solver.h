// Which solver finds a steady state.
#pragma once

#include <stdexcept>
#include <string>

#include "delos/api.h"

namespace delos {

/// How a steady state is found.
enum class Solver {
  automatic,    ///< the fastest exact one
  spectral,     ///< pose-level measurements of a chain, one rate or continuous
  doubling,     ///< everything but artemis fusion
  eigenvector,  ///< the papers' method; stacked and artemis fusion, no perfect rows
};

[[nodiscard]] DELOS_API const char* to_string(Solver solver);

/// A solver that can't do the system.
class DELOS_API UnsuitableSolver : public std::invalid_argument {
 public:
  UnsuitableSolver(const std::string& problem, Solver instead);
  [[nodiscard]] const std::string& problem() const { return problem_; }
  [[nodiscard]] Solver instead() const { return instead_; }  ///< one that can

 private:
  std::string problem_;
  Solver instead_;
};

}  // namespace delos
