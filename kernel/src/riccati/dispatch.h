// From sizes known at run time to code compiled for each of them.
#pragma once

#include <Eigen/Core>
#include <cstdlib>

namespace delos::riccati {

/// Calls f.template operator()<d>() for the sizes of a pose: two or three coordinates
/// of place or turn, or six of both; aborts otherwise.
template <class F>
decltype(auto) with_coordinates(Eigen::Index d, F&& f) {
  switch (d) {
    case 2:
      return f.template operator()<2>();
    case 3:
      return f.template operator()<3>();
    case 6:
      return f.template operator()<6>();
    default:
      std::abort();
  }
}

/// Calls f.template operator()<k>() for k in [1, 3]; aborts otherwise.
template <class F>
decltype(auto) with_order(int order, F&& f) {
  switch (order) {
    case 1:
      return f.template operator()<1>();
    case 2:
      return f.template operator()<2>();
    case 3:
      return f.template operator()<3>();
    default:
      std::abort();
  }
}

}  // namespace delos::riccati
