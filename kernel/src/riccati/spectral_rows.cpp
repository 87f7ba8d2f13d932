// The spectral form from whitened rows, without squaring their condition number.
#include <Eigen/QR>
#include <cmath>
#include <limits>

#include "delos/riccati/spectral.h"
#include "model/epsilon.h"
#include "model/jacobi.h"
#include "riccati/directions.h"
#include "riccati/dispatch.h"

namespace delos {
namespace {

/// Rotate the columns of X until they are orthogonal: X W = U Σ (one-sided Jacobi).
template <int kSize>
void orthogonalise_columns(riccati::Square<kSize>& X) {
  for (int sweep = 0, rotations = 1; sweep < 40 && rotations > 0; ++sweep) {
    rotations = 0;
    for (int p = 0; p + 1 < kSize; ++p) {
      for (int q = p + 1; q < kSize; ++q) {
        const double x = X.col(p).dot(X.col(q));
        const double mp = X.col(p).squaredNorm(), mq = X.col(q).squaredNorm();
        if (x == 0 || x * x <= 4 * kEps * kEps * mp * mq) continue;
        ++rotations;
        const double h = mq - mp;
        const double t = 2 * x / (h + std::copysign(std::hypot(h, 2 * x), h));
        const double c = 1 / std::sqrt(1 + t * t), s = t * c;
        const Eigen::Matrix<double, kSize, 1> old = X.col(p);
        X.col(p) = c * old - s * X.col(q);
        X.col(q) = s * old + c * X.col(q);
      }
    }
  }
}

/// Replace column a of U by a unit vector orthogonal to columns [a+1, d).
template <int kSize>
void complete_column(riccati::Square<kSize>& U, int a) {
  using Column = Eigen::Matrix<double, kSize, 1>;
  Column best = Column::Zero();
  for (int axis = 0; axis < kSize; ++axis) {
    Column v = Column::Unit(axis);
    for (int pass = 0; pass < 2; ++pass)
      for (int b = a + 1; b < kSize; ++b) v -= U.col(b) * U.col(b).dot(v);
    if (v.squaredNorm() > best.squaredNorm()) best = v;
  }
  U.col(a) = best.normalized();
}

/// B = rows·L = Q R Πᵀ with column pivoting, then the columns of Rᵀ are made
/// orthogonal: Rᵀ W = U Σ, so BᵀB = (ΠU) Σ² (ΠU)ᵀ. Rᵀ is a well-conditioned matrix
/// times a graded diagonal, on which one-sided Jacobi keeps the small singular values.
/// Source: Drmač, Veselić (2008), SIAM J. Matrix Anal. Appl. 29(4), 1322–1342,
///         doi:10.1137/050639193.
template <int kSize>
SpectralForm reduce_rows(const CoordinateMatrix& L,
                         const Eigen::Ref<const Eigen::MatrixXd>& rows) {
  const auto factor = riccati::fixed<kSize>(L);
  Eigen::MatrixXd B =
      Eigen::MatrixXd::Zero(std::max<Eigen::Index>(rows.rows(), kSize), kSize);
  B.topRows(rows.rows()) = rows * factor;
  // A power of two, for products of four entries are formed.
  const double largest = B.cwiseAbs().maxCoeff();
  const double unit = std::sqrt(range_factor(largest * largest));
  B *= unit;
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(B);
  riccati::Square<kSize> X = riccati::Square<kSize>::Zero();
  X.template triangularView<Eigen::Lower>() =
      qr.matrixQR().topRows(kSize).transpose().template triangularView<Eigen::Lower>();
  orthogonalise_columns<kSize>(X);

  JacobiResult<kSize> r;
  r.lambda = X.colwise().norm().transpose();  // singular values until they are squared
  r.U = X;
  sort_ascending(r);

  SpectralForm form;
  const double least = riccati::kLeastEigenvalue<kSize> * r.lambda[kSize - 1];
  while (form.unobservable < kSize && !(r.lambda[form.unobservable] > least))
    r.lambda[form.unobservable++] = 0;
  for (int a = form.unobservable; a < kSize; ++a) r.U.col(a) /= r.lambda[a];
  for (int a = form.unobservable - 1; a >= 0; --a) complete_column<kSize>(r.U, a);
  form.lambda = (r.lambda / unit).cwiseAbs2();
  form.LU = factor * (qr.colsPermutation() * r.U);
  return form;
}

}  // namespace

SpectralForm spectral_form_of_rows(const CoordinateMatrix& L,
                                   const Eigen::Ref<const Eigen::MatrixXd>& rows) {
  return riccati::with_coordinates(
      L.rows(), [&]<int kSize>() { return reduce_rows<kSize>(L, rows); });
}

}  // namespace delos
