#include "delos/field/soft_field.h"

#include <Eigen/Geometry>

#include "field/soft_field_state.h"

namespace delos {

SoftField::SoftField(Samples samples, Orientations orientations,
                     std::vector<Metric> metrics, int threads)
    : state_(std::make_unique<State>()) {
  State& s = *state_;
  s.samples = std::move(samples);
  s.orientations = std::move(orientations);
  s.metrics = std::move(metrics);
  s.threads = threads;
  for (const Eigen::Vector3d& rpy : s.orientations.rpy)
    s.turns.push_back(rotation_from_rpy(rpy));
}

SoftField::~SoftField() = default;

const FieldValues& SoftField::evaluate(const System& system, double width,
                                       std::span<const std::size_t> failing) {
  State& s = *state_;
  s.prepare(system, width, failing);
  const SoftInformation soft(s.system, *s.occluders, width);
  const MetricSlope metric(s.system, s.metrics);
  s.each_chunk([&](std::size_t c) {
    SoftScratch scratch(metric, s.system.devices.size() * s.packed(),
                        s.cases() * s.turns.size() * s.metrics.size());
    s.each_point(c, [&](std::size_t p) { s.evaluate_point(soft, metric, p, scratch); });
  });
  return s.values.front();
}

std::span<const FieldValues> SoftField::failure_values() const {
  return std::span<const FieldValues>(state_->values).subspan(1);
}

void SoftField::adjoin(const FieldValues& slopes,
                       std::span<const FieldValues> of_failures) {
  State& s = *state_;
  // Only what is written below counts.
  s.adjoint.assign(s.information.size(), 0.0);
  const MetricSlope metric(s.system, s.metrics);
  s.each_chunk([&](std::size_t c) {
    MetricSlope::Scratch steady = metric.make_scratch();
    std::vector<double> weights(s.metrics.size());
    s.each_point(c, [&](std::size_t p) {
      s.adjoin_case(metric, p, 0, slopes, steady, weights);
      for (std::size_t k = 0; k < of_failures.size(); ++k)
        s.adjoin_case(metric, p, k + 1, of_failures[k], steady, weights);
      if (!of_failures.empty()) s.sum_adjoints(p);
    });
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
    double g = 0;
    s.each_point(c, [&](std::size_t p) {
      for (std::size_t t = 0; t < s.turns.size(); ++t) {
        for (std::size_t i = 0; i < devices; ++i) {
          if (!exact[i] || !s.adjoint_of(p, t, i, G, g)) continue;
          const PlacedDevice& device = s.system.devices[i];
          const double weight = information_weight(s.system, device);
          of_chunks[c * devices + i] +=
              soft.slope(device, s.pose(p, t), s.lines_of(p, t, i), weight * G, g);
        }
      }
    });
  });

  std::vector<PoseSlope> slopes(devices, PoseSlope::Zero());
  for (std::size_t c = 0; c < s.chunks(); ++c)
    for (std::size_t i = 0; i < devices; ++i) slopes[i] += of_chunks[c * devices + i];
  for (std::size_t i = 0; i < devices; ++i) {
    const PlacedDevice& device = s.system.devices[i];
    if (exact[i]) continue;
    // The place of these means nothing, or isn't in the world.
    if (device.device->span() == Span::state || device.carried()) continue;
    constexpr double kStep = 1e-5;  // metres, radians
    for (int k = 0; k < 6; ++k) {
      PlacedDevice to = device, from = device;
      const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(k % 3);
      if (k < 3) {
        to.X_WS().p += step;
        from.X_WS().p -= step;
      } else {
        const Eigen::AngleAxisd turn(kStep, Eigen::Vector3d::Unit(k % 3));
        to.X_WS().R = turn * device.X_WS().R;
        from.X_WS().R = turn.inverse() * device.X_WS().R;
      }
      slopes[i](k) = (contraction(i, to) - contraction(i, from)) / (2 * kStep);
    }
  }
  return slopes;
}

double SoftField::contraction(std::size_t index, const PlacedDevice& device) const {
  State& s = *state_;
  const SoftInformation soft(s.system, *s.occluders, s.width);
  const double weight = information_weight(s.system, device);
  // Where it stands as it did, it sees along the same lines.
  const bool moved = !(device.mount == s.system.devices[index].mount);
  std::vector<double> of_chunks(s.chunks());
  s.each_chunk([&](std::size_t c) {
    MeasureScratch scratch;
    StateMatrix G, S;
    double g = 0;
    std::vector<Sightline> own(s.system.markers.size());
    s.each_point(c, [&](std::size_t p) {
      for (std::size_t t = 0; t < s.turns.size(); ++t) {
        if (!s.adjoint_of(p, t, index, G, g)) continue;
        if (moved) std::fill(own.begin(), own.end(), Sightline{});
        S.setZero(s.columns, s.columns);
        const double seen =
            soft.add(device, s.pose(p, t), weight,
                     moved ? own.data() : s.lines_of(p, t, index), scratch, S);
        of_chunks[c] += G.cwiseProduct(S).sum() + g * seen;
      }
    });
  });
  double sum = 0;
  for (const double part : of_chunks) sum += part;
  return sum;
}

}  // namespace delos
