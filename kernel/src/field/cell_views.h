// What whole cells of an octree see: fields of view and sight lines decided at once for
// all that is inside.
#pragma once

#include <vector>

#include "delos/device/device.h"
#include "delos/sampling/octree.h"
#include "observe/sighting.h"
#include "rig/sight.h"

namespace delos {

/// What holds for one sighting everywhere in a cell.
struct CellView {
  View view = View::unknown;     ///< where the cell is in the device's field of view
  Sight sight = Sight::unknown;  ///< of the line to it
};

/// Cell views of all cells, orientations and sightings.
class CellViews {
 public:
  /// What is passed is kept by reference.
  CellViews(const System& system, const Sightings& sightings,
            const std::vector<Eigen::Matrix3d>& orientations);

  /// Decide about the cells that the tree has gained; drop those that it has lost.
  void follow(const Octree& tree, int threads);

  [[nodiscard]] const CellView& at(Octree::Index cell, std::size_t turn,
                                   std::size_t sighting) const {
    return views_[(cell * orientations_.size() + turn) * sightings_.all.size() +
                  sighting];
  }
  /// Whether somewhere in the cell the edge of a shadow may run.
  [[nodiscard]] bool in_doubt(Octree::Index cell, std::size_t turn,
                              std::size_t sighting) const {
    const CellView& v = at(cell, turn, sighting);
    return v.sight == Sight::unknown && v.view != View::outside;
  }

 private:
  [[nodiscard]] CellView decide(const Octree& tree, Octree::Index cell,
                                std::size_t turn, std::size_t sighting) const;

  const System& system_;
  const Sightings& sightings_;
  const std::vector<Eigen::Matrix3d>& orientations_;
  std::vector<CellView> views_;
};

}  // namespace delos
