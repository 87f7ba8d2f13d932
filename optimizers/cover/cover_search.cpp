#include "cover/cover_search.h"

#include <algorithm>
#include <utility>

namespace delos {
namespace {

/// Steps for which what was selected, and what was deselected, stays so.
constexpr int kStaysIn = 1, kStaysOut = 3;

}  // namespace

using Exchange = CoverSelection::Exchange;

CoverSearch::CoverSearch(const CoverCore& core, CoverSelection begin,
                         std::uint64_t seed)
    : core_(core), selection_(std::move(begin)), random_(seed) {}

/// The candidate of most gain that sees the sample and is affordable; −1: none.
int CoverSearch::most_gain(int sample, double limit) const {
  int most = -1;
  double gain = -CoverSelection::kNone;
  for (const int j : core_.seers[sample]) {
    if (selection_.has(j) || selection_.moved(j) >= moves_ - kStaysOut) continue;
    const int other = selection_.member(j);
    const double saved = other >= 0 ? core_.cost[other] : 0;
    if (!(selection_.cost() - saved + core_.cost[j] < limit)) continue;
    const double own = selection_.value(j);
    if (own > gain || (own == gain && selection_.moved(j) < selection_.moved(most))) {
      most = j;
      gain = own;
    }
  }
  return most;
}

/// The exchange of most value for a candidate that sees the sample.
Exchange CoverSearch::best_exchange(int sample) {
  selection_.open_losses(moves_ - kStaysIn);
  const auto moved = [&](const Exchange& e) {
    return selection_.moved(e.in) + selection_.moved(e.out);
  };
  Exchange best;
  for (const int j : core_.seers[sample]) {
    if (selection_.has(j) || selection_.moved(j) >= moves_ - kStaysOut) continue;
    // No loss is negative, so that no exchange is worth more than the gain.
    if (selection_.gain(j) < best.value) continue;
    const Exchange own = selection_.exchange_for(j, best.value);
    if (own.out >= 0 && (own.value > best.value ||
                         (own.value == best.value && moved(own) < moved(best))))
      best = own;
  }
  return best;
}

void CoverSearch::step(double limit) {
  ++moves_;
  const auto& missed = selection_.missed();
  const int sample = missed[random_() % missed.size()];
  looked_ += static_cast<std::int64_t>(core_.seers[sample].size());
  Exchange exchange;
  exchange.in = most_gain(sample, limit);
  if (exchange.in >= 0)
    exchange.value = selection_.value(exchange.in);
  else
    exchange = best_exchange(sample);
  if (exchange.out >= 0 && exchange.out != selection_.member(exchange.in))
    selection_.take(exchange.out, moves_);
  if (exchange.in >= 0) selection_.put(exchange.in, moves_);
  if (!(exchange.value > 0)) selection_.weigh_missed();
}

void CoverSearch::run(std::int64_t work, double limit, double enough) {
  const std::int64_t end = looked_ + selection_.work() + work;
  while (looked_ + selection_.work() < end && selection_.best_cost() > enough) {
    limit = std::min(limit, selection_.best_cost());
    while (!selection_.selected().empty() && !(selection_.cost() < limit))
      selection_.take(selection_.least_loss(), ++moves_);
    if (!selection_.missed().empty()) step(limit);
    if (!selection_.missed().empty()) continue;
    selection_.note_cover();
    ++looked_;
  }
}

}  // namespace delos
