// A search for better values of a scene's variables, while somebody watches and steers.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "delos/optimize/study.h"
#include "session/job.h"
#include "session/search_record.h"

namespace delos::session {

/// How to search. The study's own plan holds where it exists already.
struct SearchWish {
  StudyPlan plan;
  double seconds =
      0;            ///< pause so long after it was begun, resumed or edited; 0: never
  int threads = 0;  ///< 0: one a core
  std::vector<std::string> locked;  ///< variables that shall not change
};

/// A study (delos/optimize/study.h) that is searched: paused and resumed it gives the
/// same as if it hadn't been, edits of the design and locks are its acts, and the
/// command line's `delos study` goes on with its file.
class SearchRun final : public Job {
 public:
  /// Begin a study of a scene, or go on with one that exists.
  /// @param folder where the scene's relative paths start
  /// @param kept   the file stays; else it goes with this
  /// @throws std::exception the study can't be made, or isn't one
  SearchRun(std::filesystem::path file, bool kept, const Scene& scene,
            const std::filesystem::path& folder, SearchWish wish,
            PluginRegistry& plugins);
  ~SearchRun() override;

  /// A hand has changed the design: the running round ends, and once the hand has
  /// rested the next one begins from the design as it is then.
  void edited(Scene scene);
  /// Lock a variable, or all of a device by "devices.NAME", or let it go again.
  /// @throws std::invalid_argument there is none, or nothing would be left to change
  void lock(const std::string& pattern, bool locked);
  /// Search on from the best, so many evaluations. @pre it has ended
  void extend(int evaluations);

  /// The scene that the study began with, or stands at.
  [[nodiscard]] Scene scene() const;
  /// The best values so far, and of which round they are.
  struct Best {
    int round = 0;
    VariableValues values;
  };
  [[nodiscard]] std::optional<Best> best() const;
  /// @throws std::invalid_argument it isn't kept
  [[nodiscard]] VariableValues incumbent(std::size_t number) const;

  /// {kind: search, phase, message, study, objective: {name, unit}, locked, of, best,
  ///  seconds, result: {initial, best, stop, algorithm, constraints, messages} on all
  ///  samples, …SearchRecord::json()}
  [[nodiscard]] Json json(const Heard& heard) const override;

 private:
  bool advance() override;
  void recall(const Study& study);
  void follow_hand(Study& study);
  void hear(const StudyEvaluation& evaluation, const Study& study);
  void take(const OptimizeResult& result);

  using Clock = std::chrono::steady_clock;

  const std::filesystem::path file_;
  const bool kept_;
  const SearchWish wish_;
  PluginRegistry& plugins_;
  // What follows is told: under the mutex.
  SearchRecord record_;
  std::optional<Scene> edited_;  ///< by a hand; not searched yet
  Clock::time_point edited_at_;
  std::vector<std::string> locked_;
  Json objective_;
  double sign_ = 1;
  std::size_t of_ = 0;
  Clock::duration worked_{};  ///< before the last resume()
  std::optional<Clock::time_point> since_;
  Json result_;
  std::optional<Best>
      judged_;  ///< the best of all on all samples, once it stands still
};

}  // namespace delos::session
