// A filter whose readings take time, by brute force in long double: with the
// integral of every reading under way as states of its own.
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <map>
#include <numeric>
#include <vector>

namespace delos::testing {

using LongMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

/// A device whose reading is H times the mean of the pose, and noise; times in ticks.
struct ExposingDevice {
  int period, exposure, phase = 0;
  LongMatrix H;  ///< m×d
  LongMatrix R;  ///< m×m
};

/// The steady state of a filter: after convergence, at each instant with an update.
struct ExposingFilter {
  std::vector<int> instants;                 ///< ticks after the cycle's begin, > 0
  std::vector<LongMatrix> prior, posterior;  ///< n×n, n = k d
  int length = 1;                            ///< of the cycle, ticks
  long double radius = 0;                    ///< of the errors after a whole cycle

  ExposingFilter(int order, const LongMatrix& q, long double tick,
                 const std::vector<ExposingDevice>& devices, int cycles = 3000)
      : order_(order), q_(q), tick_(tick), devices_(devices), n_(order * q.rows()) {
    const Eigen::Index N = n_ + q.rows() * static_cast<Eigen::Index>(devices.size());
    P_ = LongMatrix::Zero(N, N);
    P_.diagonal().head(n_).setOnes();
    for (const ExposingDevice& device : devices)
      length = std::lcm(length, device.period);
    for (int cycle = 0; cycle < cycles; ++cycle) {
      const LongMatrix before = P_;
      errors_ = LongMatrix::Identity(N, N);
      instants.clear(), prior.clear(), posterior.clear();
      for (int t = 0, next = 0; t < length; t = next) {
        while (!is_event(++next) && next < length) {
        }
        advance(t, next);
      }
      if (cycle > 2 && (P_ - before).norm() <= 1e-18L * P_.norm()) break;
    }
    radius =
        Eigen::EigenSolver<LongMatrix>(errors_).eigenvalues().cwiseAbs().maxCoeff();
  }

 private:
  /// Whether something that recurs is at tick t.
  static bool is_at(int t, int first, int period) {
    return ((t - first) % period + period) % period == 0;
  }
  /// Whether a window begins or ends at tick t.
  bool is_event(int t) const {
    for (const ExposingDevice& d : devices_)
      if (is_at(t, d.phase, d.period) || is_at(t + d.exposure, d.phase, d.period))
        return true;
    return false;
  }
  Eigen::Index integral(std::size_t device) const {
    return n_ + q_.rows() * static_cast<Eigen::Index>(device);
  }

  /// e^{Fδ} and ∫ e^{Fs} W e^{Fᵀs} ds over δ seconds: F is nilpotent, and the integrand
  /// a polynomial that five nodes integrate exactly.
  void make_step(const std::vector<bool>& open, long double delta, LongMatrix& A,
                 LongMatrix& Q) const {
    const Eigen::Index N = P_.rows(), d = q_.rows();
    LongMatrix F = LongMatrix::Zero(N, N), W = F;
    for (int i = 0; i + 1 < order_; ++i)
      F.block(i * d, (i + 1) * d, d, d).setIdentity();
    W.block(n_ - d, n_ - d, d, d) = q_;
    for (std::size_t i = 0; i < devices_.size(); ++i)
      if (open[i])
        F.block(integral(i), 0, d, d)
            .diagonal()
            .setConstant(1 / (devices_[i].exposure * tick_));
    const auto exponential = [&](long double s) {
      LongMatrix sum = LongMatrix::Identity(N, N), term = sum;
      for (int p = 1; p <= order_ + 1; ++p) {
        term = (term * F * (s / p)).eval();
        sum += term;
      }
      return sum;
    };
    A = exponential(delta);
    Q = LongMatrix::Zero(N, N);
    const long double a = std::sqrt(5 - 2 * std::sqrt(10.0L / 7)) / 3,
                      b = std::sqrt(5 + 2 * std::sqrt(10.0L / 7)) / 3;
    const long double wa = (322 + 13 * std::sqrt(70.0L)) / 900,
                      wb = (322 - 13 * std::sqrt(70.0L)) / 900;
    for (const auto& [node, weight] :
         {std::pair{0.0L, 128.0L / 225}, {a, wa}, {-a, wa}, {b, wb}, {-b, wb}}) {
      const LongMatrix E = exponential(delta * (1 + node) / 2);
      Q += weight * delta / 2 * E * W * E.transpose();
    }
  }

  /// From one event to the next.
  void advance(int from, int t) {
    const Eigen::Index d = q_.rows();
    // Windows that begin.
    for (std::size_t i = 0; i < devices_.size(); ++i) {
      const ExposingDevice& device = devices_[i];
      if (!is_at(from + device.exposure, device.phase, device.period)) continue;
      P_.middleRows(integral(i), d).setZero();
      P_.middleCols(integral(i), d).setZero();
      errors_.middleRows(integral(i), d).setZero();
    }
    std::vector<bool> open;
    for (const ExposingDevice& device : devices_) {
      bool is_open = false;
      for (int ahead = 0; ahead < device.exposure; ++ahead)
        is_open = is_open || is_at(t + ahead, device.phase, device.period);
      open.push_back(is_open);
    }
    auto& [A, Q] = steps_[{t - from, open}];
    if (A.size() == 0) make_step(open, (t - from) * tick_, A, Q);
    P_ = (A * P_ * A.transpose() + Q).eval();
    errors_ = (A * errors_).eval();

    const LongMatrix before = P_.topLeftCorner(n_, n_);
    bool read = false;
    for (std::size_t i = 0; i < devices_.size(); ++i) {
      const ExposingDevice& device = devices_[i];
      if (!is_at(t, device.phase, device.period)) continue;
      read = true;
      LongMatrix H = LongMatrix::Zero(device.H.rows(), P_.rows());
      H.middleCols(device.exposure > 0 ? integral(i) : 0, d) = device.H;
      const LongMatrix M = H * P_ * H.transpose() + device.R;
      const LongMatrix K = P_ * H.transpose() * M.inverse();
      const LongMatrix keep = LongMatrix::Identity(P_.rows(), P_.cols()) - K * H;
      P_ = (keep * P_ * keep.transpose() + K * device.R * K.transpose()).eval();
      errors_ = (keep * errors_).eval();
    }
    if (!read) return;
    instants.push_back(t);
    prior.push_back(before);
    posterior.push_back(P_.topLeftCorner(n_, n_));
  }

  int order_;
  LongMatrix q_;
  long double tick_;
  std::vector<ExposingDevice> devices_;
  Eigen::Index n_;
  LongMatrix P_, errors_;
  std::map<std::pair<int, std::vector<bool>>, std::pair<LongMatrix, LongMatrix>> steps_;
};

}  // namespace delos::testing
