// Selections by `select`, against all choices and a solver that shares nothing with
// Delos: doubling of the filter's own recursion, reading by reading, in 80-bit numbers.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>
#include <random>
#include <sstream>

#include "delos/optimize/select.h"
#include "optimizers/scenes.h"

namespace delos::test {
namespace {

/// One reading of the state x: z = h x + v, v ~ N(0, r).
struct Reading {
  Eigen::RowVector3d h;
  double r;
};

/// A question: three states, some sensors, and what may be chosen.
struct SensorQuestion {
  Eigen::Matrix3d A, Q;
  std::vector<std::vector<Reading>> sensors;
  std::vector<double> cost;
  double budget = 0;
  bool by_count = true, posterior = false;
  bool decays = true;  ///< the state, by itself
  std::string metric;
};

/// P∞ by Π ↦ H + A Π (I + G Π)⁻¹ Aᵀ of one update, composed with itself. The first
/// map conditions (Q, A) on one reading after another: no R⁻¹ and no sum of HᵀR⁻¹H.
template <class Real>
class Oracle {
 public:
  using Matrix = Eigen::Matrix<Real, 3, 3>;
  using Row = Eigen::Matrix<Real, 1, 3>;

  explicit Oracle(const SensorQuestion& q)
      : question_(q), A_(q.A.cast<Real>()), Q_(q.Q.cast<Real>()) {}

  /// φ of the metric; +∞ where nothing bounds a variance, NaN where the digits are
  /// lost.
  double cost(const std::vector<Reading>& readings) const {
    if (!question_.decays && rank(readings) < 3)
      return std::numeric_limits<double>::infinity();
    const Matrix posterior = steady_posterior(readings);
    const Matrix prior = A_ * posterior * A_.transpose() + Q_;
    Matrix next = prior;
    for (const Reading& reading : readings) read(reading, next);
    if (!((next - posterior).norm() <= 1e-7 * posterior.norm()) ||
        !(posterior.diagonal().minCoeff() >= 0))
      return std::nan("");
    const Matrix& P = question_.posterior ? posterior : prior;
    if (question_.metric != "eigmax") return static_cast<double>(P.trace());
    return static_cast<double>(
        Eigen::SelfAdjointEigenSolver<Matrix>(P).eigenvalues()(2));
  }

 private:
  /// How many directions h, h A and h A² tell of, however little.
  int rank(const std::vector<Reading>& readings) const {
    std::vector<Row> basis;
    for (const Reading& reading : readings) {
      Row h = reading.h.cast<Real>();
      for (int power = 0; power < 3; ++power, h = h * A_) {
        Row rest = h;
        for (int pass = 0; pass < 2; ++pass)
          for (const Row& b : basis) rest -= rest.dot(b) * b;
        if (rest.norm() > 1e-12 * h.norm()) basis.push_back(rest.normalized());
      }
    }
    return static_cast<int>(basis.size());
  }

  /// What a reading makes of a covariance. @returns the gain
  static Eigen::Matrix<Real, 3, 1> read(const Reading& reading, Matrix& H) {
    const Row h = reading.h.cast<Real>();
    const Real r = reading.r, m = (h * H * h.transpose())(0) + r;
    const Eigen::Matrix<Real, 3, 1> K = H * h.transpose() / m;
    const Matrix keep = Matrix::Identity() - K * h;
    H = keep * H * keep.transpose() + r * K * K.transpose();
    return K;
  }

  Matrix steady_posterior(const std::vector<Reading>& readings) const {
    const Matrix I = Matrix::Identity();
    Matrix A = A_, G = Matrix::Zero(), H = Q_;
    for (const Reading& reading : readings) {
      const Row h = reading.h.cast<Real>(), seen = h * A;
      G += seen.transpose() * seen / ((h * H * h.transpose())(0) + Real(reading.r));
      A -= read(reading, H) * seen;
    }
    for (int doubling = 0; doubling < 64; ++doubling) {
      const Matrix W = (I + H * G).fullPivLu().solve(I);
      const Matrix more = A * W * H * A.transpose();
      G += A.transpose() * G * W * A;
      H += (more + more.transpose()) / 2;
      A = A * W * A;
      if (more.trace() <= 1e-18 * H.trace() && A.norm() < 1e-9) break;
    }
    return H;
  }

  const SensorQuestion& question_;
  Matrix A_, Q_;
};

using Draws = std::mt19937_64;

double drawn(Draws& draws, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(draws);
}
double log_drawn(Draws& draws, double low, double high) {
  return std::exp(drawn(draws, std::log(low), std::log(high)));
}

SensorQuestion sensor_question(std::uint64_t seed) {
  Draws draws(seed);
  const auto any = [&](int most) { return static_cast<int>(draws() % (most + 1)); };
  const auto entries = [&] {
    Eigen::Matrix3d m;
    for (double& x : m.reshaped()) x = drawn(draws, -1, 1);
    return m;
  };
  SensorQuestion q;
  const Eigen::Matrix3d B = entries();
  switch (seed % 5) {
    case 0:  // stable
      q.A = entries();
      q.A *= drawn(draws, 0.3, 0.98) / q.A.eigenvalues().cwiseAbs().maxCoeff();
      q.Q = B * B.transpose();
      break;
    case 1:  // most is forgotten at once
      q.A = Eigen::Vector3d(drawn(draws, 0.3, 0.98), 0, 0).asDiagonal();
      q.Q.setIdentity();
      break;
    case 2: {  // singular, in no axis
      const Eigen::Matrix3d C = entries();
      q.A = C.col(0) * C.row(1);
      q.A *= drawn(draws, 0.3, 0.98) / q.A.eigenvalues().cwiseAbs().maxCoeff();
      q.Q = B * B.transpose();
      break;
    }
    case 3: {  // an integrator chain, driven at its end
      const double dt = log_drawn(draws, 0.01, 1);
      q.A << 1, dt, dt * dt / 2, 0, 1, dt, 0, 0, 1;
      q.Q = Eigen::Vector3d(0, 0, log_drawn(draws, 1e-3, 1)).asDiagonal();
      break;
    }
    default:  // a random walk
      q.A.setIdentity();
      q.Q = Eigen::Vector3d(log_drawn(draws, 1e-3, 1), log_drawn(draws, 1e-3, 1),
                            log_drawn(draws, 1e-3, 1))
                .asDiagonal();
  }
  q.decays = seed % 5 < 3;
  q.Q = (q.Q + q.Q.transpose()).eval() / 2;
  const int n = 3 + any(3);
  q.by_count = any(1) == 0;
  for (int i = 0; i < n; ++i) {
    q.sensors.emplace_back();
    for (int rows = 1 + (any(3) == 0); rows > 0; --rows) {
      Reading reading;
      for (double& x : reading.h)
        x = any(3) == 0 ? 0 : (any(1) ? 1 : -1) * log_drawn(draws, 1e-3, 1e3);
      reading.r = log_drawn(draws, 1e-9, 1);
      q.sensors.back().push_back(reading);
    }
    q.cost.push_back(q.by_count ? 1 : drawn(draws, 0.5, 2));
  }
  q.budget = q.by_count ? 1 + any(2) : drawn(draws, 2, 4);
  q.posterior = any(1) == 0;
  q.metric = any(1) == 0 ? "trace" : any(1) ? "sigma_position" : "eigmax";
  return q;
}

std::string row_text(const Eigen::RowVectorXd& row) {
  std::ostringstream text;
  text.precision(17);
  for (Eigen::Index i = 0; i < row.size(); ++i) text << (i ? ", " : "[") << row(i);
  return text.str() + "]";
}

std::string matrix_text(const Eigen::MatrixXd& m) {
  std::string text;
  for (Eigen::Index i = 0; i < m.rows(); ++i)
    text += (i ? ", " : "[") + row_text(m.row(i));
  return text + "]";
}

std::string scene_text(const SensorQuestion& q) {
  std::ostringstream text;
  text.precision(17);
  text << "delos: 1\nmotion: {type: custom, A: " << matrix_text(q.A)
       << ", Q: " << matrix_text(q.Q)
       << "}\nsample: {points: [[0, 0, 0]]}\ncovariance: "
       << (q.posterior ? "posterior" : "prior") << "\ndevices:\n";
  std::string candidates;
  for (std::size_t i = 0; i < q.sensors.size(); ++i) {
    const auto& readings = q.sensors[i];
    Eigen::MatrixXd H(readings.size(), 3),
        R = Eigen::MatrixXd::Zero(H.rows(), H.rows());
    for (Eigen::Index k = 0; k < H.rows(); ++k) {
      H.row(k) = readings[static_cast<std::size_t>(k)].h;
      R(k, k) = readings[static_cast<std::size_t>(k)].r;
    }
    text << "  - {name: s" << i
         << ", type: linear, rate: 1 Hz, params: {H: " << matrix_text(H)
         << ", R: " << matrix_text(R) << "}}\n";
    std::ostringstream entry;
    entry.precision(17);
    entry << (i ? ", " : "") << "{devices: s" << i << ", cost: " << q.cost[i] << "}";
    candidates += entry.str();
  }
  text << "objective: {minimize: mean, of: " << q.metric << "}\nselection: {"
       << (q.by_count ? "count: " : "budget: ") << q.budget << ", candidates: ["
       << candidates << "]}\n";
  return text.str();
}

std::vector<Reading> readings_of(const SensorQuestion& q, std::uint32_t set) {
  std::vector<Reading> readings;
  for (std::size_t i = 0; i < q.sensors.size(); ++i)
    if (set >> i & 1)
      readings.insert(readings.end(), q.sensors[i].begin(), q.sensors[i].end());
  return readings;
}

/// The least cost of all choices that the budget allows, as far as 80 bits know it.
struct LeastCost {
  double cost = std::numeric_limits<double>::infinity();
  bool in_double = true;  ///< whether 64 bits say the same of all choices, to 1e-6
};

LeastCost least_cost(const SensorQuestion& q, const std::vector<Reading>& besides) {
  LeastCost least;
  for (std::uint32_t set = 1; set < (1U << q.sensors.size()); ++set) {
    double spent = 0;
    for (std::size_t i = 0; i < q.sensors.size(); ++i)
      if (set >> i & 1) spent += q.cost[i];
    if (spent > q.budget * (1 + 1e-12)) continue;
    std::vector<Reading> readings = readings_of(q, set);
    readings.insert(readings.end(), besides.begin(), besides.end());
    const double cost = Oracle<long double>(q).cost(readings),
                 rough = Oracle<double>(q).cost(readings);
    least.cost = std::min(least.cost, cost);
    if (!std::isinf(cost)) least.in_double &= std::abs(rough - cost) <= 1e-6 * cost;
  }
  return least;
}

// 500 questions with readings of 1e-3 to 1e3 per state and variances of 1e-9 to 1. A
// refusal is for questions of which a double can't answer all, but for one: a chain in
// whose doubling the digits of a P of 1e-12 are lost, though there are better ways.
TEST(Selections, AreThoseOfAnIndependentSolverHoweverUnlikeTheReadings) {
  int refused = 0, needlessly = 0, blind = 0;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    SCOPED_TRACE(seed);
    const SensorQuestion q = sensor_question(seed);
    const Scene scene = parse(scene_text(q));
    SelectOptions options;
    options.gap = 0;
    options.threads = 1;
    SelectResult result;
    LeastCost least = least_cost(q, {});
    try {
      result = select(scene, plugins(), options);
    } catch (const std::invalid_argument&) {
      ++refused;
      needlessly += least.in_double;
      continue;
    }
    std::uint32_t set = 0;
    for (const std::size_t i : result.chosen) set |= 1U << i;
    const bool root = q.metric != "trace";
    const auto phi = [&](double x) { return root ? x * x : x; };
    std::vector<Reading> chosen = readings_of(q, set);
    EXPECT_EQ(result.blind, std::isinf(least.cost) ? 1U : 0U);
    if (result.blind > 0) {
      ++blind;
      std::vector<Reading> guess;
      for (int i = 0; i < 3; ++i)
        guess.push_back({Eigen::RowVector3d::Unit(i), result.guess * result.guess});
      least = least_cost(q, guess);
      chosen.insert(chosen.end(), guess.begin(), guess.end());
    }
    const double cost = Oracle<long double>(q).cost(chosen);
    EXPECT_NEAR(phi(result.value), cost, 1e-6 * cost);
    EXPECT_LE(cost, least.cost * (1 + 1e-6));
    EXPECT_LE(phi(result.lower_bound), least.cost * (1 + 1e-6));
    EXPECT_GE(phi(result.lower_bound), least.cost * (1 - 1e-6));
    EXPECT_EQ(result.stop, SelectStop::proven);
  }
  EXPECT_LE(refused, 10);
  EXPECT_LE(needlessly, 1);
  EXPECT_GE(blind, 20);
}

}  // namespace
}  // namespace delos::test
