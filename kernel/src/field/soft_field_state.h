// What a soft field holds. Its points stand in soft_cases.cpp, its slopes in
// soft_field.cpp.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "delos/field/soft_field.h"
#include "delos/model/lanes.h"
#include "delos/parallel/each.h"
#include "observe/soft_information.h"
#include "steady/metric_slope.h"

namespace delos {

/// Points that one thread takes at a time; sums run in their order.
inline constexpr std::size_t kChunk = 32;

/// What one thread works with, made once.
struct SoftScratch {
  SoftScratch(const MetricSlope& metric, std::size_t layer_numbers,
              std::size_t turn_values)
      : steady(metric.make_scratch()), layers(layer_numbers), of_turns(turn_values) {}

  MeasureScratch measure;
  MetricSlope::Scratch steady;
  StateMatrix S;
  std::vector<double> layers;    // devices × packed: what each knows, weighted
  std::vector<double> of_turns;  // cases × turns × metrics
};

// A *case* is a set of devices: 0, all of them; k, all but the k-th that fails.
struct SoftField::State {
  Samples samples;
  Orientations orientations;
  std::vector<Metric> metrics;
  int threads = 0;
  std::vector<Eigen::Matrix3d> turns;

  // Of the field last evaluated.
  System system;
  std::optional<SoftOccluders> occluders;
  double width = 0;
  int columns = 0;
  std::vector<std::size_t> failing;   // devices
  std::vector<std::size_t> own_case;  // of each device: where it fails, or 0
  std::vector<FieldValues> values;    // of each case
  std::vector<double> information;    // samples × turns × cases × packed
  std::vector<double> adjoint;        // likewise: ∂J/∂S; of case 0, their sum
  std::vector<Sightline> lines;       // samples × turns × devices × markers
  std::vector<unsigned char> chosen;  // cases × metrics × samples: the turn that counts

  [[nodiscard]] std::size_t points() const { return samples.points.size(); }
  [[nodiscard]] std::size_t chunks() const { return (points() + kChunk - 1) / kChunk; }
  [[nodiscard]] std::size_t cases() const { return 1 + failing.size(); }
  /// The information, and at last how many devices see the target.
  [[nodiscard]] std::size_t packed() const { return seen_at() + 1; }
  [[nodiscard]] std::size_t seen_at() const {
    return static_cast<std::size_t>(packed_index(columns, 0));
  }
  [[nodiscard]] TargetPose pose(std::size_t point, std::size_t turn) const {
    return {turns[turn], samples.points[point]};
  }
  [[nodiscard]] std::size_t offset(std::size_t point, std::size_t turn,
                                   std::size_t of_case) const {
    return ((point * turns.size() + turn) * cases() + of_case) * packed();
  }
  [[nodiscard]] unsigned char& chosen_turn(std::size_t of_case, std::size_t metric,
                                           std::size_t point) {
    return chosen[(of_case * metrics.size() + metric) * points() + point];
  }
  [[nodiscard]] Sightline* lines_of(std::size_t point, std::size_t turn,
                                    std::size_t device) {
    const std::size_t pose = point * turns.size() + turn;
    return &lines[(pose * system.devices.size() + device) * system.markers.size()];
  }
  [[nodiscard]] bool by_information() const {
    return orientations.combine == OrientationRule::information;
  }

  /// body(chunk) on all threads.
  template <class Body>
  void each_chunk(Body&& body) const {
    each(chunks(), {.threads = threads}, body);
  }
  template <class Body>
  void each_point(std::size_t chunk, Body&& body) const {
    const std::size_t end = std::min(points(), (chunk + 1) * kChunk);
    for (std::size_t p = chunk * kChunk; p < end; ++p) body(p);
  }

  void prepare(const System& now, double edges, std::span<const std::size_t> fail);
  double observe(const SoftInformation& soft, std::size_t point, std::size_t turn,
                 SoftScratch& scratch);
  void observe_layers(const SoftInformation& soft, std::size_t point, std::size_t turn,
                      SoftScratch& scratch);
  void sum_layers(const std::vector<double>& layers, std::size_t of_case,
                  double* out) const;
  void evaluate_point(const SoftInformation& soft, const MetricSlope& metric,
                      std::size_t point, SoftScratch& scratch);
  void combine(std::size_t point, std::size_t of_case, const double* of_turns);
  void mean_information(std::size_t point, std::size_t of_case, double* S) const;
  void adjoin_case(const MetricSlope& metric, std::size_t point, std::size_t of_case,
                   const FieldValues& slopes, MetricSlope::Scratch& steady,
                   std::vector<double>& weights);
  void sum_adjoints(std::size_t point);
  bool adjoint_of(std::size_t point, std::size_t turn, std::size_t device,
                  StateMatrix& G, double& g) const;
};

}  // namespace delos
