#include "field/interpolation.h"

#include <algorithm>
#include <array>

#include "observe/point_rows.h"

namespace delos {
namespace {

/// Lagrange's quadratics on 0, 1, 2, multiplied out over the 27 nodes of a family.
std::array<double, 27> quadratic_weights(const Eigen::Vector3d& at) {
  double w[3][3];
  for (int i = 0; i < 3; ++i) {
    const double t = at(i);
    w[i][0] = (t - 1) * (t - 2) / 2;
    w[i][1] = t * (2 - t);
    w[i][2] = t * (t - 1) / 2;
  }
  std::array<double, 27> all;
  for (std::size_t n = 0; n < 27; ++n) {
    all[n] = w[0][n % 3] * w[1][n / 3 % 3] * w[2][n / 9];
  }
  return all;
}

/// S += Σ hᵀh of whitened rows, or S += the packed numbers, at one lane.
void add(const Sighting& s, const double* numbers, int lane, double* layer) {
  if (!s.by_rows) {
    for (std::size_t e = 0; e < s.numbers; ++e) {
      layer[e * kLanes + static_cast<std::size_t>(lane)] += numbers[e];
    }
    return;
  }
  for (int r = 0; r < s.rows; ++r) {
    const double* h = numbers + r * s.columns;
    for (int i = 0; i < s.columns; ++i) {
      for (int j = 0; j <= i; ++j) {
        layer[packed_index(i, j) * kLanes + lane] += h[i] * h[j];
      }
    }
  }
}

constexpr std::size_t kMostNumbers =
    std::max<std::size_t>(kMaxLaneRows * kMaxCoordinates,
                          static_cast<std::size_t>(packed_index(kMaxState, 0)));

}  // namespace

/// What to sum for one query.
struct Interpolation::Stencil {
  std::array<double, 27> weights;
  std::array<const double*, 27> records;
};

Interpolation::Interpolation(const System& system, const Sightings& sightings,
                             const std::vector<Eigen::Matrix3d>& orientations,
                             const Octree& tree, const CellViews& views,
                             const NodeStore& store)
    : system_(system),
      sightings_(sightings),
      orientations_(orientations),
      tree_(tree),
      views_(views),
      store_(store),
      shape_(system) {}

const double* Interpolation::record(Octree::Index node, std::size_t turn) const {
  if (node < hanging_.size() && hanging_[node] != Octree::kNone) {
    return conforming_.data() +
           (hanging_[node] * orientations_.size() + turn) * sightings_.record;
  }
  return store_.record(node, turn);
}

bool Interpolation::interpolates(Octree::Index cell, std::size_t turn,
                                 std::size_t sighting) const {
  const CellView& v = views_.at(cell, turn, sighting);
  if (v.view != View::inside && v.view != View::unknown) return false;
  // The nodes of the second kind hold what is seen, not what is in view.
  if (!sightings_.all[sighting].by_rows && v.sight == Sight::unknown) return false;
  const Octree::Family& family = tree_.family_of(cell);
  return std::all_of(family.begin(), family.end(), [&](Octree::Index node) {
    const NodeFlags flags = store_.flags(node, turn)[sighting];
    return flags.in_view && !flags.perfect;
  });
}

void Interpolation::conform() {
  const std::size_t turns = orientations_.size(), count = sightings_.all.size();
  hanging_.assign(tree_.nodes(), Octree::kNone);
  conforming_.clear();
  struct Hanging {
    Octree::Index node, leaf;
  };
  std::vector<Hanging> all;
  for (Octree::Index node = 0; node < tree_.nodes(); ++node) {
    const Octree::Index leaf = tree_.coarsest_leaf_at(node);
    if (!tree_.in_family_lattice(leaf, node)) all.push_back({node, leaf});
  }
  // Nodes of coarse leaves may hang on still coarser ones, which come first.
  std::stable_sort(all.begin(), all.end(), [&](const Hanging& a, const Hanging& b) {
    return tree_.cells()[a.leaf].level < tree_.cells()[b.leaf].level;
  });
  conforming_.reserve(all.size() * turns * sightings_.record);
  Octree::Index next = 0;
  for (const auto& [node, leaf] : all) {
    const auto weights =
        quadratic_weights(tree_.within_family(leaf, tree_.position(node)));
    const Octree::Family& family = tree_.family_of(leaf);
    for (std::size_t t = 0; t < turns; ++t) {
      const double* own = store_.record(node, t);
      const std::size_t start = conforming_.size();
      conforming_.insert(conforming_.end(), own, own + sightings_.record);
      for (std::size_t s = 0; s < count; ++s) {
        if (!interpolates(leaf, t, s)) continue;
        const Sighting& sighting = sightings_.all[s];
        for (std::size_t e = sighting.offset; e < sighting.offset + sighting.numbers;
             ++e) {
          double sum = 0;
          for (std::size_t n = 0; n < 27; ++n)
            sum += weights[n] * record(family[n], t)[e];
          conforming_[start + e] = sum;
        }
      }
    }
    hanging_[node] = next++;
  }
}

bool Interpolation::hidden_at_nearest(const Query& query, std::size_t turn,
                                      std::size_t sighting, bool& decided) const {
  const Octree::Corners corners = tree_.corners(query.cell);
  double least = 0;
  bool hidden = false;
  decided = false;
  for (const Octree::Index node : corners) {
    const NodeFlags flags = store_.flags(node, turn)[sighting];
    if (!flags.in_view) continue;
    const double distance = (tree_.position(node) - query.p).squaredNorm();
    if (decided && distance >= least) continue;
    least = distance;
    hidden = flags.hidden;
    decided = true;
  }
  return hidden;
}

void Interpolation::at(std::span<const Query> queries, std::size_t turn,
                       DoubtRule doubt, LayerBlock& block) const {
  fill(queries, nullptr, turn, doubt, block);
}

void Interpolation::at_nodes(std::span<const Query> queries,
                             std::span<const Octree::Index> nodes, std::size_t turn,
                             LayerBlock& block) const {
  fill(queries, nodes.data(), turn, DoubtRule::nearest, block);
}

void Interpolation::fill(std::span<const Query> queries, const Octree::Index* nodes,
                         std::size_t turn, DoubtRule doubt, LayerBlock& block) const {
  const int lanes = static_cast<int>(queries.size());
  clear_block(shape_, lanes, block);
  std::array<Stencil, kLanes> stencils;
  std::vector<TargetPose> poses;
  poses.reserve(queries.size());
  for (std::size_t l = 0; l < queries.size(); ++l) {
    poses.push_back({orientations_[turn], queries[l].p});
    stencils[l].weights =
        quadratic_weights(tree_.within_family(queries[l].cell, queries[l].p));
    const Octree::Family& family = tree_.family_of(queries[l].cell);
    for (std::size_t n = 0; n < 27; ++n)
      stencils[l].records[n] = record(family[n], turn);
  }

  PointRows rows;
  LayerBlock one;
  std::array<Sight, kLanes> no_ray;
  no_ray.fill(Sight::clear);
  for (std::size_t s = 0; s < sightings_.all.size(); ++s) {
    const Sighting& sighting = sightings_.all[s];
    const PlacedDevice& placed = system_.devices[sighting.device];
    double* layer = block.layers.data() + sighting.device * shape_.stride;
    std::uint64_t &seen = block.seen[sighting.device],
                  &perfect = block.perfect[sighting.device];
    std::uint64_t direct = 0;
    bool observed = false;
    for (int l = 0; l < lanes; ++l) {
      const Query& query = queries[static_cast<std::size_t>(l)];
      const CellView& view = views_.at(query.cell, turn, s);
      const std::uint64_t bit = std::uint64_t{1} << l;
      if (view.view == View::outside || view.sight == Sight::hidden) continue;
      const bool smooth = interpolates(query.cell, turn, s);
      double numbers[kMostNumbers];
      NodeFlags own = {};
      if (nodes) own = store_.flags(nodes[l], turn)[s];

      if (nodes && (!own.in_view || own.hidden)) continue;
      if (!smooth && nodes) {
        std::copy_n(store_.record(nodes[l], turn) + sighting.offset, sighting.numbers,
                    numbers);
        if (own.perfect) perfect |= bit;
      } else if (!smooth && sighting.by_rows) {
        if (!observed) {
          observe_rows(system_, placed, sighting.marker, poses, no_ray.data(), rows);
          observed = true;
        }
        if ((rows.in_view & bit) == 0) continue;
        direct |= bit;
      } else if (!smooth) {
        clear_block(shape_, 1, one);
        observe_device(system_, shape_, sighting.device,
                       {&poses[static_cast<std::size_t>(l)], 1}, one);
        if (one.seen[sighting.device] == 0) continue;
        if (one.perfect[sighting.device] != 0) perfect |= bit;
        for (std::size_t e = 0; e < sighting.numbers; ++e) {
          numbers[e] = one.layers[sighting.device * shape_.stride + e * kLanes];
        }
      } else {
        const Stencil& stencil = stencils[static_cast<std::size_t>(l)];
        for (std::size_t e = 0; e < sighting.numbers; ++e) {
          double sum = 0;
          for (std::size_t n = 0; n < 27; ++n) {
            sum += stencil.weights[n] * stencil.records[n][sighting.offset + e];
          }
          numbers[e] = sum;
        }
      }

      if (!nodes && sighting.by_rows && view.sight == Sight::unknown) {
        bool hidden = doubt == DoubtRule::all_hidden;
        bool decided = doubt == DoubtRule::all_hidden || doubt == DoubtRule::all_seen;
        if (doubt == DoubtRule::nearest) {
          hidden = hidden_at_nearest(query, turn, s, decided);
        }
        if (!decided) {
          hidden = !in_sight(system_, placed, poses[static_cast<std::size_t>(l)],
                             sighting.marker);
        }
        if (hidden) {
          direct &= ~bit;
          continue;
        }
      }
      seen |= bit;
      if ((direct & bit) == 0) add(sighting, numbers, l, layer);
    }
    if (direct != 0) {
      add_information(rows, sighting.columns, direct, layer);
      perfect |= rows.perfect & direct;
    }
  }
  sum_layers(shape_, block);
}

}  // namespace delos
