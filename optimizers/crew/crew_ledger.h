// The evaluations of a search that several processes make.
#pragma once

#include <atomic>
#include <map>
#include <mutex>
#include <utility>

#include "crew/bytes.h"
#include "delos/optimize/crew.h"
#include "delos/optimize/optimize.h"

namespace delos {

/// What this process has evaluated since they last met goes to the others when they
/// meet; from then on all recall it.
class CrewLedger final : public EvaluationLedger {
 public:
  /// @param kept of rank 0: what outlasts the search, such as a study's; or null
  /// @param cancel of this process, or null
  CrewLedger(Crew& crew, EvaluationLedger* kept, const std::atomic<bool>* cancel)
      : crew_(crew), kept_(kept), cancel_(cancel) {}

  /// Tell the others what is kept of an earlier run. All call it, before the search.
  void begin();
  /// @param problem what this process failed by; empty: it didn't
  /// @throws std::runtime_error the first of those by rank, of all of them
  void meet(const std::string& problem = {});
  /// Whether any of them was asked to stop, as they knew when they met or as this one
  /// knows.
  [[nodiscard]] const std::atomic<bool>& stop() const { return stop_; }

  bool recall(const EvaluationKey& key, std::span<const double> x,
              EvaluationRecord& record) override;
  void remember(const EvaluationKey& key, std::span<const double> x,
                const EvaluationRecord& record) override;

 private:
  struct Known {
    std::vector<double> x;
    EvaluationRecord record;
  };
  void tell(const EvaluationKey& key, std::span<const double> x,
            const EvaluationRecord& record);
  void hear(std::string_view bytes);
  void look();

  Crew& crew_;
  EvaluationLedger* kept_;
  const std::atomic<bool>* cancel_;
  std::atomic<bool> stop_ = false;
  std::mutex mutex_;
  ByteWriter said_;
  std::map<std::pair<int, int>, Known> known_;
};

}  // namespace delos
