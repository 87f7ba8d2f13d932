#include "study/ledger.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace delos {

DatabaseLedger::DatabaseLedger(const Database& database, int round,
                               std::function<void()> watch)
    : database_(database), round_(round), watch_(std::move(watch)) {}

bool DatabaseLedger::recall(const EvaluationKey& key, std::span<const double> x,
                            EvaluationRecord& record) {
  const std::lock_guard lock(mutex_);
  Statement s = database_.prepare(
      "SELECT x, width, objective, slacks, slope, slopes FROM evaluations WHERE "
      "round = ? AND start = ? AND number = ?");
  s.bind(1, std::int64_t{round_})
      .bind(2, std::int64_t{key.start})
      .bind(3, std::int64_t{key.number});
  if (!s.step()) {
    // Here and not before: what is remembered counts, whoever acted since.
    watch_();
    return false;
  }
  const std::vector<double> known = s.numbers(0);
  if (!std::equal(known.begin(), known.end(), x.begin(), x.end()))
    throw std::runtime_error(
        "the study was made by another version or on another machine: its evaluation " +
        std::to_string(key.number) + " of start " + std::to_string(key.start) +
        " is elsewhere; begin a new study from its best design");
  EvaluationRecord kept{
      s.real(1), {s.real(2), s.numbers(3)}, s.numbers(4), s.numbers(5)};
  if (kept.score.slacks.size() != record.score.slacks.size() ||
      kept.slope.size() != record.slope.size() ||
      kept.slopes.size() != record.slopes.size())
    throw std::runtime_error(
        "the study is damaged, or was made by another version: its evaluation " +
        std::to_string(key.number) + " of start " + std::to_string(key.start) +
        " has lists of other lengths; begin a new study from its best design");
  record = std::move(kept);
  return true;
}

void DatabaseLedger::remember(const EvaluationKey& key, std::span<const double> x,
                              const EvaluationRecord& record) {
  const std::lock_guard lock(mutex_);
  database_.prepare("INSERT INTO evaluations VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)")
      .bind(1, std::int64_t{round_})
      .bind(2, std::int64_t{key.start})
      .bind(3, std::int64_t{key.number})
      .bind(4, x)
      .bind(5, record.width)
      .bind(6, record.score.objective)
      .bind(7, std::span<const double>(record.score.slacks))
      .bind(8, std::span<const double>(record.slope))
      .bind(9, std::span<const double>(record.slopes))
      .step();
}

void DatabaseLedger::each(const Told& told) {
  const std::lock_guard lock(mutex_);
  Statement s = database_.prepare(
      "SELECT start, number, x, width, objective, slacks, slope, slopes FROM "
      "evaluations WHERE round = ? ORDER BY start, number");
  s.bind(1, std::int64_t{round_});
  while (s.step())
    told({static_cast<int>(s.integer(0)), static_cast<int>(s.integer(1))}, s.numbers(2),
         {s.real(3), {s.real(4), s.numbers(5)}, s.numbers(6), s.numbers(7)});
}

}  // namespace delos
