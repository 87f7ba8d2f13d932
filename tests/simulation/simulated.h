// What tests ask of simulations.
#pragma once

#include <gtest/gtest.h>

#include "simulation/linear_systems.h"

namespace delos::test {

/// Every entry of the measured covariance is P∞'s within its own standard error times
/// `sigmas`: of the same normal errors, √((P_ii P_jj + P_ij²)/N).
inline void expect_predicted(const Simulation& s, double sigmas = 4.5) {
  for (const SimulatedCovariance& c : s.covariances) {
    const Eigen::Index n = c.predicted.rows();
    for (Eigen::Index i = 0; i < n; ++i)
      for (Eigen::Index j = 0; j <= i; ++j)
        EXPECT_NEAR(c.measured(i, j), c.predicted(i, j), sigmas * c.error(i, j))
            << c.name << " " << i << ", " << j;
  }
}

/// The filter's own covariance doesn't depend on the readings of a linear system: it is
/// P∞ but for what is left of the start, and so is the bound.
inline void expect_settled(const Simulation& s, double tolerance = 1e-3) {
  for (const SimulatedCovariance& c : s.covariances) {
    EXPECT_LT((c.filter - c.predicted).norm(), tolerance * c.predicted.norm())
        << c.name;
    ASSERT_EQ(c.bound.rows(), c.predicted.rows());
    EXPECT_LT((c.bound - c.predicted).norm(), tolerance * c.predicted.norm()) << c.name;
  }
}

}  // namespace delos::test
