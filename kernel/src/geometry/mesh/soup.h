// What a mesh file lists, before it is a mesh.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <vector>

#include "geometry/mesh/kernel.h"

namespace delos {

/// A vector that grows at once to what a file can hold, but not to what it claims: CGAL
/// makes room for as many vertices, faces and corners as the file announces.
template <class T>
struct Claimed : std::vector<T> {
  std::size_t limit = 1'000'000;

  void resize(std::size_t n) {
    if (n > limit) throw std::length_error("announced");
    std::vector<T>::resize(n);
  }
};

using SoupPoints = Claimed<Kernel::Point_3>;
using SoupPolygons = Claimed<Claimed<std::size_t>>;

}  // namespace delos
