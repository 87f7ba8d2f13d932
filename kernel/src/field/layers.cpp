#include "delos/field/layers.h"

#include <omp.h>

#include <algorithm>
#include <cmath>

#include "field/measure.h"
#include "field/point_lanes.h"

namespace delos {
namespace {

constexpr std::size_t kGroup = 8;

std::size_t group_count(std::size_t devices) { return (devices + kGroup - 1) / kGroup; }

int packed_size(int columns) { return columns * (columns + 1) / 2; }

/// Rates of information where updates are asynchronous; else information of one update.
std::vector<double> fusion_weights(const System& system) {
  std::vector<double> weights;
  for (const PlacedDevice& d : system.devices) {
    weights.push_back(system.fusion == Fusion::continuous ? 1 / d.period : 1.0);
  }
  return weights;
}

bool same_layer(const System& a, const System& b, std::size_t i) {
  return a.devices[i].device == b.devices[i].device &&
         a.devices[i].X_WS == b.devices[i].X_WS;
}

/// True where a layer of one is a layer of the other.
bool same_frame(const System& a, const System& b) {
  return a.devices.size() == b.devices.size() && a.markers == b.markers &&
         information_size(a) == information_size(b) &&
         a.motion.layout.pose == b.motion.layout.pose;
}

}  // namespace

InformationLayers::InformationLayers(const System& system,
                                     std::vector<TargetPose> poses,
                                     const LayerOptions& options)
    : system_(system), poses_(std::move(poses)), options_(options) {
  fill_all();
}

std::size_t InformationLayers::block_count() const {
  return (poses_.size() + kLanes - 1) / kLanes;
}

std::size_t InformationLayers::bytes() const {
  const std::size_t devices = system_.devices.size();
  const std::size_t numbers = (devices + group_count(devices) + 1) * packed_ * kLanes;
  return block_count() *
         (numbers * sizeof(double) + 2 * devices * sizeof(std::uint64_t));
}

void InformationLayers::fill_all() {
  columns_ = information_size(system_);
  packed_ = packed_size(columns_);
  weights_ = fusion_weights(system_);
  kept_ = bytes() <= options_.memory_limit;
  blocks_.clear();
  if (!kept_) return;
  blocks_.resize(block_count());
  const int threads = options_.threads > 0 ? options_.threads : omp_get_max_threads();
#pragma omp parallel for schedule(dynamic) num_threads(threads)
  for (std::size_t b = 0; b < blocks_.size(); ++b) fill(b, blocks_[b]);
}

std::size_t InformationLayers::update(const System& system) {
  if (!same_frame(system_, system)) {
    system_ = system;
    fill_all();
    return kept_ ? system_.devices.size() : 0;
  }
  std::vector<std::size_t> changed;
  for (std::size_t i = 0; i < system.devices.size(); ++i) {
    if (!same_layer(system_, system, i)) changed.push_back(i);
  }
  system_ = system;
  const std::vector<double> weights = fusion_weights(system_);
  const bool reweighted = weights != weights_;
  weights_ = weights;
  if (!kept_) return 0;
  if (changed.empty() && !reweighted) return 0;

  std::vector<std::size_t> groups;
  for (std::size_t g = 0; g < group_count(system_.devices.size()); ++g) {
    const bool touched = std::any_of(changed.begin(), changed.end(),
                                     [&](std::size_t i) { return i / kGroup == g; });
    if (touched || reweighted) groups.push_back(g);
  }
  const int threads = options_.threads > 0 ? options_.threads : omp_get_max_threads();
#pragma omp parallel for schedule(dynamic) num_threads(threads)
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    for (const std::size_t i : changed) observe(b, i, blocks_[b]);
    for (const std::size_t g : groups) sum_group(g, blocks_[b]);
    sum_total(blocks_[b]);
  }
  return changed.size();
}

const LayerBlock& InformationLayers::block(std::size_t b, LayerBlock& scratch) const {
  if (kept_) return blocks_[b];
  fill(b, scratch);
  return scratch;
}

void InformationLayers::fill(std::size_t b, LayerBlock& block) const {
  const std::size_t devices = system_.devices.size();
  block.lanes = static_cast<int>(std::min<std::size_t>(
      kLanes, poses_.size() - b * static_cast<std::size_t>(kLanes)));
  const std::size_t stride = static_cast<std::size_t>(packed_) * kLanes;
  block.layers.resize(devices * stride);
  block.groups.resize(group_count(devices) * stride);
  block.total.resize(stride);
  block.seen.resize(devices);
  block.perfect.resize(devices);
  for (std::size_t i = 0; i < devices; ++i) observe(b, i, block);
  for (std::size_t g = 0; g < group_count(devices); ++g) sum_group(g, block);
  sum_total(block);
}

// S = Σ hᵀ h / r over the device's rows of independent noise.
void InformationLayers::observe(std::size_t b, std::size_t device,
                                LayerBlock& block) const {
  const PlacedDevice& placed = system_.devices[device];
  double* layer =
      block.layers.data() + device * static_cast<std::size_t>(packed_) * kLanes;
  std::fill_n(layer, static_cast<std::size_t>(packed_) * kLanes, 0.0);
  const std::size_t first = b * kLanes, lanes = static_cast<std::size_t>(block.lanes);
  SeenLanes known;
  if (placed.device->span() == Span::point &&
      add_point_information(system_, placed, {poses_.data() + first, lanes}, layer,
                            known)) {
    block.seen[device] = known.seen;
    block.perfect[device] = known.perfect;
    return;
  }
  std::uint64_t seen = 0, perfect = 0;
  MeasureScratch scratch;
  for (int lane = 0; lane < block.lanes; ++lane) {
    const TargetPose& X_WT = poses_[first + static_cast<std::size_t>(lane)];
    const std::uint64_t bit = std::uint64_t{1} << lane;
    const auto noisy = [&](const auto& row, double variance) {
      const double weight = 1 / variance;
      for (int i = 0; i < columns_; ++i) {
        const double scaled = weight * row(i);
        for (int j = 0; j <= i; ++j)
          layer[packed_index(i, j) * kLanes + lane] += scaled * row(j);
      }
    };
    const auto exact = [&](const auto&) { perfect |= bit; };
    const bool sees =
        measure(system_, placed, X_WT, columns_, scratch,
                [&](const StateRows& rows, const decltype(Observation::R)& R) {
                  whiten(rows, R, noisy, exact);
                });
    if (sees) seen |= bit;
  }
  block.seen[device] = seen;
  block.perfect[device] = perfect;
}

void InformationLayers::sum_group(std::size_t group, LayerBlock& block) const {
  const std::size_t stride = static_cast<std::size_t>(packed_) * kLanes;
  double* sum = block.groups.data() + group * stride;
  std::fill_n(sum, stride, 0.0);
  const std::size_t end = std::min(system_.devices.size(), (group + 1) * kGroup);
  for (std::size_t i = group * kGroup; i < end; ++i) {
    if (!block.seen[i]) continue;
    const double* layer = block.layers.data() + i * stride;
    const double weight = weights_[i];
    for (std::size_t e = 0; e < stride; ++e) sum[e] += weight * layer[e];
  }
}

void InformationLayers::sum_total(LayerBlock& block) const {
  const std::size_t stride = static_cast<std::size_t>(packed_) * kLanes;
  std::fill_n(block.total.data(), stride, 0.0);
  for (std::size_t g = 0; g < group_count(system_.devices.size()); ++g) {
    const double* sum = block.groups.data() + g * stride;
    for (std::size_t e = 0; e < stride; ++e) block.total[e] += sum[e];
  }
}

WhitenedRows whitened_rows(const System& system, const TargetPose& pose) {
  const int columns = information_size(system);
  std::vector<Eigen::RowVectorXd> noisy, exact;
  WhitenedRows out;
  MeasureScratch scratch;
  for (std::size_t i = 0; i < system.devices.size(); ++i) {
    const auto keep = [&](const auto& row, double variance) {
      noisy.emplace_back(row / std::sqrt(variance));
      out.device.push_back(static_cast<int>(i));
    };
    const auto keep_exact = [&](const auto& row) { exact.emplace_back(row); };
    measure(system, system.devices[i], pose, columns, scratch,
            [&](const StateRows& rows, const decltype(Observation::R)& R) {
              whiten(rows, R, keep, keep_exact);
            });
  }
  out.rows.resize(static_cast<Eigen::Index>(noisy.size()), columns);
  for (std::size_t i = 0; i < noisy.size(); ++i) {
    out.rows.row(static_cast<Eigen::Index>(i)) = noisy[i];
  }
  out.exact.resize(static_cast<Eigen::Index>(exact.size()), columns);
  for (std::size_t i = 0; i < exact.size(); ++i) {
    out.exact.row(static_cast<Eigen::Index>(i)) = exact[i];
  }
  return out;
}

}  // namespace delos
