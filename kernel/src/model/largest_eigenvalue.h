// The largest eigenvalue of a symmetric matrix of up to 3×3 in closed form.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "delos/model/lanes.h"
#include "delos/model/wide.h"
#include "model/jacobi.h"

namespace delos {

/// cos(φ/3) for φ in [0, π], from s = cos(φ/2).
///
/// x = cos(φ/3) solves (2x − 1) √((x + 1)/2) = s, which is steep everywhere, unlike
/// 4x³ − 3x = cos φ near φ = π. The start is within 2e-3; three of Newton's steps leave
/// nothing. Written without branches, for loops over many.
inline double cosine_of_third(double s) {
  double x = 0.5 + s * (0.57735 - 0.07735 * s);
  for (int step = 0; step < 3; ++step) {
    // F = (2x − 1) r − s,  r = √((x + 1)/2),  F′ = 2r + (2x − 1)/(4r)
    const double r = std::sqrt((x + 1) / 2), w = 2 * x - 1;
    x -= (w * r - s) * 4 * r / (8 * r * r + w);
  }
  return x;
}

/// λmax, and whether rounding has left it its digits.
struct LargestEigenvalue {
  double value;
  bool accurate;
};

/// λmax of P ≥ 0, packed by its lower triangle, from its characteristic polynomial:
///
///     λmax = m + 2 √p cos(φ/3),  m = tr P/3,  p = ‖P − m I‖²/6,
///     cos φ = det(P − m I)/(2 p^(3/2))
///
/// A sum of two terms ≥ 0. φ loses digits as cos φ → −1, where the two largest
/// eigenvalues meet. Source: Smith (1961), Commun. ACM 4(4), 168,
/// doi:10.1145/355578.366316.
inline LargestEigenvalue cubic_eigenvalue(double xx, double yx, double yy, double zx,
                                          double zy, double zz) {
  const double m = (xx + yy + zz) / 3;
  const double x = xx - m, y = yy - m, z = zz - m;
  const double p = (x * x + y * y + z * z + 2 * (yx * yx + zx * zx + zy * zy)) / 6;
  const double det =
      x * (y * z - zy * zy) - yx * (yx * z - zy * zx) + zx * (yx * zy - y * zx);
  const double root = std::sqrt(p);
  const double ratio = p > 0 ? det / (2 * p * root) : 1.0;
  const double cosine = std::min(1.0, std::max(-1.0, ratio));
  return {m + 2 * root * cosine_of_third(std::sqrt((1 + cosine) / 2)),
          cosine >= -0.999999};
}

/// λmax of P ≥ 0 by Jacobi's rotations: slower, and accurate everywhere.
inline double jacobi_eigenvalue(const Eigen::Matrix3d& P) {
  return jacobi_eigen<3>(P).lambda(2);
}

/// λmax of one matrix.
inline double largest_eigenvalue(const Eigen::Matrix<double, 1, 1>& P) {
  return P(0, 0);
}
/// λmax = m + √(d² + p²),  m = (a + c)/2,  d = (a − c)/2 of [a, p; p, c]
inline double largest_eigenvalue(const Eigen::Matrix2d& P) {
  const double d = (P(0, 0) - P(1, 1)) / 2, p = P(1, 0);
  return (P(0, 0) + P(1, 1)) / 2 + std::sqrt(d * d + p * p);
}
inline double largest_eigenvalue(const Eigen::Matrix3d& P) {
  const auto [value, accurate] =
      cubic_eigenvalue(P(0, 0), P(1, 0), P(1, 1), P(2, 0), P(2, 1), P(2, 2));
  return accurate ? value : jacobi_eigenvalue(P);
}

/// λmax of kLanes matrices whose packed elements are in rows[0] … rows[5].
inline void largest_eigenvalues(const double* const rows[6], double* out) {
  double accurate[kLanes];
  in_wide_vectors([&] {
    for (int l = 0; l < kLanes; ++l) {
      const LargestEigenvalue at = cubic_eigenvalue(rows[0][l], rows[1][l], rows[2][l],
                                                    rows[3][l], rows[4][l], rows[5][l]);
      out[l] = at.value;
      accurate[l] = at.accurate ? 1 : 0;
    }
  });
  for (int l = 0; l < kLanes; ++l) {
    if (accurate[l] == 1) continue;
    Eigen::Matrix3d P;
    P << rows[0][l], rows[1][l], rows[3][l],  //
        rows[1][l], rows[2][l], rows[4][l],   //
        rows[3][l], rows[4][l], rows[5][l];
    out[l] = jacobi_eigenvalue(P);
  }
}

}  // namespace delos
