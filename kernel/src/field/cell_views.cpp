#include "field/cell_views.h"

#include <algorithm>

#include "delos/parallel/each.h"
#include "observe/lever.h"

namespace delos {

CellViews::CellViews(const System& system, const Sightings& sightings,
                     const std::vector<Eigen::Matrix3d>& orientations)
    : system_(system), sightings_(sightings), orientations_(orientations) {}

CellView CellViews::decide(const Octree& tree, Octree::Index cell, std::size_t turn,
                           std::size_t sighting) const {
  const Octree::Index parent = tree.cells()[cell].parent;
  CellView v = parent == Octree::kNone ? CellView{View::crossing, Sight::unknown}
                                       : at(parent, turn, sighting);
  const Sighting& s = sightings_.all[sighting];
  const PlacedDevice& placed = system_.devices[s.device];
  const Eigen::AlignedBox3d box = tree.box_of(cell);
  const Eigen::Vector3d arm = orientations_[turn] * s.marker.p;
  if (v.view == View::crossing) {
    v.view = View::unknown;
    if (s.by_rows) {
      const Eigen::Vector3d center = seen_at(placed.X_WS(), box.center(), arm);
      v.view = placed.device->view_of_ball(center, box.diagonal().norm() / 2);
    }
  }
  if (v.view == View::outside) return v;
  if (v.sight == Sight::unknown) {
    v.sight = !may_be_hidden(system_, placed) ? Sight::clear
              : s.by_rows
                  ? sight_of_box(system_, placed, orientations_[turn], s.marker, box)
                  : Sight::unknown;
  }
  return v;
}

void CellViews::follow(const Octree& tree, int threads) {
  const std::size_t per_cell = orientations_.size() * sightings_.all.size();
  const std::size_t known = views_.size() / per_cell, cells = tree.cells().size();
  views_.resize(cells * per_cell);
  // A cell follows its parent, which is of an earlier call but for the first roots.
  const auto decide_all = [&](Octree::Index cell) {
    for (std::size_t t = 0; t < orientations_.size(); ++t) {
      for (std::size_t s = 0; s < sightings_.all.size(); ++s) {
        views_[cell * per_cell + t * sightings_.all.size() + s] =
            decide(tree, cell, t, s);
      }
    }
  };
  std::size_t first = std::min(known, cells);  // a tree may have been cut back
  for (; first < cells && tree.cells()[first].level == 0; ++first) {
    decide_all(static_cast<Octree::Index>(first));
  }
  each(cells - first, {.threads = threads, .grain = 16},
       [&](std::size_t c) { decide_all(static_cast<Octree::Index>(first + c)); });
}

}  // namespace delos
