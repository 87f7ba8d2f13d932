#include "observe/error_columns.h"

#include <cmath>

#include "observe/answers.h"

namespace delos {
namespace {

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

}  // namespace

ErrorColumns::ErrorColumns(const System& system, const ErrorSource& source, int rows) {
  const Calibration& known = *source.known;
  const auto take = [&](bool doubtful, int columns, int& first) {
    if (!doubtful) return;
    first = size;
    size += columns;
  };
  take(!known.place.isZero(0), 3, place);
  take(!known.orientation.isZero(0), 3, orientation);
  take(!source.doubtful.empty(), static_cast<int>(source.doubtful.size()), params);
  take(known.offset > 0, source.X_WF ? 1 : rows, offset);
  take(known.scale > 0, 1, scale);
  take(known.delay > 0 && system.speed > 0, 3, delay);
}

double lag_along_an_axis(const System& system, const Calibration& known) {
  return known.delay * system.speed / std::sqrt(3.0);
}

void fill_errors(const System& system, const PlacedDevice& placed,
                 const ErrorSource& source, const ErrorColumns& columns, bool turns,
                 CalibrationScratch& scratch) {
  const Calibration& known = *source.known;
  const Observation& seen = scratch.measure.observation;
  const Target& target = scratch.measure.target;
  auto& J = scratch.J;
  J.setZero(seen.z.size(), columns.size);
  Pose X_SF;
  if (source.X_WF) X_SF = placed.X_WS().inverse() * *source.X_WF;
  const Eigen::Matrix3d R_FS = X_SF.R.transpose();
  const bool moves =
      columns.place >= 0 || columns.orientation >= 0 || columns.delay >= 0;
  for (Eigen::Index r = 0; moves && r < J.rows(); ++r) {
    const Eigen::Vector3d h = seen.H.row(r).head<3>().transpose();
    if (columns.place >= 0)
      J.row(r).segment<3>(columns.place) =
          -(R_FS * h).cwiseProduct(known.place).transpose();
    // Along any three axes the same.
    if (columns.delay >= 0)
      J.row(r).segment<3>(columns.delay) =
          -lag_along_an_axis(system, known) *
          (placed.carried() ? h : Eigen::Vector3d(placed.X_WS().R * h)).transpose();
    if (columns.orientation < 0) continue;
    Eigen::Vector3d turn = h.cross(target.p_ST - X_SF.p);
    if (turns) turn -= seen.H.row(r).segment<3>(3).transpose();
    J.row(r).segment<3>(columns.orientation) =
        (R_FS * turn).cwiseProduct(known.orientation).transpose();
  }
  for (std::size_t k = 0; k < source.doubtful.size(); ++k) {
    const Eigen::Index column = columns.params + static_cast<Eigen::Index>(k);
    fill_slope(placed, source.doubtful[k], target, seen, scratch.beside, J.col(column));
    J.col(column) *= source.doubtful[k].deviation;
  }
  if (columns.scale >= 0) J.col(columns.scale) = known.scale * seen.z;
  if (columns.offset < 0) return;
  if (source.X_WF)
    J.col(columns.offset).setConstant(known.offset);
  else
    J.middleCols(columns.offset, J.rows()).diagonal().setConstant(known.offset);
}

}  // namespace delos
