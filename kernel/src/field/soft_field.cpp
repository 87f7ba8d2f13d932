#include "delos/field/soft_field.h"

#include <omp.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "delos/model/lanes.h"
#include "field/first_failure.h"
#include "field/metric_slope.h"
#include "field/soft_information.h"

namespace delos {
namespace {

/// Points that one thread takes at a time; sums run in their order.
constexpr std::size_t kChunk = 32;

double weight_of(const System& system, const PlacedDevice& placed) {
  return system.fusion == Fusion::continuous ? 1 / placed.period : 1;
}

void pack(const StateMatrix& S, double* packed) {
  for (int i = 0; i < S.rows(); ++i)
    for (int j = 0; j <= i; ++j) *packed++ = S(i, j);
}

void unpack(const double* packed, int n, StateMatrix& S) {
  S.resize(n, n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j <= i; ++j) S(i, j) = S(j, i) = *packed++;
}

}  // namespace

struct SoftField::State {
  Samples samples;
  Orientations orientations;
  std::vector<Metric> metrics;
  double floor = 0;
  int threads = 0;
  std::vector<Eigen::Matrix3d> turns;

  // Of the field last evaluated.
  System system;
  std::optional<SoftOccluders> occluders;
  double width = 0;
  int columns = 0;
  std::vector<std::vector<double>> values;  // metrics × samples
  std::vector<double> information;          // samples × turns × packed
  std::vector<double> adjoint;              // likewise, ∂J/∂S
  std::vector<Sightline> lines;             // samples × turns × devices × markers
  std::vector<unsigned char> chosen;        // metrics × samples: the turn that counts

  [[nodiscard]] std::size_t points() const { return samples.points.size(); }
  [[nodiscard]] std::size_t chunks() const { return (points() + kChunk - 1) / kChunk; }
  [[nodiscard]] std::size_t packed() const {
    return static_cast<std::size_t>(packed_index(columns, 0));
  }
  [[nodiscard]] TargetPose pose(std::size_t point, std::size_t turn) const {
    return {turns[turn], samples.points[point]};
  }
  [[nodiscard]] std::size_t offset(std::size_t point, std::size_t turn) const {
    return (point * turns.size() + turn) * packed();
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
    FirstFailure failure;
    const int count = threads > 0 ? threads : omp_get_max_threads();
#pragma omp parallel for schedule(dynamic) num_threads(count)
    for (std::size_t c = 0; c < chunks(); ++c) failure.guard([&] { body(c); });
    failure.rethrow();
  }
  template <class Body>
  void each_point(std::size_t chunk, Body&& body) const {
    const std::size_t end = std::min(points(), (chunk + 1) * kChunk);
    for (std::size_t p = chunk * kChunk; p < end; ++p) body(p);
  }

  void evaluate_point(const SoftInformation& soft, const MetricSlope& metric,
                      std::size_t point, MeasureScratch& scratch);
  void combine(std::size_t point, const double* of_turns);
  void mean_information(std::size_t point, StateMatrix& S) const;
  void adjoin_point(const MetricSlope& metric, std::size_t point,
                    const std::vector<std::vector<double>>& slopes);
};

void SoftField::State::mean_information(std::size_t point, StateMatrix& S) const {
  S.setZero(columns, columns);
  StateMatrix of_turn;
  for (std::size_t t = 0; t < turns.size(); ++t) {
    unpack(&information[offset(point, t)], columns, of_turn);
    S += of_turn / static_cast<double>(turns.size());
  }
}

void SoftField::State::evaluate_point(const SoftInformation& soft,
                                      const MetricSlope& metric, std::size_t point,
                                      MeasureScratch& scratch) {
  StateMatrix S;
  std::vector<double> of_turns(turns.size() * metrics.size());
  for (std::size_t t = 0; t < turns.size(); ++t) {
    S.setZero(columns, columns);
    S.diagonal().head(system.motion.layout.coordinates()).setConstant(floor);
    for (std::size_t i = 0; i < system.devices.size(); ++i) {
      const PlacedDevice& device = system.devices[i];
      soft.add(device, pose(point, t), weight_of(system, device), lines_of(point, t, i),
               scratch, S);
    }
    pack(S, &information[offset(point, t)]);
    if (!by_information()) metric.values(S, &of_turns[t * metrics.size()]);
  }
  if (by_information()) {
    mean_information(point, S);
    metric.values(S, of_turns.data());
  }
  combine(point, of_turns.data());
}

void SoftField::State::combine(std::size_t point, const double* of_turns) {
  const std::size_t count = by_information() ? 1 : turns.size();
  for (std::size_t m = 0; m < metrics.size(); ++m) {
    const auto at = [&](std::size_t t) { return of_turns[t * metrics.size() + m]; };
    std::size_t worst = 0;
    double sum = at(0);
    for (std::size_t t = 1; t < count; ++t) {
      const bool worse =
          std::isinf(at(t)) ||
          (!std::isinf(at(worst)) &&
           (metrics[m].larger_is_better ? at(t) < at(worst) : at(t) > at(worst)));
      if (worse) worst = t;
      sum += at(t);
    }
    chosen[m * points() + point] = static_cast<unsigned char>(worst);
    values[m][point] = orientations.combine == OrientationRule::mean
                           ? sum / static_cast<double>(count)
                           : at(worst);
  }
}

void SoftField::State::adjoin_point(const MetricSlope& metric, std::size_t point,
                                    const std::vector<std::vector<double>>& slopes) {
  std::vector<double> weights(metrics.size());
  StateMatrix S, G;
  const double share = 1 / static_cast<double>(turns.size());
  if (by_information()) {
    for (std::size_t m = 0; m < metrics.size(); ++m)
      weights[m] = slopes[m][point] * share;
    mean_information(point, S);
    metric.slope(S, weights.data(), G);
    for (std::size_t t = 0; t < turns.size(); ++t) pack(G, &adjoint[offset(point, t)]);
    return;
  }
  for (std::size_t t = 0; t < turns.size(); ++t) {
    for (std::size_t m = 0; m < metrics.size(); ++m) {
      const bool mean = orientations.combine == OrientationRule::mean;
      const bool counts = mean || chosen[m * points() + point] == t;
      weights[m] = counts ? slopes[m][point] * (mean ? share : 1) : 0;
    }
    double* out = &adjoint[offset(point, t)];
    if (std::all_of(weights.begin(), weights.end(), [](double w) { return w == 0; })) {
      std::fill_n(out, packed(), 0.0);
      continue;
    }
    unpack(&information[offset(point, t)], columns, S);
    metric.slope(S, weights.data(), G);
    pack(G, out);
  }
}

SoftField::SoftField(Samples samples, Orientations orientations,
                     std::vector<Metric> metrics, double floor, int threads)
    : state_(std::make_unique<State>()) {
  State& s = *state_;
  s.samples = std::move(samples);
  s.orientations = std::move(orientations);
  s.metrics = std::move(metrics);
  s.floor = floor;
  s.threads = threads;
  for (const Eigen::Vector3d& rpy : s.orientations.rpy)
    s.turns.push_back(rotation_from_rpy(rpy));
  s.values.assign(s.metrics.size(), std::vector<double>(s.points()));
  s.chosen.resize(s.metrics.size() * s.points());
}

SoftField::~SoftField() = default;

const std::vector<std::vector<double>>& SoftField::evaluate(const System& system,
                                                            double width) {
  State& s = *state_;
  s.system = system;
  s.width = width;
  s.columns = information_size(system);
  if (!s.occluders || s.occluders->entries != system.occluders)
    s.occluders.emplace(system);
  s.information.resize(s.points() * s.turns.size() * s.packed());
  s.lines.assign(
      s.points() * s.turns.size() * system.devices.size() * system.markers.size(), {});
  const SoftInformation soft(s.system, *s.occluders, width);
  const MetricSlope metric(s.system, s.metrics);
  s.each_chunk([&](std::size_t c) {
    MeasureScratch scratch;
    s.each_point(c, [&](std::size_t p) { s.evaluate_point(soft, metric, p, scratch); });
  });
  return s.values;
}

void SoftField::adjoin(const std::vector<std::vector<double>>& slopes) {
  State& s = *state_;
  s.adjoint.resize(s.information.size());
  const MetricSlope metric(s.system, s.metrics);
  s.each_chunk([&](std::size_t c) {
    s.each_point(c, [&](std::size_t p) { s.adjoin_point(metric, p, slopes); });
  });
}

std::vector<PoseSlope> SoftField::pose_slopes() const {
  State& s = *state_;
  const SoftInformation soft(s.system, *s.occluders, s.width);
  const std::size_t devices = s.system.devices.size();
  std::vector<PoseSlope> of_chunks(s.chunks() * devices, PoseSlope::Zero());
  std::vector<bool> exact(devices);
  for (std::size_t i = 0; i < devices; ++i)
    exact[i] = soft.has_slopes(s.system.devices[i]);
  s.each_chunk([&](std::size_t c) {
    StateMatrix G;
    s.each_point(c, [&](std::size_t p) {
      for (std::size_t t = 0; t < s.turns.size(); ++t) {
        unpack(&s.adjoint[s.offset(p, t)], s.columns, G);
        if (G.isZero(0)) continue;
        for (std::size_t i = 0; i < devices; ++i) {
          if (exact[i])
            of_chunks[c * devices + i] +=
                soft.slope(s.system.devices[i], s.pose(p, t), s.lines_of(p, t, i), G);
        }
      }
    });
  });

  std::vector<PoseSlope> slopes(devices, PoseSlope::Zero());
  for (std::size_t c = 0; c < s.chunks(); ++c)
    for (std::size_t i = 0; i < devices; ++i) slopes[i] += of_chunks[c * devices + i];
  for (std::size_t i = 0; i < devices; ++i) {
    const PlacedDevice& device = s.system.devices[i];
    if (exact[i]) {
      slopes[i] *= weight_of(s.system, device);
      continue;
    }
    // The place of these means nothing, or isn't in the world.
    if (device.device->span() == Span::state || device.beacons) continue;
    constexpr double kStep = 1e-5;                       // metres, radians
    for (int k = 0; k < 6; ++k) {
      PlacedDevice to = device, from = device;
      const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(k % 3);
      if (k < 3) {
        to.X_WS.p += step;
        from.X_WS.p -= step;
      } else {
        const Eigen::AngleAxisd turn(kStep, Eigen::Vector3d::Unit(k % 3));
        to.X_WS.R = turn * device.X_WS.R;
        from.X_WS.R = turn.inverse() * device.X_WS.R;
      }
      slopes[i](k) = (contraction(i, to) - contraction(i, from)) / (2 * kStep);
    }
  }
  return slopes;
}

double SoftField::contraction(std::size_t index, const PlacedDevice& device) const {
  State& s = *state_;
  const SoftInformation soft(s.system, *s.occluders, s.width);
  const double weight = weight_of(s.system, device);
  // Where it stands as it did, it sees along the same lines.
  const bool moved = !(device.X_WS == s.system.devices[index].X_WS);
  std::vector<double> of_chunks(s.chunks());
  s.each_chunk([&](std::size_t c) {
    MeasureScratch scratch;
    StateMatrix G, S;
    std::vector<Sightline> own(s.system.markers.size());
    s.each_point(c, [&](std::size_t p) {
      for (std::size_t t = 0; t < s.turns.size(); ++t) {
        unpack(&s.adjoint[s.offset(p, t)], s.columns, G);
        if (G.isZero(0)) continue;
        if (moved) std::fill(own.begin(), own.end(), Sightline{});
        S.setZero(s.columns, s.columns);
        soft.add(device, s.pose(p, t), weight,
                 moved ? own.data() : s.lines_of(p, t, index), scratch, S);
        of_chunks[c] += G.cwiseProduct(S).sum();
      }
    });
  });
  double sum = 0;
  for (const double part : of_chunks) sum += part;
  return sum;
}

}  // namespace delos
