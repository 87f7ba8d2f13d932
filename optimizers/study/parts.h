// Studies that each have a part of a search's starts.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "delos/optimize/study.h"
#include "study/ledger.h"

namespace delos {

/// Whether they are all parts of one search, each once.
/// @param files of the parts, for messages; one or more
/// @throws std::invalid_argument as Study::merge()
void check_parts(const std::vector<std::filesystem::path>& files,
                 const std::vector<Study>& parts);

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
