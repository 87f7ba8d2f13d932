#include <algorithm>
#include <cmath>

#include "delos/steady/combine.h"
#include "field/soft_field_state.h"

namespace delos {
namespace {

constexpr int kMostPacked = packed_index(kMaxState, 0) + 1;

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

void SoftField::State::prepare(const System& now, double edges,
                               std::span<const std::size_t> fail) {
  system = now;
  width = edges;
  columns = information_size(system);
  failing.assign(fail.begin(), fail.end());
  own_case.assign(system.devices.size(), 0);
  for (std::size_t k = 0; k < failing.size(); ++k) own_case[failing[k]] = k + 1;
  if (!occluders || occluders->entries != system.occluders) occluders.emplace(system);
  const std::size_t poses = points() * turns.size();
  values.resize(cases());
  for (FieldValues& of_case : values)
    of_case.resize(metrics.size(), std::vector<double>(points()));
  chosen.resize(cases() * metrics.size() * points());
  information.resize(poses * cases() * packed());
  lines.assign(poses * system.devices.size() * system.markers.size(), {});
}

/// The information of all devices, and the prior, in scratch.S.
/// @returns how many devices see the target
double SoftField::State::observe(const SoftInformation& soft, std::size_t point,
                                 std::size_t turn, SoftScratch& scratch) {
  double seen = 0;
  scratch.S.setZero(columns, columns);
  scratch.S.diagonal()
      .head(system.motion.layout.coordinates())
      .setConstant(system.prior);
  for (std::size_t i = 0; i < system.devices.size(); ++i) {
    const PlacedDevice& device = system.devices[i];
    seen += soft.add(device, pose(point, turn), information_weight(system, device),
                     lines_of(point, turn, i), scratch.measure, scratch.S);
  }
  return seen;
}

/// The same, device by device and without the prior, in scratch.layers.
void SoftField::State::observe_layers(const SoftInformation& soft, std::size_t point,
                                      std::size_t turn, SoftScratch& scratch) {
  for (std::size_t i = 0; i < system.devices.size(); ++i) {
    const PlacedDevice& device = system.devices[i];
    scratch.S.setZero(columns, columns);
    double* layer = &scratch.layers[i * packed()];
    layer[seen_at()] =
        soft.add(device, pose(point, turn), information_weight(system, device),
                 lines_of(point, turn, i), scratch.measure, scratch.S);
    pack(scratch.S, layer);
  }
}

/// The prior, and what the devices of a case know.
void SoftField::State::sum_layers(const std::vector<double>& layers,
                                  std::size_t of_case, double* out) const {
  std::fill_n(out, packed(), 0.0);
  for (int k = 0; k < system.motion.layout.coordinates(); ++k)
    out[packed_index(k, k)] = system.prior;
  for (std::size_t i = 0; i < system.devices.size(); ++i) {
    if (of_case > 0 && own_case[i] == of_case) continue;
    const double* layer = &layers[i * packed()];
    for (std::size_t e = 0; e < packed(); ++e) out[e] += layer[e];
  }
}

void SoftField::State::mean_information(std::size_t point, std::size_t of_case,
                                        double* S) const {
  std::fill_n(S, packed(), 0.0);
  for (std::size_t t = 0; t < turns.size(); ++t) {
    const double* of_turn = &information[offset(point, t, of_case)];
    for (std::size_t e = 0; e < packed(); ++e)
      S[e] += of_turn[e] / static_cast<double>(turns.size());
  }
}

void SoftField::State::evaluate_point(const SoftInformation& soft,
                                      const MetricSlope& metric, std::size_t point,
                                      SoftScratch& scratch) {
  const std::size_t of_case = turns.size() * metrics.size();  // values of a case
  for (std::size_t t = 0; t < turns.size(); ++t) {
    if (!failing.empty()) observe_layers(soft, point, t, scratch);
    for (std::size_t c = 0; c < cases(); ++c) {
      double* out = &information[offset(point, t, c)];
      if (failing.empty()) {
        out[seen_at()] = observe(soft, point, t, scratch);
        pack(scratch.S, out);
      } else {
        sum_layers(scratch.layers, c, out);
      }
      if (by_information()) continue;
      double* of_turn = &scratch.of_turns[c * of_case + t * metrics.size()];
      metric.values(out, {out[seen_at()], 0, samples.points[point]}, scratch.steady,
                    of_turn);
    }
  }
  for (std::size_t c = 0; c < cases(); ++c) {
    double* of_turns = &scratch.of_turns[c * of_case];
    if (by_information()) {
      double S[kMostPacked];
      mean_information(point, c, S);
      metric.values(S, {S[seen_at()], 0, samples.points[point]}, scratch.steady,
                    of_turns);
    }
    combine(point, c, of_turns);
  }
}

void SoftField::State::combine(std::size_t point, std::size_t of_case,
                               const double* of_turns) {
  const OrientationRule rule = orientations.combine;
  for (std::size_t m = 0; m < metrics.size(); ++m) {
    const CombinedValue all = delos::combine(
        rule, solved_turns(rule, turns.size()), metrics[m].larger_is_better,
        [&](std::size_t t) { return of_turns[t * metrics.size() + m]; });
    chosen_turn(of_case, m, point) = static_cast<unsigned char>(all.worst);
    values[of_case][m][point] = all.value;
  }
}

void SoftField::State::adjoin_case(const MetricSlope& metric, std::size_t point,
                                   std::size_t of_case, const FieldValues& slopes,
                                   MetricSlope::Scratch& steady,
                                   std::vector<double>& weights) {
  StateMatrix G;
  const double share = 1 / static_cast<double>(turns.size());
  if (by_information()) {
    for (std::size_t m = 0; m < metrics.size(); ++m)
      weights[m] = slopes[m][point] * share;
    double S[kMostPacked];
    mean_information(point, of_case, S);
    metric.slope(S, {S[seen_at()], 0, samples.points[point]}, weights.data(), steady,
                 G);
    for (std::size_t t = 0; t < turns.size(); ++t) {
      double* out = &adjoint[offset(point, t, of_case)];
      pack(G, out);
      out[seen_at()] = 0;
    }
    return;
  }
  for (std::size_t t = 0; t < turns.size(); ++t) {
    for (std::size_t m = 0; m < metrics.size(); ++m) {
      const bool mean = orientations.combine == OrientationRule::mean;
      const bool counts = mean || chosen_turn(of_case, m, point) == t;
      weights[m] = counts ? slopes[m][point] * (mean ? share : 1) : 0;
    }
    double* out = &adjoint[offset(point, t, of_case)];
    if (std::all_of(weights.begin(), weights.end(), [](double w) { return w == 0; })) {
      std::fill_n(out, packed(), 0.0);
      continue;
    }
    const double* S = &information[offset(point, t, of_case)];
    out[seen_at()] = metric.slope(S, {S[seen_at()], 0, samples.points[point]},
                                  weights.data(), steady, G);
    pack(G, out);
  }
}

/// ∂J/∂S of all cases together, where it is asked for as that of case 0.
void SoftField::State::sum_adjoints(std::size_t point) {
  for (std::size_t t = 0; t < turns.size(); ++t) {
    double* sum = &adjoint[offset(point, t, 0)];
    for (std::size_t c = 1; c < cases(); ++c) {
      const double* of_case = &adjoint[offset(point, t, c)];
      for (std::size_t e = 0; e < packed(); ++e) sum[e] += of_case[e];
    }
  }
}

// J depends on a device's information S_i by all cases that have the device:
//
//   ∂J/∂S_i = Σ_c ∂J/∂S_c − ∂J/∂S_(without i)
//
/// @param[out] g the same with respect to how far it sees the target
/// @returns false where both are 0, and leaves them alone
bool SoftField::State::adjoint_of(std::size_t point, std::size_t turn,
                                  std::size_t device, StateMatrix& G, double& g) const {
  const double* all = &adjoint[offset(point, turn, 0)];
  if (std::all_of(all, all + packed(), [](double slope) { return slope == 0; }))
    return false;
  unpack(all, columns, G);
  g = all[seen_at()];
  if (own_case[device] == 0) return true;
  StateMatrix own;
  const double* without = &adjoint[offset(point, turn, own_case[device])];
  unpack(without, columns, own);
  G -= own;
  g -= without[seen_at()];
  return true;
}

}  // namespace delos
