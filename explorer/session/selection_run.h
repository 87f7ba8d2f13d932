// A choice of candidates, while somebody watches.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <vector>

#include "delos/document/override.h"
#include "delos/optimize/select.h"
#include "session/job.h"

namespace delos::session {

/// A selection of a scene by count or budget, which goes on from its file when it is
/// resumed, or by cover, which begins anew.
class SelectionRun final : public Job {
 public:
  /// @param options their study, seconds, gap, samples, seed and threads are used
  /// @param kept    the study's file stays; else it goes with this
  SelectionRun(Scene scene, SelectOptions options, bool kept, PluginRegistry& plugins);
  ~SelectionRun() override;

  /// The changes that leave of the candidates what was chosen.
  /// @throws std::invalid_argument nothing is chosen yet
  [[nodiscard]] std::vector<Override> changes() const;

  /// {kind: selection, phase, message, study, unit, ready,
  ///  curve: [{seconds, value, bound, nodes}], result: select_json() or cover_json()}
  [[nodiscard]] Json json(const Heard& heard) const override;

 private:
  bool advance() override;
  void hear(const SelectProgress& at);
  void take(Json result, const CandidateScene& all,
            const std::vector<std::size_t>& chosen);

  /// How a bound closes in.
  struct Point {
    double seconds = 0, value = 0, bound = 0;
    std::size_t nodes = 0;
  };
  static constexpr std::size_t kMostPoints = 500;

  const Scene scene_;
  SelectOptions options_;
  const bool kept_;
  PluginRegistry& plugins_;
  const std::chrono::steady_clock::time_point begun_;
  // What follows is told: under the mutex.
  std::vector<Point> curve_;
  double ready_ = 1;
  Json result_;
  std::string unit_;
  std::optional<Scene> chosen_;
};

}  // namespace delos::session
