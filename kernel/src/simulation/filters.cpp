#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <optional>

#include "delos/simulation/filter.h"
#include "observe/reading_rows.h"
#include "observe/unscented.h"

namespace delos {
namespace {

/// Take one row into a mean and its covariance: with s = h P hᵀ + r,
///
///     ν = z − h δ,   δ ← δ + P hᵀ ν/s,   P ← P − P hᵀ h P/s
///
/// @param z what is left of the reading, about δ = 0
/// @returns ν²/s, or nothing where the row says nothing new: s = 0
template <class Row>
std::optional<double> take_row(const Row& h, double z, double variance,
                               StateVector& delta, StateMatrix& P) {
  const Eigen::Index n = P.rows();
  Eigen::Index first = 0, last = n;  // most rows are about a few states
  while (first < n && h(first) == 0) ++first;
  while (last > first && h(last - 1) == 0) --last;
  double Ph[kMaxState], scale = 0;
  for (Eigen::Index i = 0; i < n; ++i) Ph[i] = 0;
  for (Eigen::Index j = first; j < last; ++j) {
    const double* column = P.data() + j * n;
    const double hj = h(j);
    for (Eigen::Index i = 0; i < n; ++i) Ph[i] += column[i] * hj;
  }
  double s = variance, nu = z;
  for (Eigen::Index j = first; j < last; ++j) {
    s += h(j) * Ph[j];
    nu -= h(j) * delta(j);
    scale += h(j) * h(j) * P(j, j);
  }
  // A row without noise that is known already.
  if (!(s > 1e-13 * scale) || s == 0) return std::nullopt;
  const double gain = 1 / s;
  for (Eigen::Index j = 0; j < n; ++j) {
    const double weight = gain * Ph[j];
    delta(j) += weight * nu;
    double* column = P.data() + j * n;
    for (Eigen::Index i = 0; i < n; ++i) column[i] -= weight * Ph[i];
  }
  return nu * nu * gain;
}

/// Linearised about a state that is δ away from the estimate's: z − h(x) + H δ is left
/// of a reading about the estimate.
template <class Left>
void take_reading(const PredictedReading& predicted, const Left& left,
                  StateVector& delta, StateMatrix& P, Innovation& sum) {
  each_row(predicted, left, [&](const auto& h, double z, double variance) {
    if (const auto nis = take_row(h, z, variance, delta, P)) {
      sum.nis += *nis;
      ++sum.rows;
    }
  });
}

/// Extended, and iterated: Gauss–Newton about its own result.
class ExtendedFilter final : public TrackFilter {
 public:
  explicit ExtendedFilter(int iterations) : iterations_(iterations) {}

  Innovation update(const ReadingModel& model, std::span<const TrackReading> readings,
                    TrackEstimate& estimate) const override {
    const StateLayout& layout = model.system().motion.layout;
    const Eigen::Index n = estimate.x.size();
    StateVector about = StateVector::Zero(n), delta = about;
    StateMatrix P;
    Innovation first;
    PredictedReading predicted;
    for (int i = 0; i < iterations_; ++i) {
      StateVector x = estimate.x;
      Eigen::Matrix3d R = estimate.R;
      move_state(layout, about, x, R);
      delta.setZero();
      P = estimate.P;
      Innovation sum;
      for (const TrackReading& reading : readings) {
        if (!model.predict(reading, x, R, predicted)) {
          ++sum.dropped;
          continue;
        }
        decltype(PredictedReading::z) left =
            model.difference(reading.device, reading.z, predicted.z);
        if (i > 0) left.noalias() += predicted.H * about;
        take_reading(predicted, left, delta, P, sum);
      }
      if (i == 0) first = sum;
      const bool settled =
          ((delta - about).array().square() <= 1e-8 * P.diagonal().array().max(0))
              .all();
      about = delta;
      if (settled) break;
    }
    move_state(layout, delta, estimate.x, estimate.R);
    estimate.P = P;
    return first;
  }

 private:
  int iterations_;
};

/// One reading after another: SCAAT.
class SequentialFilter final : public TrackFilter {
 public:
  Innovation update(const ReadingModel& model, std::span<const TrackReading> readings,
                    TrackEstimate& estimate) const override {
    Innovation sum;
    PredictedReading predicted;
    for (const TrackReading& reading : readings) {
      if (!model.predict(reading, estimate.x, estimate.R, predicted)) {
        ++sum.dropped;
        continue;
      }
      take_linearised(model, reading, predicted, estimate, sum);
    }
    return sum;
  }

  static void take_linearised(const ReadingModel& model, const TrackReading& reading,
                              const PredictedReading& predicted,
                              TrackEstimate& estimate, Innovation& sum) {
    StateVector delta = StateVector::Zero(estimate.x.size());
    const decltype(PredictedReading::z) left =
        model.difference(reading.device, reading.z, predicted.z);
    take_reading(predicted, left, delta, estimate.P, sum);
    move_state(model.system().motion.layout, delta, estimate.x, estimate.R);
  }
};

/// Unscented, reading by reading, by unscented_moments(). A reading that one of their
/// points doesn't see is taken as SequentialFilter does.
class UnscentedFilter final : public TrackFilter {
 public:
  Innovation update(const ReadingModel& model, std::span<const TrackReading> readings,
                    TrackEstimate& estimate) const override {
    Innovation sum;
    PredictedReading predicted;
    for (const TrackReading& reading : readings) {
      if (!model.predict(reading, estimate.x, estimate.R, predicted))
        ++sum.dropped;
      else if (!take(model, reading, predicted, estimate, sum))
        SequentialFilter::take_linearised(model, reading, predicted, estimate, sum);
    }
    return sum;
  }

 private:
  static bool take(const ReadingModel& model, const TrackReading& reading,
                   const PredictedReading& middle, TrackEstimate& estimate,
                   Innovation& sum) {
    UnscentedMoments of;
    if (!unscented_moments(model, reading, middle, estimate.x, estimate.R, estimate.P,
                           of))
      return false;
    of.S += middle.R;
    const Eigen::LDLT<decltype(PredictedReading::R)> split(of.S);
    if (!(split.vectorD().minCoeff() > 0)) return false;  // rows without noise
    const decltype(PredictedReading::z) nu =
        model.difference(reading.device, reading.z, middle.z) - of.mean;
    const decltype(PredictedReading::z) scaled = split.solve(nu);
    sum.nis += nu.dot(scaled);
    sum.rows += static_cast<int>(nu.size());
    move_state(model.system().motion.layout, StateVector(of.C * scaled), estimate.x,
               estimate.R);
    const decltype(PredictedReading::H) K_transposed = split.solve(of.C.transpose());
    StateMatrix P = estimate.P - of.C * K_transposed;
    estimate.P = (P + P.transpose()) / 2;
    return true;
  }
};

}  // namespace

TrackFilter::~TrackFilter() = default;

const char* to_string(FilterKind kind) {
  switch (kind) {
    case FilterKind::extended:
      return "extended";
    case FilterKind::iterated:
      return "iterated";
    case FilterKind::sequential:
      return "sequential";
    case FilterKind::unscented:
      return "unscented";
  }
  return "";
}

std::unique_ptr<const TrackFilter> make_filter(FilterKind kind) {
  switch (kind) {
    case FilterKind::extended:
      return std::make_unique<ExtendedFilter>(1);
    case FilterKind::iterated:
      return std::make_unique<ExtendedFilter>(8);
    case FilterKind::sequential:
      return std::make_unique<SequentialFilter>();
    case FilterKind::unscented:
      return std::make_unique<UnscentedFilter>();
  }
  return nullptr;
}

}  // namespace delos
