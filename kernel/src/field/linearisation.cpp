#include "field/linearisation.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "delos/model/infinity.h"
#include "model/lower_root.h"
#include "observe/possible_readings.h"
#include "observe/reading_rows.h"

namespace delos {
namespace {

/// Of a standard deviation: derivatives, but not the noise of their differences.
constexpr double kStep = 1e-3;

/// P ← P − C S⁻¹ Cᵀ, unless a reading without noise says nothing new.
template <class Cross, class Innovations>
void take_moments(const Cross& C, const Innovations& S, StateMatrix& P) {
  const Eigen::LDLT<decltype(Observation::R)> split(S);
  if (!(split.vectorD().minCoeff() > 0)) return;
  const decltype(PredictedReading::H) K_transposed = split.solve(C.transpose());
  P -= C * K_transposed;
  P = ((P + P.transpose()) / 2).eval();
}

}  // namespace

double LinearisationCheck::largest_remainder(const ReadingModel& model,
                                             const TrackReading& reading,
                                             const Eigen::Matrix3d& R,
                                             const StateMatrix& L) {
  const StateLayout& layout = system_.motion.layout;
  const Eigen::Index n = L.rows();
  bent_.assign(static_cast<std::size_t>(middle_.z.size()), StateMatrix::Zero(n, n));
  variance_.assign(bent_.size(), 0);
  for (Eigen::Index k = 0; k < n; ++k) {
    // One side does where the other is out of view.
    double width = 0;
    const auto look = [&](double step, PredictedReading& out) {
      StateVector x = StateVector::Zero(n);
      Eigen::Matrix3d turned = R;
      move_state(layout, StateVector(step * L.col(k)), x, turned);
      const bool seen =
          model.predict(reading, x, turned, out) && out.z.size() == middle_.z.size();
      if (seen)
        width += std::abs(step);
      else
        out.H = middle_.H;
    };
    look(kStep, ahead_);
    look(-kStep, behind_);
    if (width == 0) continue;
    ahead_.R = middle_.R;
    ahead_.H -= behind_.H;
    std::size_t r = 0;
    each_row(ahead_, middle_.z, [&](const auto& h, double, double variance) {
      bent_[r].col(k) = L.transpose() * h.transpose() / width;
      variance_[r++] = variance;
    });
  }
  double largest = 0;
  for (std::size_t r = 0; r < bent_.size(); ++r) {
    const StateMatrix M = (bent_[r] + bent_[r].transpose()) / 2;
    const double mean = M.trace() / 2, square = mean * mean + M.squaredNorm() / 2;
    if (square > 0) largest = std::max(largest, square / variance_[r]);
  }
  return std::sqrt(largest);
}

void LinearisationCheck::update_both(const ReadingModel& model,
                                     const TrackReading& reading, double share,
                                     const Eigen::Matrix3d& R) {
  const StateVector x = StateVector::Zero(linear_.rows());
  const decltype(Observation::R) noise = middle_.R / share;
  decltype(UnscentedMoments::C) C = by_points_ * middle_.H.transpose();
  decltype(UnscentedMoments::S) S = middle_.H * C;
  if (unscented_moments(model, reading, middle_, x, R, by_points_, moments_)) {
    C = moments_.C;
    S = moments_.S;
  }
  S += noise;
  take_moments(C, S, by_points_);
  C = linear_ * middle_.H.transpose();
  S = middle_.H * C + noise;
  take_moments(C, S, linear_);
}

Linearisation LinearisationCheck::at(const TargetPose& pose, const StateMatrix& P) {
  if (!P.allFinite()) return {kInfinity, kInfinity};
  const Eigen::Index n = P.rows();
  const ReadingModel model(system_, pose, static_cast<int>(n));
  const StateMatrix L = lower_root(P);
  const StateVector x = StateVector::Zero(n);
  linear_ = by_points_ = P;
  Linearisation all;
  for (std::size_t d = 0; d < system_.devices.size(); ++d) {
    TrackReading reading{static_cast<int>(d), 0, 0, {0, static_cast<int>(n)}, {}};
    each_possible_reading(system_, system_.devices[d], pose, beacons_,
                          [&](int view, std::size_t of, double share, bool hidden) {
                            reading.view = view;
                            reading.of = of;
                            reading.without_sight = hidden;
                            if (!model.predict(reading, x, pose.R, middle_)) return;
                            all.nonlinearity =
                                std::max(all.nonlinearity,
                                         largest_remainder(model, reading, pose.R, L));
                            update_both(model, reading, share, pose.R);
                          });
  }
  const int of_pose = system_.motion.layout.block();
  const Eigen::Index block = of_pose > 0 ? of_pose : n;
  all.unscented_ratio = std::sqrt(by_points_.topLeftCorner(block, block).trace() /
                                  linear_.topLeftCorner(block, block).trace());
  return all;
}

}  // namespace delos
