// A ledger that says what is evaluated, to somebody who watches the search.
#pragma once

#include <mutex>

#include "delos/optimize/study.h"

namespace delos {

class TellingLedger final : public EvaluationLedger {
 public:
  /// What is passed is kept by reference.
  TellingLedger(EvaluationLedger& kept, int round, const Study::Told& told)
      : kept_(kept), round_(round), told_(told) {}

  bool recall(const EvaluationKey& key, std::span<const double> x,
              EvaluationRecord& record) override {
    if (!kept_.recall(key, x, record)) return false;
    tell(key, x, record);
    return true;
  }
  void remember(const EvaluationKey& key, std::span<const double> x,
                const EvaluationRecord& record) override {
    kept_.remember(key, x, record);
    tell(key, x, record);
  }
  void each(const EvaluationLedger::Told& told) override { kept_.each(told); }

 private:
  void tell(const EvaluationKey& key, std::span<const double> x,
            const EvaluationRecord& record) {
    const std::lock_guard lock(mutex_);
    told_({round_,
           key,
           record.width,
           record.score.objective,
           record.score.feasible(),
           {x.begin(), x.end()}});
  }

  EvaluationLedger& kept_;
  int round_;
  const Study::Told& told_;
  std::mutex mutex_;
};

}  // namespace delos
