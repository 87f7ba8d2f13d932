// The evaluations of one round, in the study's database.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <vector>

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

/// A study's ledger that also knows what its parts have evaluated, and takes over what
/// is asked for.
class PartsLedger final : public EvaluationLedger {
 public:
  /// @param whole kept by reference
  explicit PartsLedger(DatabaseLedger& whole) : whole_(whole) {}
  /// @param part kept by reference
  void add(const Database& part, int round);

  bool recall(const EvaluationKey& key, std::span<const double> x,
              EvaluationRecord& record) override;
  void remember(const EvaluationKey& key, std::span<const double> x,
                const EvaluationRecord& record) override;
  void each(const Told& told) override;

 private:
  DatabaseLedger& whole_;
  std::vector<std::unique_ptr<DatabaseLedger>> parts_;
};

}  // namespace delos
