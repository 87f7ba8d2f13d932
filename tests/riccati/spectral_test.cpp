// The spectral form itself: eigenvalues of wide range, lost directions, rows.
#include "delos/riccati/spectral.h"

#include <gtest/gtest.h>

#include "delos/model/lanes.h"
#include "riccati/long_double.h"
#include "riccati/systems.h"

namespace delos {
namespace {

using testing::Draw;
using testing::kEps;
using testing::LongMatrix;

const Sampling kSampling{false, 0.02};

/// Eigenvalues of a symmetric matrix in long double, ascending.
Eigen::Matrix<long double, Eigen::Dynamic, 1> long_eigenvalues(const LongMatrix& m) {
  return Eigen::SelfAdjointEigenSolver<LongMatrix>(m, Eigen::EigenvaluesOnly)
      .eigenvalues();
}

class Spectral : public ::testing::TestWithParam<int> {};  // d

// U Λ Uᵀ = LᵀSL and the orthogonality of U, through q = (LU)(LU)ᵀ.
TEST_P(Spectral, FormReproducesBothMatrices) {
  const int d = GetParam();
  Draw draw(d);
  for (int i = 0; i < 1000; ++i) {
    const Eigen::MatrixXd q = draw.spd(d, -3, 3), S = draw.spd(d, -3, 3);
    const CoordinateMatrix L = testing::cholesky(q);
    const SpectralForm f = spectral_form(L, S);
    ASSERT_EQ(f.unobservable, 0);
    ASSERT_TRUE(std::is_sorted(f.lambda.begin(), f.lambda.end()));
    ASSERT_LT(testing::relative(f.LU * f.LU.transpose(), q), 20 * kEps);
    // (LU)⁻ᵀ Λ (LU)⁻¹ = S, multiplied out.
    const Eigen::MatrixXd M = L.transpose() * S * L;
    const Eigen::MatrixXd U =
        L.triangularView<Eigen::Lower>().solve(Eigen::MatrixXd(f.LU));
    ASSERT_LT(testing::relative(U * f.lambda.asDiagonal() * U.transpose(), M),
              50 * kEps * std::sqrt(testing::condition(q)));
  }
}

// Graded diagonals: Jacobi keeps the relative accuracy of every eigenvalue where an
// algorithm that is only norm-wise stable loses ε λmax/λ. S = D C D with cond(C) ~ 10.
// Reference: the same in long double, whose own error 2^−64·cond stays below 1e-13.
TEST_P(Spectral, KeepsSmallEigenvaluesOfGradedMatrices) {
  const int d = GetParam();
  Draw draw(10 + d);
  for (int i = 0; i < 200; ++i) {
    Eigen::VectorXd D(d);
    for (int j = 0; j < d; ++j) D[j] = std::exp2(std::round(-10.0 * j / (d - 1)));
    const Eigen::MatrixXd S = D.asDiagonal() * draw.spd(d, 0, 1) * D.asDiagonal();
    const SpectralForm f = spectral_form(CoordinateMatrix::Identity(d, d), S);
    const auto reference = long_eigenvalues(S.cast<long double>());
    for (int j = 0; j < d; ++j)
      ASSERT_NEAR(f.lambda[j] / double(reference[j]), 1, 100 * kEps)
          << "eigenvalue " << j;
  }
}

// The one-sided way, with cond(BᵀB) up to 1e20 in general position: the relative error
// of λ_i is at most c ε √cond. Reference: singular values of the same product in long
// double.
TEST_P(Spectral, RowsKeepTheSmallestEigenvalueAtCondition1e20) {
  const int d = GetParam();
  Draw draw(20 + d);
  double worst = 0;
  for (int i = 0; i < 200; ++i) {
    const double decades = draw.uniform(0, 10);  // of √cond
    Eigen::VectorXd sigma(d);
    for (int j = 0; j < d; ++j) sigma[j] = std::pow(10, -decades * j / (d - 1));
    const int m = 2 * d + 3;
    const Eigen::MatrixXd rows = draw.rotation(m).leftCols(d) * sigma.asDiagonal() *
                                 draw.rotation(d).transpose();
    const CoordinateMatrix L = testing::cholesky(draw.spd(d, -1, 1));
    const SpectralForm f = spectral_form_of_rows(L, rows);
    ASSERT_EQ(f.unobservable, 0) << "cond 1e" << 2 * decades;

    // Singular values of the exact product in long double: error 2^−64·√cond, a
    // thousandth of the bound.
    const LongMatrix B = rows.cast<long double>() * L.cast<long double>();
    Eigen::JacobiSVD<LongMatrix, Eigen::HouseholderQRPreconditioner> svd(B);
    for (int j = 0; j < d; ++j) {
      const double s = static_cast<double>(svd.singularValues()[d - 1 - j]);
      const double error = std::abs(f.lambda[j] / (s * s) - 1);
      const double bound = 40 * kEps * double(svd.singularValues()[0]) / s;
      worst = std::max(worst, error / bound);
      ASSERT_LT(error, bound) << "eigenvalue " << j << ", cond 1e" << 2 * decades;
    }
    // Directions: q = (LU)(LU)ᵀ, and rows·(LU) has orthogonal columns of length √λ.
    ASSERT_LT(testing::relative(f.LU * f.LU.transpose(), L * L.transpose()), 50 * kEps);
    const LongMatrix seen = rows.cast<long double>() * f.LU.cast<long double>();
    for (int j = 0; j < d; ++j)
      ASSERT_NEAR(double(seen.col(j).squaredNorm()) / f.lambda[j], 1,
                  80 * kEps * std::sqrt(f.lambda[d - 1] / f.lambda[j]));
  }
  RecordProperty("worst_of_bound", std::to_string(worst));
}

// The same system by both ways where squaring the condition does no harm.
TEST_P(Spectral, RowsAgreeWithTheirSum) {
  const int d = GetParam();
  Draw draw(30 + d);
  for (int m : {d, d + 1, 40}) {
    const Eigen::MatrixXd rows = draw.matrix(m, d);
    const CoordinateMatrix L = testing::cholesky(draw.spd(d));
    const SpectralForm a = spectral_form_of_rows(L, rows);
    const SpectralForm b = spectral_form(L, CoordinateMatrix(rows.transpose() * rows));
    for (int k = 1; k <= 3; ++k)
      EXPECT_LT(testing::relative(
                    spectral_covariance(a, k, kSampling, CovarianceKind::prior),
                    spectral_covariance(b, k, kSampling, CovarianceKind::prior)),
                d * kEps * b.lambda[d - 1] / b.lambda[0] * 10);
  }
}

// Fewer rows than coordinates, rows of zeros, no rows: the lost directions are counted
// and are those that no row sees.
TEST_P(Spectral, CountsWhatRowsDoNotSee) {
  const int d = GetParam();
  Draw draw(40 + d);
  const CoordinateMatrix L = testing::cholesky(draw.spd(d));
  for (int seen = 0; seen < d; ++seen) {
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(seen + 2, d);
    rows.topRows(seen) = draw.matrix(seen, d);
    for (const SpectralForm& f :
         {spectral_form_of_rows(L, rows),
          spectral_form(L, CoordinateMatrix(rows.transpose() * rows))}) {
      ASSERT_EQ(f.unobservable, d - seen);
      EXPECT_EQ(f.lambda.head(d - seen), CoordinateVector::Zero(d - seen));
      EXPECT_LE((rows * f.LU.leftCols(d - seen)).norm(),
                1e-13 * rows.norm() * L.norm());
      EXPECT_LT(testing::relative(f.LU * f.LU.transpose(), L * L.transpose()), 1e-14);
    }
  }
  EXPECT_EQ(spectral_form_of_rows(L, Eigen::MatrixXd(0, d)).unobservable, d);
}

TEST_P(Spectral, NoInformationLosesEverything) {
  const int d = GetParam();
  const CoordinateMatrix L = CoordinateMatrix::Identity(d, d);
  const SpectralForm f = spectral_form(L, CoordinateMatrix::Zero(d, d));
  EXPECT_EQ(f.unobservable, d);
  for (int k = 1; k <= 3; ++k)
    EXPECT_EQ(spectral_covariance(f, k, kSampling, CovarianceKind::prior),
              StateMatrix::Zero(d * k, d * k));
}

// The threshold: 16 d ε λmax and below is lost, what is clearly above is kept.
TEST_P(Spectral, ThresholdIsThatOfTheHeader) {
  const int d = GetParam();
  CoordinateMatrix S = CoordinateMatrix::Identity(d, d);
  S(1, 1) = 15.9 * d * kEps;
  EXPECT_EQ(spectral_form(CoordinateMatrix::Identity(d, d), S).unobservable, 1);
  S(1, 1) = 16.1 * d * kEps;
  EXPECT_EQ(spectral_form(CoordinateMatrix::Identity(d, d), S).unobservable, 0);
}

// Expected: the full covariance's corner.
TEST_P(Spectral, PoseCovarianceIsTheCorner) {
  const int d = GetParam();
  Draw draw(50 + d);
  const SpectralForm f = spectral_form(testing::cholesky(draw.spd(d)), draw.spd(d));
  for (const Sampling& sampling : {kSampling, Sampling{true, 0}})
    for (int k = 1; k <= 3; ++k)
      for (CovarianceKind kind : {CovarianceKind::prior, CovarianceKind::posterior})
        EXPECT_LT(testing::relative(
                      spectral_pose_covariance(f, k, sampling, kind),
                      spectral_covariance(f, k, sampling, kind).topLeftCorner(d, d)),
                  4 * kEps);
}

// Many poses side by side against each by itself, lost directions among them.
TEST_P(Spectral, LanesAgreeWithSinglePoses) {
  const int d = GetParam(), entries = packed_index(d, 0);
  Draw draw(60 + d);
  const CoordinateMatrix L = testing::cholesky(draw.spd(d, -1, 1));
  std::vector<double> S(static_cast<std::size_t>(entries) * kLanes), P(S.size());
  std::vector<CoordinateMatrix> poses;
  for (int l = 0; l < kLanes; ++l) {
    Eigen::MatrixXd at = draw.spd(d, -3, 3);
    if (l == 5) at.setZero();
    if (l == 6) at = Eigen::VectorXd::Unit(d, 1) * Eigen::RowVectorXd::Unit(d, 1);
    if (l == 7) at.setIdentity();
    poses.emplace_back(at);
    for (int i = 0; i < d; ++i)
      for (int j = 0; j <= i; ++j)
        S[static_cast<std::size_t>(packed_index(i, j) * kLanes + l)] = at(i, j);
  }
  for (const Sampling& sampling : {kSampling, Sampling{true, 0}}) {
    for (int k = 1; k <= 3; ++k) {
      for (CovarianceKind kind : {CovarianceKind::prior, CovarianceKind::posterior}) {
        int lost[kLanes];
        spectral_pose_covariances(L, k, sampling, kind, S.data(), P.data(), lost);
        for (int l = 0; l < kLanes; ++l) {
          const SpectralForm form =
              spectral_form(L, poses[static_cast<std::size_t>(l)]);
          ASSERT_EQ(lost[l], form.unobservable) << "lane " << l;
          if (lost[l] > 0) continue;
          const CoordinateMatrix expected =
              spectral_pose_covariance(form, k, sampling, kind);
          // Both form M = LᵀSL, whose rounding reaches the smallest eigenvalue.
          const double tolerance = 10 * kEps * form.lambda[d - 1] / form.lambda[0];
          for (int i = 0; i < d; ++i)
            for (int j = 0; j <= i; ++j)
              ASSERT_NEAR(P[static_cast<std::size_t>(packed_index(i, j) * kLanes + l)],
                          expected(i, j), tolerance * expected.norm());
        }
      }
    }
  }
}

// Squares of what is formed leave the range of a double: a power of two more or less
// changes the eigenvalues by it and nothing else.
TEST_P(Spectral, HoldsForInformationOfAnySize) {
  const int d = GetParam();
  Draw draw(60 + d);
  const CoordinateMatrix L = testing::cholesky(draw.spd(d, -1, 1));
  const Eigen::MatrixXd S = draw.spd(d, -3, 3);
  const SpectralForm one = spectral_form(L, S);
  // As below: the rounding of M = LᵀSL reaches the smallest eigenvalue.
  const double tolerance = 10 * kEps * one.lambda[d - 1] / one.lambda[0];
  for (const int exponent : {-900, -600, 600, 900}) {
    const double factor = std::ldexp(1.0, exponent);
    const SpectralForm form = spectral_form(L, factor * S);
    for (int j = 0; j < d; ++j)
      ASSERT_EQ(form.lambda[j], factor * one.lambda[j]) << exponent;
    ASSERT_EQ(form.LU, one.LU);

    std::vector<double> lanes(packed_index(d, 0) * kLanes), P(lanes.size());
    for (int i = 0; i < d; ++i)
      for (int j = 0; j <= i; ++j)
        for (int l = 0; l < kLanes; ++l)
          lanes[static_cast<std::size_t>(packed_index(i, j) * kLanes + l)] =
              (l % 2 == 0 ? factor : 1) * S(i, j);
    int lost[kLanes];
    spectral_pose_covariances(L, 2, kSampling, CovarianceKind::prior, lanes.data(),
                              P.data(), lost);
    for (int l = 0; l < 4; ++l) {
      ASSERT_EQ(lost[l], 0);
      const CoordinateMatrix expected = spectral_pose_covariance(
          l % 2 == 0 ? form : one, 2, kSampling, CovarianceKind::prior);
      for (int i = 0; i < d; ++i)
        for (int j = 0; j <= i; ++j)
          ASSERT_NEAR(P[static_cast<std::size_t>(packed_index(i, j) * kLanes + l)],
                      expected(i, j), tolerance * expected.norm())
              << exponent << " lane " << l;
    }
  }
}

TEST_P(Spectral, HoldsForRowsOfAnySize) {
  const int d = GetParam();
  Draw draw(70 + d);
  const CoordinateMatrix L = testing::cholesky(draw.spd(d, -1, 1));
  const Eigen::MatrixXd rows = draw.matrix(d + 2, d);
  const SpectralForm one = spectral_form_of_rows(L, rows);
  for (const int exponent : {-450, -300, 300, 450}) {
    const double factor = std::ldexp(1.0, exponent);
    const SpectralForm form = spectral_form_of_rows(L, factor * rows);
    for (int j = 0; j < d; ++j)
      ASSERT_NEAR(form.lambda[j] / factor / factor, one.lambda[j],
                  10 * kEps * one.lambda[j])
          << exponent;
    ASSERT_LT(testing::relative(form.LU, one.LU), 100 * kEps) << exponent;
  }
}

INSTANTIATE_TEST_SUITE_P(Coordinates, Spectral, ::testing::Values(2, 3, 6));

}  // namespace
}  // namespace delos
