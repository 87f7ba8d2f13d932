// Which boxes of a flat tree's node a shaft may meet, all of them at once.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>

#include "geometry/occlusion/lane_tests.h"
#include "geometry/occlusion/shaft.h"

namespace delos {

/// Which boxes a shaft may meet: those that overlap its bounds and aren't, with what of
/// them is within the bounds, beyond one of its planes.
class ShaftTest {
 public:
  /// @param origin where the floats of the tree count from
  ShaftTest(const Shaft& shaft, const Eigen::Vector3d& origin)
      : overlap_(shaft.bounds(), origin) {
    const Eigen::AlignedBox3d& bounds = shaft.bounds();
    const double reach =
        bounds.sizes().maxCoeff() + (shaft.apex() - origin).cwiseAbs().maxCoeff();
    if (!(reach < 1e15)) return;  // areas would overflow: the bounds alone decide
    for (const Shaft::Plane& p : shaft.planes()) {
      Plane& plane = planes_[count_++];
      const auto term = [&](int axis, double n) {
        const double apex = shaft.apex()[axis] - origin[axis];
        return n > 0 ? Term{axis, 0, float_below(bounds.min()[axis] - origin[axis]),
                            static_cast<float>(apex), static_cast<float>(n)}
                     : Term{axis, 1, float_above(bounds.max()[axis] - origin[axis]),
                            static_cast<float>(apex), static_cast<float>(n)};
      };
      plane.terms = {term(p.i, p.n_i), term(p.j, p.n_j)};
      // Of each term: two numbers rounded to floats, and three operations.
      plane.slack = float_above(
          p.slack + 1e-6 * (std::abs(p.n_i) + std::abs(p.n_j)) * reach + 1e-37);
    }
  }

  /// @returns a bit for each lane
  unsigned operator()(const FlatNode& node) const {
    return lanes_of(half(node, 0), half(node, 1));
  }

 private:
  using Floats = FlatNode::Floats;
  /// n (x − apex), x where the box is innermost along an axis.
  struct Term {
    int axis, side;
    float bound, apex, n;

    Floats at(const FlatNode& node, int h) const {
      const Floats x = node.planes(side, axis, h);
      const Floats inner = side == 0 ? (x > bound ? x : Floats{} + bound)
                                     : (x < bound ? x : Floats{} + bound);
      return (inner - apex) * n;
    }
  };
  struct Plane {
    std::array<Term, 2> terms;
    float slack;
  };

  FlatNode::Words half(const FlatNode& node, int h) const {
    FlatNode::Words met = overlap_.half(node, h);
    for (int k = 0; k < count_; ++k) {
      const auto& [terms, slack] = planes_[k];
      met &= ~(terms[0].at(node, h) + terms[1].at(node, h) > slack);
    }
    return met;
  }

  OverlapTest overlap_;
  std::array<Plane, 6> planes_;
  int count_ = 0;
};

}  // namespace delos
