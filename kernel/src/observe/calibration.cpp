#include "observe/calibration.h"

#include <algorithm>
#include <string>

#include "observe/answers.h"

namespace delos {
namespace {

/// What a row counts.
double weight_of(RowWeights weights, const StateRow& row) {
  return weights == RowWeights::plain ? row.share : row.weight();
}

/// G of an answer that is in the scratch: += Hᵀ R⁻¹ J.
/// @param fill fill(row of H, its variance, row over the state)
template <class Fill>
void add_answer(RowWeights weights, CalibrationScratch& scratch, Fill&& fill) {
  const Observation& seen = scratch.measure.observation;
  const IndependentNoise split = independent_noise(seen.R);
  StateRow& row = scratch.measure.row;
  for (Eigen::Index i = 0; i < seen.z.size(); ++i) {
    const Eigen::Matrix<double, 1, Eigen::Dynamic, Eigen::RowMajor, 1, kMaxState> h =
        split.directions.col(i).transpose() * seen.H;
    fill(h, split.variance(i), row);
    scratch.G.noalias() += weight_of(weights, row) * row.h.transpose() *
                           (split.directions.col(i).transpose() * scratch.J);
  }
}

/// The same of markers that share a part of their noise, which their rows and what
/// their errors do are freed of together.
/// @param errors errors(turns): J of the answer in the scratch
template <class Errors>
void add_shared(const System& system, const PlacedDevice& placed,
                const TargetPose& X_WT, RowWeights weights, Errors&& errors,
                CalibrationScratch& scratch) {
  MeasureScratch& measure = scratch.measure;
  const Eigen::Index c = measure.row.h.size();
  measure.rows.clear();
  std::size_t stride = 0;
  each_marker(system, placed, X_WT, measure, [&](const Eigen::Vector3d& arm) {
    const Observation& seen = measure.observation;
    errors(false);
    const Eigen::Index k = scratch.J.cols();
    if (c + k > kMaxState)
      blame(placed, "has more errors of calibration than are kept beside the state");
    stride = static_cast<std::size_t>(seen.z.size());
    for (Eigen::Index r = 0; r < seen.z.size(); ++r) {
      fill_point_row(system, placed, arm, seen.H.row(r), seen.R(r, r), measure.row);
      StateRow whole = measure.row;
      whole.h.conservativeResize(c + k);
      whole.h.tail(k) = scratch.J.row(r);
      measure.rows.push_back(whole);
    }
  });
  if (weights == RowWeights::information)
    part_shared_noise(placed, stride, measure.rows);
  for (const StateRow& row : measure.rows)
    scratch.G.noalias() += weight_of(weights, row) * row.h.head(c).transpose() *
                           row.h.tail(row.h.size() - c);
}

/// G of one device in the scratch, c×k.
/// @param errors errors(turns): J of the answer in the scratch, and a G of its size
template <class Errors>
void add_device(const System& system, const PlacedDevice& placed,
                const TargetPose& X_WT, RowWeights weights, Errors&& errors,
                CalibrationScratch& scratch) {
  MeasureScratch& measure = scratch.measure;
  if (placed.device->span() != Span::point) {
    if (const auto view = look_at_motion(system, placed, X_WT, measure)) {
      errors(true);
      add_answer(weights, scratch, [&](const auto& h, double variance, StateRow& row) {
        fill_motion_row(system, placed, *view, h, variance, row);
      });
    }
  } else if (shares_noise(placed)) {
    add_shared(system, placed, X_WT, weights, errors, scratch);
  } else {
    each_marker(system, placed, X_WT, measure, [&](const Eigen::Vector3d& arm) {
      errors(false);
      add_answer(weights, scratch, [&](const auto& h, double variance, StateRow& row) {
        fill_point_row(system, placed, arm, h, variance, row);
      });
    });
  }
}

/// The same of a device on the target. A target that turns about its origin moves what
/// it carries, so that of the device alone is left
///
///     h_φ = h_θ − arm × h_p
void add_beacons(const System& system, const PlacedDevice& placed,
                 const TargetPose& X_WT, RowWeights weights,
                 const ErrorColumns& columns, CalibrationScratch& scratch) {
  const Calibration& known = placed.calibration;
  const int d = system.motion.layout.coordinates();
  const int turns = system.motion.layout.positions();
  const Pose X_WS = X_WT * placed.carried()->X_TS;
  const Eigen::Vector3d arm = X_WS.p - X_WT.p;
  scratch.J.setZero(1, columns.size);
  auto j = scratch.J.row(0);
  each_used_row(
      scratch.measure.beacons.see(system, placed, X_WT),
      [&](const BeaconSighting& s, const SightingRow& r) {
        const Eigen::Map<const Eigen::RowVectorXd> h(r.h, d);
        const Eigen::Vector3d h_p = turns == 3
                                        ? Eigen::Vector3d(h.head<3>().transpose())
                                        : Eigen::Vector3d::Zero();
        if (columns.place >= 0)
          j.segment<3>(columns.place) =
              (X_WS.R.transpose() * h_p).cwiseProduct(known.place).transpose();
        if (columns.delay >= 0)
          j.segment<3>(columns.delay) =
              -lag_along_an_axis(system, known) * h_p.transpose();
        if (columns.orientation >= 0)
          j.segment<3>(columns.orientation) =
              (X_WS.R.transpose() * (h.segment<3>(turns).transpose() - arm.cross(h_p)))
                  .cwiseProduct(known.orientation)
                  .transpose();
        const double weight = weights == RowWeights::plain ? 1 : 1 / r.variance;
        scratch.G.topRows(d).noalias() += h.transpose() * (s.share * weight) * j;
      });
}

/// A row over the state of which devices fill in what they measure.
void begin(const System& system, const PlacedDevice& placed,
           CalibrationScratch& scratch) {
  const int c = information_size(system);
  StateRow& row = scratch.measure.row;
  row.h.setZero(c);
  row.share = 1;
  if (placed.clock) row.h(*placed.clock) = 1;
  scratch.G.resize(c, 0);
}

/// @throws DeviceFault there are too many
void size_errors(const PlacedDevice& placed, int columns, CalibrationScratch& scratch) {
  if (columns > kMaxErrors)
    blame(placed,
          "has more than " + std::to_string(kMaxErrors) + " errors of calibration");
  if (scratch.G.cols() != columns) scratch.G.setZero(scratch.G.rows(), columns);
}

/// w G of one device and one source of errors, c×k in the scratch.
void find_errors(const System& system, const PlacedDevice& placed,
                 const ErrorSource& source, const TargetPose& X_WT,
                 CalibrationScratch& scratch, RowWeights weights) {
  begin(system, placed, scratch);
  if (placed.sees_beacons()) {
    const ErrorColumns columns(system, source, 0);
    size_errors(placed, columns.size, scratch);
    add_beacons(system, placed, X_WT, weights, columns, scratch);
  } else {
    add_device(
        system, placed, X_WT, weights,
        [&](bool turns) {
          const Eigen::Index rows = scratch.measure.observation.z.size();
          const ErrorColumns columns(system, source, static_cast<int>(rows));
          size_errors(placed, columns.size, scratch);
          fill_errors(system, placed, source, columns, turns, scratch);
        },
        scratch);
  }
  if (weights == RowWeights::information)
    scratch.G *= information_weight(system, placed);
}

}  // namespace

void find_calibration(const System& system, const PlacedDevice& placed,
                      const TargetPose& X_WT, CalibrationScratch& scratch,
                      RowWeights weights) {
  find_errors(system, placed, {&placed.calibration, placed.doubtful}, X_WT, scratch,
              weights);
  scratch.of_source = scratch.G * scratch.G.transpose();
}

void find_common_error(const System& system, std::size_t number, const TargetPose& X_WT,
                       CalibrationScratch& scratch, RowWeights weights) {
  const PlacedCommonError& common = system.common_errors[number];
  const ErrorSource source{&common.of, {}, &common.X_WF};
  const ErrorColumns columns(system, source, 1);
  scratch.all.setZero(information_size(system), columns.size);
  for (const PlacedDevice& placed : system.devices) {
    const auto& shared = placed.common_errors;
    if (!std::binary_search(shared.begin(), shared.end(), number)) continue;
    find_errors(system, placed, source, X_WT, scratch, weights);
    // One that sees nothing has none.
    if (scratch.G.cols() == columns.size) scratch.all += scratch.G;
  }
  scratch.of_source = scratch.all * scratch.all.transpose();
}

void find_lateness(const System& system, const TargetPose& X_WT,
                   CalibrationScratch& scratch, RowWeights weights) {
  scratch.all.setZero(information_size(system), 1);
  for (const PlacedDevice& placed : system.devices) {
    const double late = placed.without_sight.bias;
    if (late == 0 || !reads_without_sight(system, placed)) continue;
    begin(system, placed, scratch);
    const auto errors = [&](bool) {
      const MeasureScratch& measure = scratch.measure;
      size_errors(placed, 1, scratch);
      scratch.J.setConstant(measure.observation.z.size(), 1, measure.hidden ? late : 0);
    };
    add_device(system, placed, X_WT, weights, errors, scratch);
    if (weights == RowWeights::information)
      scratch.G *= information_weight(system, placed);
    if (scratch.G.cols() == 1) scratch.all += scratch.G;
  }
  scratch.of_source = scratch.all * scratch.all.transpose();
}

StateMatrix calibration_spread(const System& system, const TargetPose& X_WT,
                               CalibrationScratch& scratch, RowWeights weights) {
  const int c = information_size(system);
  StateMatrix spread = StateMatrix::Zero(c, c);
  for (const PlacedDevice& placed : system.devices) {
    if (placed.calibration.exact()) continue;
    find_calibration(system, placed, X_WT, scratch, weights);
    spread += scratch.of_source;
  }
  for (std::size_t i = 0; i < system.common_errors.size(); ++i) {
    find_common_error(system, i, X_WT, scratch, weights);
    spread += scratch.of_source;
  }
  find_lateness(system, X_WT, scratch, weights);
  return spread + scratch.of_source;
}

}  // namespace delos
