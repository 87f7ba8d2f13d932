#include "delos/layers/layers.h"

#include <algorithm>
#include <cmath>

#include "delos/parallel/each.h"
#include "layers/block.h"
#include "observe/measure.h"

namespace delos {
namespace {

bool same_layer(const System& a, const System& b, std::size_t i) {
  const PlacedDevice &p = a.devices[i], &q = b.devices[i];
  return p.device == q.device && p.mount == q.mount && p.noise == q.noise &&
         p.clock == q.clock && p.own == q.own && p.without_sight == q.without_sight;
}

/// True where a layer of one is a layer of the other.
bool same_frame(const System& a, const System& b) {
  return a.devices.size() == b.devices.size() && a.markers == b.markers &&
         information_size(a) == information_size(b) && a.in_world == b.in_world &&
         a.on_target == b.on_target && a.skin == b.skin &&
         a.motion.layout.pose == b.motion.layout.pose;
}

}  // namespace

InformationLayers::InformationLayers(const System& system,
                                     std::vector<TargetPose> poses,
                                     const LayerOptions& options)
    : system_(system),
      shape_(std::make_unique<LayerShape>(system)),
      poses_(std::move(poses)),
      options_(options) {
  fill_all();
}

InformationLayers::InformationLayers() = default;
InformationLayers::InformationLayers(InformationLayers&&) noexcept = default;
InformationLayers& InformationLayers::operator=(InformationLayers&&) noexcept = default;
InformationLayers::~InformationLayers() = default;

std::size_t InformationLayers::block_count() const {
  return (poses_.size() + kLanes - 1) / kLanes;
}

std::size_t InformationLayers::bytes() const {
  const std::size_t numbers = (shape_->devices + shape_->groups + 1) * shape_->stride;
  return block_count() *
         (numbers * sizeof(double) + 2 * shape_->devices * sizeof(std::uint64_t));
}

std::span<const TargetPose> InformationLayers::poses_of(std::size_t b) const {
  const std::size_t first = b * kLanes;
  return std::span(poses_).subspan(
      first, std::min<std::size_t>(kLanes, poses_.size() - first));
}

void InformationLayers::fill_all() {
  kept_ = bytes() <= options_.memory_limit;
  blocks_.clear();
  if (!kept_) return;
  blocks_.resize(block_count());
  each(blocks_.size(), {.threads = options_.threads},
       [&](std::size_t b) { fill(b, blocks_[b]); });
}

std::size_t InformationLayers::update(const System& system) {
  const bool same = same_frame(system_, system);
  std::vector<std::size_t> changed;
  for (std::size_t i = 0; same && i < system.devices.size(); ++i) {
    if (!same_layer(system_, system, i)) changed.push_back(i);
  }
  const std::vector<double> weights = shape_->weights;
  const double prior = shape_->prior;
  system_ = system;
  *shape_ = LayerShape(system);
  if (!same) {
    fill_all();
    return kept_ ? shape_->devices : 0;
  }
  const bool reweighted = weights != shape_->weights;
  if (!kept_ || (changed.empty() && !reweighted && prior == shape_->prior)) return 0;

  std::vector<std::size_t> groups;
  for (std::size_t g = 0; g < shape_->groups; ++g) {
    const bool touched = std::any_of(changed.begin(), changed.end(),
                                     [&](std::size_t i) { return i / kGroup == g; });
    if (touched || reweighted) groups.push_back(g);
  }
  each(blocks_.size(), {.threads = options_.threads}, [&](std::size_t b) {
    for (const std::size_t i : changed)
      observe_device(system_, *shape_, i, poses_of(b), blocks_[b]);
    for (const std::size_t g : groups) sum_group(*shape_, g, blocks_[b]);
    sum_total(*shape_, blocks_[b]);
    check_total(system_, *shape_, blocks_[b]);
  });
  return changed.size();
}

InformationLayers InformationLayers::without(std::size_t device) const {
  System rest = system_;
  rest.devices.erase(rest.devices.begin() + static_cast<std::ptrdiff_t>(device));
  if (!kept_ || information_size(rest) != shape_->columns)
    return InformationLayers(rest, poses_, options_);
  InformationLayers out;
  out.system_ = std::move(rest);
  out.shape_ = std::make_unique<LayerShape>(out.system_);
  out.poses_ = poses_;
  out.options_ = options_;
  out.kept_ = true;
  out.blocks_.resize(blocks_.size());
  const auto skip = [&](const auto& from, std::size_t each, auto& to) {
    const auto at = from.begin() + static_cast<std::ptrdiff_t>(device * each);
    std::copy(from.begin(), at, to.begin());
    std::copy(at + static_cast<std::ptrdiff_t>(each), from.end(),
              to.begin() + (at - from.begin()));
  };
  each(blocks_.size(), {.threads = options_.threads}, [&](std::size_t b) {
    clear_block(*out.shape_, blocks_[b].lanes, out.blocks_[b]);
    skip(blocks_[b].layers, shape_->stride, out.blocks_[b].layers);
    skip(blocks_[b].seen, 1, out.blocks_[b].seen);
    skip(blocks_[b].perfect, 1, out.blocks_[b].perfect);
    sum_layers(*out.shape_, out.blocks_[b]);
  });
  return out;
}

const LayerBlock& InformationLayers::block(std::size_t b, LayerBlock& scratch) const {
  if (kept_) return blocks_[b];
  fill(b, scratch);
  return scratch;
}

void InformationLayers::fill(std::size_t b, LayerBlock& block) const {
  fill_block(system_, *shape_, poses_of(b), block);
}

WhitenedRows whitened_rows(const System& system, const TargetPose& pose) {
  const int columns = information_size(system);
  std::vector<Eigen::RowVectorXd> noisy, exact;
  WhitenedRows out;
  MeasureScratch scratch;
  for (std::size_t i = 0; i < system.devices.size(); ++i) {
    measure(system, system.devices[i], pose, columns, scratch,
            [&](const StateRow& row) {
              if (row.perfect()) {
                exact.emplace_back(row.h);
                return;
              }
              noisy.emplace_back(row.h * std::sqrt(row.weight()));
              out.device.push_back(static_cast<int>(i));
              out.variance.push_back(row.variance);
              out.share.push_back(row.share);
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
