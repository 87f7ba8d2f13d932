#include "geometry/occlusion/shaft.h"

#include <cmath>
#include <limits>

namespace delos {
namespace {

constexpr double kRounding = std::numeric_limits<double>::epsilon();

/// The sign of the face of [min, max] that x lies beyond, 0 where it lies between them.
int beyond(double x, double min, double max) { return x < min ? -1 : x > max ? 1 : 0; }

}  // namespace

Shaft::Shaft(const Eigen::Vector3d& apex, const Eigen::AlignedBox3d& box)
    : apex_(apex), box_(box), bounds_(box) {
  bounds_.extend(apex);
  margin_ = 8 * kRounding *
            std::max(bounds_.min().cwiseAbs().maxCoeff(),
                     bounds_.max().cwiseAbs().maxCoeff());
  bounds_.min().array() -= margin_;
  bounds_.max().array() += margin_;
  add_silhouette(0, 1);
  add_silhouette(1, 2);
  add_silhouette(2, 0);
}

/// Of the four edges along the third axis, those between a seen and an unseen face.
///
/// With outward normals f of the seen face and g of the other, c on the edge and a the
/// apex, the plane through both has the outward normal
///     n = −((a − c)·g) f + ((a − c)·f) g,
/// where neither factor is negative, as the apex is beyond f and not beyond g.
void Shaft::add_silhouette(int i, int j) {
  for (const auto& [seen, other] : {std::pair(i, j), std::pair(j, i)}) {
    const int f = beyond(apex_[seen], box_.min()[seen], box_.max()[seen]);
    if (f == 0) continue;
    const double seen_at = f > 0 ? box_.max()[seen] : box_.min()[seen];
    for (const int g : {-1, 1}) {
      if (beyond(apex_[other], box_.min()[other], box_.max()[other]) == g) continue;
      const double other_at = g > 0 ? box_.max()[other] : box_.min()[other];
      const double n_seen = -f * ((apex_[other] - other_at) * g);
      const double n_other = g * ((apex_[seen] - seen_at) * f);
      // Four roundings, of terms that are no larger than the bounds allow.
      const double reach = bounds_.sizes().maxCoeff();
      const double slack =
          (std::abs(n_seen) + std::abs(n_other)) * (4 * kRounding * reach + margin_);
      planes_[plane_count_++] = {seen, other, n_seen, n_other, slack};
    }
  }
}

bool Shaft::may_meet(const Eigen::Vector3d& min, const Eigen::Vector3d& max) const {
  // Only what is within the bounds can meet the hull.
  const Eigen::Vector3d low = min.cwiseMax(bounds_.min());
  const Eigen::Vector3d high = max.cwiseMin(bounds_.max());
  if ((low.array() > high.array()).any()) return false;
  for (int k = 0; k < plane_count_; ++k) {
    const Plane& p = planes_[k];
    // The corner that is innermost as seen by this plane.
    const double x = (p.n_i > 0 ? low : high)[p.i] - apex_[p.i];
    const double y = (p.n_j > 0 ? low : high)[p.j] - apex_[p.j];
    if (p.n_i * x + p.n_j * y > p.slack) return false;
  }
  return true;
}

bool Shaft::may_meet(const std::array<Eigen::Vector3d, 3>& t) const {
  if (!may_meet(t[0].cwiseMin(t[1]).cwiseMin(t[2]),
                t[0].cwiseMax(t[1]).cwiseMax(t[2]))) {
    return false;
  }
  // All three corners beyond one plane? They may be far outside of the bounds.
  for (int k = 0; k < plane_count_; ++k) {
    const Plane& p = planes_[k];
    bool all_beyond = true;
    for (const Eigen::Vector3d& corner : t) {
      const double x = p.n_i * (corner[p.i] - apex_[p.i]);
      const double y = p.n_j * (corner[p.j] - apex_[p.j]);
      all_beyond &= x + y > p.slack + 4 * kRounding * (std::abs(x) + std::abs(y));
    }
    if (all_beyond) return false;
  }
  // The apex and all eight corners on one side of the triangle's plane?
  const Eigen::Vector3d u = t[1] - t[0], v = t[2] - t[0], n = u.cross(v);
  const double area = u.norm() * v.norm();
  bool above = true, below = true;
  const auto place = [&](const Eigen::Vector3d& p) {
    const Eigen::Vector3d q = p - t[0];
    const double slack = area * (16 * kRounding * q.norm() + 2 * margin_);
    const double height = n.dot(q);
    above &= height > slack;
    below &= height < -slack;
  };
  place(apex_);
  for (int corner = 0; corner < 8 && (above || below); ++corner) {
    place(box_.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)));
  }
  return !above && !below;
}

}  // namespace delos
