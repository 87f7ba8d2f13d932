#include "observe/unscented.h"

#include <algorithm>
#include <cmath>

#include "model/lower_root.h"

namespace delos {

bool unscented_moments(const ReadingModel& model, const TrackReading& reading,
                       const PredictedReading& middle, const StateVector& x,
                       const Eigen::Matrix3d& R, const StateMatrix& P,
                       UnscentedMoments& out) {
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor,
                             kMaxRows, 2 * kMaxState>;
  const StateLayout& layout = model.system().motion.layout;
  const Eigen::Index n = x.size(), m = middle.z.size();
  const double kappa = std::max<double>(0, 3 - static_cast<double>(n));
  const double spread = static_cast<double>(n) + kappa;
  const StateMatrix root = std::sqrt(spread) * lower_root(P);
  Rows z(m, 2 * n);
  PredictedReading at;
  for (Eigen::Index k = 0; k < 2 * n; ++k) {
    StateVector moved = x;
    Eigen::Matrix3d turned = R;
    const StateVector change =
        k < n ? StateVector(root.col(k)) : StateVector(-root.col(k - n));
    move_state(layout, change, moved, turned);
    if (!model.predict(reading, moved, turned, at)) return false;
    z.col(k) = model.difference(reading.device, at.z, middle.z);
  }
  const double weight = 1 / (2 * spread);
  out.mean = weight * z.rowwise().sum();
  out.S = kappa / spread * out.mean * out.mean.transpose();
  out.C.setZero(n, m);
  for (Eigen::Index k = 0; k < 2 * n; ++k) {
    z.col(k) -= out.mean;
    out.S += weight * z.col(k) * z.col(k).transpose();
    const double sign = k < n ? weight : -weight;
    out.C += sign * root.col(k < n ? k : k - n) * z.col(k).transpose();
  }
  return true;
}

}  // namespace delos
