#include "crew/crew_ledger.h"

#include <algorithm>
#include <stdexcept>

namespace delos {

void CrewLedger::begin() {
  if (kept_)
    kept_->each([&](const EvaluationKey& key, std::span<const double> x,
                    const EvaluationRecord& record) { tell(key, x, record); });
  meet();
}

void CrewLedger::meet(const std::string& problem) {
  look();
  ByteWriter said;
  said.put(problem);
  said.put(std::uint64_t{stop_});
  {
    const std::lock_guard lock(mutex_);
    said.put(said_.bytes());
    said_.clear();
  }
  std::string first;
  const std::vector<std::string> all = crew_.exchange(said.bytes());
  for (std::size_t rank = 0; rank < all.size(); ++rank) {
    ByteReader of(all[rank]);
    const std::string failed = of.text();
    if (first.empty() && !failed.empty())
      first = "process " + std::to_string(rank) + ": " + failed;
    if (of.whole() != 0) stop_ = true;
    if (rank != crew_.rank()) hear(of.text());
  }
  if (!first.empty()) throw std::runtime_error(first);
}

void CrewLedger::look() {
  if (cancel_ && cancel_->load()) stop_ = true;
}

bool CrewLedger::recall(const EvaluationKey& key, std::span<const double> x,
                        EvaluationRecord& record) {
  look();
  if (kept_ && kept_->recall(key, x, record)) return true;
  Known found;
  {
    const std::lock_guard lock(mutex_);
    const auto known = known_.find({key.start, key.number});
    if (known == known_.end()) return false;
    found = std::move(known->second);  // a search asks for each once
    known_.erase(known);
  }
  if (!std::equal(found.x.begin(), found.x.end(), x.begin(), x.end()))
    throw std::runtime_error(
        "another process went another way: evaluation " + std::to_string(key.number) +
        " of start " + std::to_string(key.start) +
        " is elsewhere; run the same version on machines of one kind");
  record = std::move(found.record);
  if (kept_) kept_->remember(key, x, record);
  return true;
}

void CrewLedger::remember(const EvaluationKey& key, std::span<const double> x,
                          const EvaluationRecord& record) {
  if (kept_) kept_->remember(key, x, record);
  tell(key, x, record);
}

void CrewLedger::tell(const EvaluationKey& key, std::span<const double> x,
                      const EvaluationRecord& record) {
  const std::lock_guard lock(mutex_);
  said_.put(static_cast<std::uint64_t>(key.start));
  said_.put(static_cast<std::uint64_t>(key.number));
  said_.put(x);
  said_.put(record.width);
  said_.put(record.score.objective);
  said_.put(std::span<const double>(record.score.slacks));
  said_.put(std::span<const double>(record.slope));
  said_.put(std::span<const double>(record.slopes));
}

void CrewLedger::hear(std::string_view bytes) {
  ByteReader of(bytes);
  const std::lock_guard lock(mutex_);
  while (!of.at_end()) {
    const auto start = static_cast<int>(of.whole());
    const auto number = static_cast<int>(of.whole());
    Known& known = known_[{start, number}];
    known.x = of.numbers();
    known.record.width = of.real();
    known.record.score.objective = of.real();
    known.record.score.slacks = of.numbers();
    known.record.slope = of.numbers();
    known.record.slopes = of.numbers();
  }
}

}  // namespace delos
