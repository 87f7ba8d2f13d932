#include "cover/cover_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "cover/lagrangian.h"

namespace delos {
namespace {

/// Steps of the Lagrangian at a node.
constexpr int kSteps = 40;
/// What roundings may change, relative to a cost.
constexpr double kRounding = 1e-9;

}  // namespace

bool reaches(double bound, double limit, bool whole) {
  const double slack = kRounding * std::max(1.0, std::abs(limit));
  if (whole) return bound > limit - 1 + std::min(0.5, 1e3 * slack);
  return bound >= limit - slack;
}

CoverTree::CoverTree(const CoverCore& core, double bound,
                     const std::vector<double>& multipliers, bool whole)
    : root_(core), root_multipliers_(multipliers), whole_(whole), bound_(bound) {
  int samples = 0;
  for (const int i : core.sample) samples = std::max(samples, i + 1);
  of_sample_.assign(samples, 0);
}

void CoverTree::begin() {
  begun_ = true;
  // Without any cover, one of whatever cost is looked for.
  const bool rise = whole_ && std::isfinite(limit_);
  target_ = rise ? std::min(limit_, std::floor(bound_ + 0.5) + 1) : limit_;
  visit(root_, root_multipliers_);
}

void CoverTree::run(std::int64_t work, double limit) {
  limit_ = std::min({limit_, limit, best_cost_});
  const std::int64_t end = work_ + work;
  while (work_ < end && !done_) {
    target_ = std::min({target_, limit_, best_cost_});
    if (!begun_) {
      begin();
    } else if (!path_.empty()) {
      visit_child(path_.back());
    } else {
      // Nothing costs less than the target.
      limit_ = std::min(limit_, best_cost_);
      bound_ = std::max(bound_, target_);
      done_ = target_ >= limit_;
      begun_ = done_;
    }
  }
}

std::vector<double> CoverTree::inherited(const CoverCore& from,
                                         const std::vector<double>& multipliers,
                                         const CoverCore& to) {
  for (int i = 0; i < from.samples(); ++i) of_sample_[from.sample[i]] = multipliers[i];
  std::vector<double> out(to.samples());
  for (int i = 0; i < to.samples(); ++i) out[i] = of_sample_[to.sample[i]];
  return out;
}

void CoverTree::visit(const CoverCore& core, const std::vector<double>& multipliers) {
  work_ += 10 * static_cast<std::int64_t>(core.seen.items.size()) + 1000;
  CoverCore small = reduced(core);
  if (!unmet(small).empty()) return;
  if (small.samples() == 0) {
    if (!(small.chosen_cost < std::min(best_cost_, target_))) return;
    best_cost_ = small.chosen_cost;
    best_ = small.chosen;
    return;
  }
  Lagrangian dual(small, inherited(core, multipliers, small));
  const auto pruned = [&](double more) {
    return reaches(small.chosen_cost + dual.bound() + more, target_, whole_);
  };
  for (int k = 0; k < kSteps && !dual.settled() && !pruned(0); ++k) {
    dual.step(target_ - small.chosen_cost);
    work_ += 2 * static_cast<std::int64_t>(small.seen.items.size());
  }
  if (pruned(0)) return;

  std::vector<char> keep(small.candidates());
  std::vector<double> kept_costs;
  for (int j = 0; j < small.candidates(); ++j) {
    const double r = dual.reduced_costs()[j];
    keep[j] = !pruned(std::max(0.0, r));
    if (keep[j]) kept_costs.push_back(r);
  }
  branch(with_only(std::move(small), keep), dual.multipliers(), kept_costs);
}

void CoverTree::branch(CoverCore core, std::vector<double> multipliers,
                       const std::vector<double>& reduced_costs) {
  if (!unmet(core).empty()) return;
  const auto choices = [&](int i) {
    return static_cast<int>(core.seers[i].size()) - core.demand[i];
  };
  int fewest = 0;
  for (int i = 1; i < core.samples(); ++i) {
    const int a = choices(i), b = choices(fewest);
    if (a < b || (a == b && multipliers[i] > multipliers[fewest])) fewest = i;
  }
  Node node;
  const auto seers = core.seers[fewest];
  node.order.assign(seers.begin(), seers.end());
  std::stable_sort(node.order.begin(), node.order.end(),
                   [&](int a, int b) { return reduced_costs[a] < reduced_costs[b]; });
  // The last ones of the order are too few by themselves.
  node.last = static_cast<std::size_t>(choices(fewest));
  node.core = std::move(core);
  node.multipliers = std::move(multipliers);
  path_.push_back(std::move(node));
}

void CoverTree::visit_child(Node& node) {
  if (node.next > node.last) {
    path_.pop_back();
    return;
  }
  const int chosen = node.order[node.next];
  CoverCore child = node.core;
  std::vector<char> keep(child.candidates(), 1);
  for (std::size_t k = 0; k < node.next; ++k) keep[node.order[k]] = 0;
  ++node.next;
  const int place = std::accumulate(keep.begin(), keep.begin() + chosen, 0);
  child = with_chosen(with_only(std::move(child), keep), place);
  visit(child, inherited(node.core, node.multipliers, child));  // node may move
}

}  // namespace delos
