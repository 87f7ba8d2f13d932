// The whole of an adaptive field while it grows and when it is read.
#pragma once

#include <chrono>
#include <memory>
#include <vector>

#include "delos/field/adaptive.h"
#include "delos/sampling/octree.h"
#include "field/interpolation.h"
#include "field/place_evaluator.h"

namespace delos {

/// The whole of an adaptive field, grown level by level.
struct AdaptiveField::State {
  State(const System& s, const AdaptiveSampling& a, const Orientations& o,
        const Metric& m, const AdaptiveOptions& given);

  void grow();
  void finish();
  [[nodiscard]] Field read(const Samples& samples, ShadowEdges edges) const;

  template <class Fill>
  [[nodiscard]] std::vector<PoseValue> solve(std::span<const Query> queries,
                                             Fill&& fill) const;
  [[nodiscard]] std::vector<PoseValue> values_at(std::span<const Query> queries,
                                                 DoubtRule doubt) const;
  [[nodiscard]] bool cancelled() const;
  [[nodiscard]] bool out_of_time() const;
  bool observe_level(Octree::Index first_cell);
  void estimate(Octree::Index first_cell, std::size_t first_node);
  [[nodiscard]] std::vector<double> surplus(Octree::Index first_cell,
                                            std::size_t first_node) const;
  [[nodiscard]] bool in_doubt(Octree::Index cell) const;
  [[nodiscard]] std::vector<double> doubt_of_leaves(Octree::Index first_cell) const;
  [[nodiscard]] bool wanted(Octree::Index leaf) const;
  [[nodiscard]] std::vector<Octree::Index> mark();
  [[nodiscard]] Field node_field() const;
  [[nodiscard]] double held_back_error();
  [[nodiscard]] bool has_edge(Octree::Index cell) const;
  [[nodiscard]] std::shared_ptr<const Field> spread_field();
  [[nodiscard]] PlaceEvaluator evaluator() const {
    return {*solver, system, metric, orientations.combine, turns.size()};
  }

  const System system;
  const AdaptiveSampling sampling;
  const Orientations orientations;
  const std::vector<Eigen::Matrix3d> turns;
  const Metric metric;
  const AdaptiveOptions options;
  const int threads;
  const std::unique_ptr<const SteadySolver> solver;
  const Sightings sightings;
  const std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();

  Octree tree;
  CellViews views;
  NodeStore store;
  Interpolation between;
  std::vector<PoseValue> value;       ///< one a node
  std::vector<unsigned char> inside;  ///< one a node: within a solid
  std::vector<double> smooth;  ///< one a cell, decades: what interpolation may be off
  std::vector<double> error;   ///< one a cell: that, or what a shadow's edge matters
  std::size_t evaluations = 0;

  AdaptiveReport report;
  Field field;
};

}  // namespace delos
