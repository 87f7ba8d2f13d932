// How an octree grows: observe, estimate, mark, halve.
#include <algorithm>
#include <atomic>
#include <cmath>

#include "delos/model/infinity.h"
#include "delos/parallel/each.h"
#include "field/adaptive_state.h"

namespace delos {
namespace {

/// How far two values of a metric are apart, in decades, at most one: what a value and
/// blindness are apart.
double decades_apart(double a, double b) {
  if (a == b) return 0;
  if (!std::isfinite(a) || !std::isfinite(b) || a <= 0 || b <= 0) return 1;
  return std::min(1.0, std::abs(std::log10(a / b)));
}

}  // namespace

bool AdaptiveField::State::cancelled() const {
  return options.field.cancel && options.field.cancel->load(std::memory_order_relaxed);
}

bool AdaptiveField::State::out_of_time() const {
  return sampling.seconds &&
         std::chrono::duration<double>(std::chrono::steady_clock::now() - start)
                 .count() > *sampling.seconds;
}

/// Observe and evaluate what the tree has gained.
/// @returns false where it was interrupted
bool AdaptiveField::State::observe_level(Octree::Index first_cell) {
  views.follow(tree, threads);
  const std::size_t before = store.nodes(), all = tree.nodes();
  value.resize(all);
  LoopOptions loop{.threads = threads};
  loop.stop = [this, first_cell] {
    return cancelled() || (first_cell > 0 && out_of_time());
  };
  if (options.field.progress)
    loop.progress = [&](std::size_t blocks) {
      options.field.progress(std::min(before + blocks * kLanes, all) * turns.size(),
                             all * turns.size());
    };
  const bool whole = store.follow(tree, views, first_cell, loop, [&] {
    return [this, evaluate = evaluator()](const NodeStore::Observed& at) mutable {
      evaluate(at.count, at.layers, at.poses, &value[at.first_node]);
    };
  });
  if (!whole) return false;
  evaluations += (all - before) * turns.size();
  for (std::size_t n = before; n < tree.nodes(); ++n) {
    const auto node = static_cast<Octree::Index>(n);
    inside.push_back(inside_solid(system, tree.position(node)));
  }
  return true;
}

/// Values at places whose layers `fill(first, count, turn, block)` makes.
template <class Fill>
std::vector<PoseValue> AdaptiveField::State::solve(std::span<const Query> queries,
                                                   Fill&& fill) const {
  std::vector<PoseValue> values(queries.size());
  const std::size_t blocks = (queries.size() + kLanes - 1) / kLanes;
  each_with(blocks, {.threads = threads}, [&] {
    return [&, evaluate = evaluator(), block = LayerBlock{},
            poses = std::vector<TargetPose>(kLanes)](std::size_t b) mutable {
      const std::size_t first = b * kLanes;
      const std::size_t count = std::min<std::size_t>(kLanes, queries.size() - first);
      const auto layers = [&](std::size_t turn) -> const LayerBlock& {
        fill(first, count, turn, block);
        return block;
      };
      const auto at = [&](std::size_t turn) {
        for (std::size_t l = 0; l < count; ++l)
          poses[l] = {turns[turn], queries[first + l].p};
        return poses.data();
      };
      evaluate(count, layers, at, &values[first]);
    };
  });
  return values;
}

/// Values between the nodes.
std::vector<PoseValue> AdaptiveField::State::values_at(std::span<const Query> queries,
                                                       DoubtRule doubt) const {
  return solve(queries, [&](std::size_t first, std::size_t count, std::size_t turn,
                            LayerBlock& block) {
    between.at(queries.subspan(first, count), turn, doubt, block);
  });
}

/// How far the cells that were halved were off at the nodes that this brought, decades.
std::vector<double> AdaptiveField::State::surplus(Octree::Index first_cell,
                                                  std::size_t first_node) const {
  std::vector<Query> queries;
  std::vector<Octree::Index> nodes;
  std::vector<char> asked(tree.nodes() - first_node, 0);
  for (auto c = first_cell; c < tree.cells().size(); ++c) {
    // Nothing interpolated in a root, and the deepest level asks for nothing more.
    if (tree.cells()[c].level < 2 || tree.cells()[c].level == tree.depth()) continue;
    for (const Octree::Index node : tree.corners(c)) {
      if (node < first_node || asked[node - first_node]) continue;
      asked[node - first_node] = 1;
      queries.push_back({tree.cells()[c].parent, tree.position(node)});
      nodes.push_back(node);
    }
  }
  const std::span<const Query> all(queries);
  const std::vector<PoseValue> expected = solve(all, [&](std::size_t first,
                                                         std::size_t count,
                                                         std::size_t turn,
                                                         LayerBlock& block) {
    between.at_nodes(all.subspan(first, count), {&nodes[first], count}, turn, block);
  });
  std::vector<double> decades(tree.nodes() - first_node, 0);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    decades[nodes[i] - first_node] =
        decades_apart(expected[i].value, value[nodes[i]].value);
  }
  return decades;
}

/// Whether the edge of some shadow may cross a cell.
bool AdaptiveField::State::in_doubt(Octree::Index cell) const {
  for (std::size_t t = 0; t < turns.size(); ++t) {
    for (std::size_t s = 0; s < sightings.all.size(); ++s) {
      if (views.in_doubt(cell, t, s)) return true;
    }
  }
  return false;
}

/// What it matters, at the middle of each new leaf that the edge of a shadow may cross,
/// on which side of it one is; decades.
std::vector<double> AdaptiveField::State::doubt_of_leaves(
    Octree::Index first_cell) const {
  std::vector<Query> queries;
  std::vector<double> decades(tree.cells().size() - first_cell, 0);
  for (auto c = first_cell; c < tree.cells().size(); ++c) {
    if (!tree.is_leaf(c) || !in_doubt(c)) continue;
    if (tree.cells()[c].level < tree.depth()) {
      queries.push_back({c, tree.box_of(c).center()});
    } else {
      decades[c - first_cell] = 1;  // nothing more can be done about it
    }
  }
  const std::vector<PoseValue> seen = values_at(queries, DoubtRule::all_seen);
  const std::vector<PoseValue> hidden = values_at(queries, DoubtRule::all_hidden);
  for (std::size_t i = 0; i < queries.size(); ++i) {
    decades[queries[i].cell - first_cell] =
        decades_apart(seen[i].value, hidden[i].value);
  }
  return decades;
}

/// Estimate the errors of new leaves.
///
/// Triquadratic interpolation errs with the third power of a family's size: what its
/// parent was off at a leaf's corners, an eighth of that is expected within the leaf.
void AdaptiveField::State::estimate(Octree::Index first_cell, std::size_t first_node) {
  constexpr double kOrder3 = 1.0 / 8;
  const std::vector<double> off = surplus(first_cell, first_node);
  const std::vector<double> doubt = doubt_of_leaves(first_cell);
  error.resize(tree.cells().size(), 0);
  smooth.resize(tree.cells().size(), kInfinity);
  for (auto c = first_cell; c < tree.cells().size(); ++c) {
    if (!tree.is_leaf(c)) continue;
    const Octree::Cell& cell = tree.cells()[c];
    if (cell.level >= tree.depth()) {
      smooth[c] = smooth[cell.parent] * kOrder3;
    } else if (cell.level > 1) {  // before that, there is nothing to judge from
      double most = 0;
      for (const Octree::Index node : tree.corners(c)) {
        if (node >= first_node) most = std::max(most, off[node - first_node]);
      }
      smooth[c] = most * kOrder3;
    }
    error[c] = std::max(smooth[c], doubt[c - first_cell]);
  }
}

/// Whether somebody asked for detail in this leaf.
bool AdaptiveField::State::wanted(Octree::Index leaf) const {
  const Octree::Corners corners = tree.corners(leaf);
  if (std::all_of(corners.begin(), corners.end(),
                  [this](Octree::Index n) { return inside[n] != 0; })) {
    return false;
  }
  if (sampling.within && !sampling.within->intersects(tree.box_of(leaf))) return false;
  if (!sampling.near_value || error[leaf] == kInfinity) return true;
  // Blind corners are on the far side of any value; the leaf's own error widens it.
  double least = kInfinity, most = 0;
  for (const Octree::Index n : corners) {
    least = std::min(least, value[n].value);
    most = std::max(most, value[n].value);
  }
  const double widen = std::pow(10.0, std::min(1.0, 2 * error[leaf]));
  return least <= *sampling.near_value * widen && most * widen >= *sampling.near_value;
}

/// The leaves to halve next, those that are most off first where not all can be.
std::vector<Octree::Index> AdaptiveField::State::mark() {
  // Halving a leaf brings about this many nodes that it doesn't share.
  constexpr double kNodesALeaf = 8;
  const double most = std::log10(1 + sampling.tolerance);
  std::vector<Octree::Index> marked;
  bool deepest = false;
  for (const Octree::Index leaf : tree.leaves()) {
    if (error[leaf] <= most || !wanted(leaf)) continue;
    if (tree.cells()[leaf].level < tree.depth()) {
      marked.push_back(leaf);
    } else {
      deepest = true;
    }
  }
  report.stop = deepest ? AdaptiveStop::depth : AdaptiveStop::tolerance;
  if (!sampling.evaluations || marked.empty()) return tree.closed(marked);

  const double left =
      (static_cast<double>(*sampling.evaluations) - static_cast<double>(evaluations)) /
      (kNodesALeaf * static_cast<double>(turns.size()));
  const auto allowed = static_cast<std::size_t>(std::max(0.0, left));
  if (allowed >= marked.size()) return tree.closed(marked);
  std::stable_sort(marked.begin(), marked.end(),
                   [this](auto a, auto b) { return error[a] > error[b]; });
  marked.resize(allowed);
  if (marked.empty()) report.stop = AdaptiveStop::evaluations;
  return tree.closed(marked);
}

void AdaptiveField::State::grow() {
  Octree::Index first_cell = 0;
  std::size_t first_node = 0;
  while (true) {
    if (!observe_level(first_cell)) {
      report.stop = cancelled() ? AdaptiveStop::cancelled : AdaptiveStop::deadline;
      // The level before is whole.
      if (first_cell > 0) tree.revert(first_cell, first_node);
      store.shrink(first_node);
      value.resize(first_node);
      views.follow(tree, threads);
      return;
    }
    estimate(first_cell, first_node);
    if (options.on_level) options.on_level(node_field());
    const std::vector<Octree::Index> marked = mark();
    if (marked.empty()) return;
    first_node = tree.nodes();
    first_cell = tree.refine(marked);
  }
}

}  // namespace delos
