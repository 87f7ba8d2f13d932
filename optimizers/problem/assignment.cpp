#include "problem/assignment.h"

#include <stdexcept>

#include "delos/model/infinity.h"

namespace delos {
namespace {

/// Sums of such numbers stay finite.
constexpr double kMostCost = 1e300;

}  // namespace

std::vector<std::size_t> cheapest_assignment(const Eigen::MatrixXd& cost) {
  if (!(cost.array().abs() <= kMostCost).all())
    throw std::invalid_argument("layouts are compared that are endlessly far apart");
  const Eigen::Index n = cost.rows();
  constexpr Eigen::Index kNone = -1;
  // Reduced costs cost(i, j) − u(i) − v(j) stay ≥ 0, and are 0 where i goes with j.
  // Column n stands for the row that is being placed.
  std::vector<double> u(static_cast<std::size_t>(n)),
      v(static_cast<std::size_t>(n) + 1);
  std::vector<Eigen::Index> row(static_cast<std::size_t>(n) + 1, kNone);
  const auto at = [](Eigen::Index i) { return static_cast<std::size_t>(i); };
  for (Eigen::Index i = 0; i < n; ++i) {
    // Grow a tree of shortest paths from row i until it meets a free column.
    std::vector<double> length(at(n), kInfinity);
    std::vector<Eigen::Index> from(at(n), n);
    std::vector<bool> in_tree(at(n) + 1, false);
    row[at(n)] = i;
    Eigen::Index column = n;
    while (row[at(column)] != kNone) {
      in_tree[at(column)] = true;
      const Eigen::Index own = row[at(column)];
      double least = kInfinity;
      Eigen::Index next = 0;
      for (Eigen::Index j = 0; j < n; ++j) {
        if (in_tree[at(j)]) continue;
        const double reduced = cost(own, j) - u[at(own)] - v[at(j)];
        if (reduced < length[at(j)]) {
          length[at(j)] = reduced;
          from[at(j)] = column;
        }
        if (length[at(j)] < least) {
          least = length[at(j)];
          next = j;
        }
      }
      for (Eigen::Index j = 0; j <= n; ++j) {
        if (in_tree[at(j)]) {
          u[at(row[at(j)])] += least;
          v[at(j)] -= least;
        } else if (j < n) {
          length[at(j)] -= least;
        }
      }
      column = next;
    }
    // Everybody on the path takes the next column.
    while (column != n) {
      row[at(column)] = row[at(from[at(column)])];
      column = from[at(column)];
    }
  }
  std::vector<std::size_t> to(at(n));
  for (Eigen::Index j = 0; j < n; ++j) to[at(row[at(j)])] = at(j);
  return to;
}

}  // namespace delos
