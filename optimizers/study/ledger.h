// The evaluations of one round, in the study's database.
#pragma once

#include <functional>
#include <mutex>

#include "delos/optimize/optimize.h"
#include "study/database.h"

namespace delos {

class DatabaseLedger final : public EvaluationLedger {
 public:
  /// @param watch called before each new evaluation: whether somebody acted
  DatabaseLedger(const Database& database, int round, std::function<void()> watch);

  bool recall(const EvaluationKey& key, std::span<const double> x,
              EvaluationRecord& record) override;
  void remember(const EvaluationKey& key, std::span<const double> x,
                const EvaluationRecord& record) override;
  void each(const Told& told) override;

 private:
  const Database& database_;
  int round_;
  std::function<void()> watch_;
  std::mutex mutex_;
};

}  // namespace delos
