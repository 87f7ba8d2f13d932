#include "observe/calibration.h"

#include <string>

#include "observe/answers.h"

namespace delos {
namespace {

/// Which columns of J are of which errors; −1: not in doubt.
struct ErrorColumns {
  int place = -1, orientation = -1, params = -1, offset = -1;
  int size = 0;

  /// @param rows that the device reports of a point, each with an offset of its own
  ErrorColumns(const PlacedDevice& placed, int rows) {
    const auto take = [&](bool doubtful, int columns, int& first) {
      if (!doubtful) return;
      first = size;
      size += columns;
    };
    take(!placed.calibration.place.isZero(0), 3, place);
    take(!placed.calibration.orientation.isZero(0), 3, orientation);
    take(!placed.doubtful.empty(), static_cast<int>(placed.doubtful.size()), params);
    take(placed.calibration.offset > 0, rows, offset);
  }
};

/// z of the device that is a little off, where it sees the target.
bool reading_of(const PlacedDevice& placed, const Device& device, const Target& target,
                Observation& out) {
  try {
    return device.observe(target, out);
  } catch (...) {
    rethrow_named(placed);
  }
}

/// ∂z/∂parameter; one-sided at an edge of the view.
void fill_slope(const PlacedDevice& placed, const DoubtfulParameter& parameter,
                const Target& target, const Observation& seen, Observation& beside,
                Eigen::Ref<Eigen::VectorXd> slope) {
  slope.setZero();
  const auto add = [&](const Device& device, double sign) {
    const bool sees = reading_of(placed, device, target, beside);
    const Observation& at = sees && beside.z.size() == seen.z.size() ? beside : seen;
    slope += sign / parameter.between * at.z;
  };
  add(*parameter.above, 1);
  add(*parameter.below, -1);
}

/// What one standard deviation of each error does to an answer. Where the device moves
/// by δ and turns by φ, along and about its own axes, the target goes the other way:
///
///     p_S → p_S − δ + p_S × φ,   R_ST → exp(−φ) R_ST
///
/// @param turns whether columns 3 to 5 of H are of the target's orientation
void fill_errors(const PlacedDevice& placed, const ErrorColumns& columns, bool turns,
                 CalibrationScratch& scratch) {
  const Calibration& known = placed.calibration;
  const Observation& seen = scratch.measure.observation;
  const Target& target = scratch.measure.target;
  auto& J = scratch.J;
  J.setZero(seen.z.size(), columns.size);
  for (Eigen::Index r = 0; r < J.rows(); ++r) {
    if (columns.place < 0 && columns.orientation < 0) break;
    const Eigen::Vector3d h = seen.H.row(r).head<3>().transpose();
    if (columns.place >= 0)
      J.row(r).segment<3>(columns.place) = -h.cwiseProduct(known.place).transpose();
    if (columns.orientation < 0) continue;
    Eigen::Vector3d turn = h.cross(target.p_ST);
    if (turns) turn -= seen.H.row(r).segment<3>(3).transpose();
    J.row(r).segment<3>(columns.orientation) =
        turn.cwiseProduct(known.orientation).transpose();
  }
  for (std::size_t k = 0; k < placed.doubtful.size(); ++k) {
    const Eigen::Index column = columns.params + static_cast<Eigen::Index>(k);
    fill_slope(placed, placed.doubtful[k], target, seen, scratch.beside, J.col(column));
    J.col(column) *= placed.doubtful[k].deviation;
  }
  if (columns.offset >= 0)
    J.middleCols(columns.offset, J.rows()).diagonal().setConstant(known.offset);
}

/// What a row counts.
double weight_of(RowWeights weights, double variance) {
  return weights == RowWeights::plain ? 1 : 1 / variance;
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
    scratch.G.noalias() += weight_of(weights, row.variance) * row.h.transpose() *
                           (split.directions.col(i).transpose() * scratch.J);
  }
}

/// The same of markers that share a part of their noise, which their rows and what
/// their errors do are freed of together.
template <class Begin>
void add_shared(const System& system, const PlacedDevice& placed,
                const TargetPose& X_WT, RowWeights weights, Begin&& begin,
                CalibrationScratch& scratch) {
  MeasureScratch& measure = scratch.measure;
  const Eigen::Index c = measure.row.h.size();
  measure.rows.clear();
  std::size_t stride = 0;
  each_marker(system, placed, X_WT, measure, [&](const Eigen::Vector3d& arm) {
    const Observation& seen = measure.observation;
    const ErrorColumns columns = begin(seen.z.size());
    if (c + columns.size > kMaxState)
      blame(placed, "has more errors of calibration than are kept beside the state");
    fill_errors(placed, columns, false, scratch);
    stride = static_cast<std::size_t>(seen.z.size());
    for (Eigen::Index r = 0; r < seen.z.size(); ++r) {
      fill_point_row(system, placed, arm, seen.H.row(r), seen.R(r, r), measure.row);
      StateRow whole = measure.row;
      whole.h.conservativeResize(c + columns.size);
      whole.h.tail(columns.size) = scratch.J.row(r);
      measure.rows.push_back(whole);
    }
  });
  if (weights == RowWeights::information)
    part_shared_noise(placed, stride, measure.rows);
  for (const StateRow& row : measure.rows)
    scratch.G.noalias() += weight_of(weights, row.variance) *
                           row.h.head(c).transpose() * row.h.tail(row.h.size() - c);
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
        if (columns.orientation >= 0)
          j.segment<3>(columns.orientation) =
              (X_WS.R.transpose() * (h.segment<3>(turns).transpose() - arm.cross(h_p)))
                  .cwiseProduct(known.orientation)
                  .transpose();
        scratch.G.topRows(d).noalias() +=
            h.transpose() * (s.share * weight_of(weights, r.variance)) * j;
      });
}

}  // namespace

void find_calibration(const System& system, const PlacedDevice& placed,
                      const TargetPose& X_WT, CalibrationScratch& scratch,
                      RowWeights weights) {
  const int c = information_size(system);
  MeasureScratch& measure = scratch.measure;
  measure.row.h.setZero(c);
  if (placed.clock) measure.row.h(*placed.clock) = 1;
  scratch.G.resize(c, 0);
  const auto begin = [&](Eigen::Index rows) {
    const ErrorColumns columns(placed, static_cast<int>(rows));
    if (columns.size > kMaxErrors)
      blame(placed,
            "has more than " + std::to_string(kMaxErrors) + " errors of calibration");
    if (scratch.G.cols() != columns.size) scratch.G.setZero(c, columns.size);
    return columns;
  };
  if (placed.sees_beacons()) {
    add_beacons(system, placed, X_WT, weights, begin(0), scratch);
  } else if (placed.device->span() != Span::point) {
    if (const auto view = look_at_motion(system, placed, X_WT, measure)) {
      fill_errors(placed, begin(measure.observation.z.size()), true, scratch);
      add_answer(weights, scratch, [&](const auto& h, double variance, StateRow& row) {
        fill_motion_row(system, placed, *view, h, variance, row);
      });
    }
  } else if (shares_noise(placed)) {
    add_shared(system, placed, X_WT, weights, begin, scratch);
  } else {
    each_marker(system, placed, X_WT, measure, [&](const Eigen::Vector3d& arm) {
      fill_errors(placed, begin(measure.observation.z.size()), false, scratch);
      add_answer(weights, scratch, [&](const auto& h, double variance, StateRow& row) {
        fill_point_row(system, placed, arm, h, variance, row);
      });
    });
  }
  const double weight =
      weights == RowWeights::plain ? 1 : information_weight(system, placed);
  scratch.of_device = weight * weight * scratch.G * scratch.G.transpose();
}

StateMatrix calibration_spread(const System& system, const TargetPose& X_WT,
                               CalibrationScratch& scratch, RowWeights weights) {
  const int c = information_size(system);
  StateMatrix spread = StateMatrix::Zero(c, c);
  for (const PlacedDevice& placed : system.devices) {
    if (placed.calibration.exact()) continue;
    find_calibration(system, placed, X_WT, scratch, weights);
    spread += scratch.of_device;
  }
  return spread;
}

}  // namespace delos
