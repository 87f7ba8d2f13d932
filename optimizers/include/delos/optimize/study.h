// A search that is kept in a file: interrupted, resumed, steered.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "delos/optimize/optimize.h"

namespace delos {

/// What a study is begun with.
struct StudyPlan {
  std::string algorithm = "auto";
  int evaluations = 0;
  int starts = 0;
  std::uint64_t seed = 1;
  std::size_t samples = 1500;
  std::string version;   ///< of the program that began it; "" where it isn't known
  SearchPart part = {};  ///< of the starts, where other studies have the others
};

/// Something a person did to a study.
struct StudyAct {
  int number = 0;
  int after_round = 0;   ///< it holds from the next round on
  std::string verb;      ///< see Study::act()
  std::string argument;  ///< as written
};

/// One search within a study: acts end a round and begin the next.
struct StudyRound {
  int number = 0;
  bool ended = false;
  std::size_t evaluations = 0;  ///< kept in the file
  /// Objective on all samples, of an ended round; NaN where it couldn't be searched.
  double initial = 0, best = 0;
};

/// An evaluation of a study, as it is remembered.
struct StudyEvaluation {
  int round = 0;
  EvaluationKey key;
  double width = 0;      ///< softness of edges; 0: hard
  double objective = 0;  ///< on the samples of the search
  bool feasible = false;
  std::vector<double> x;  ///< in the unit cube of the variables that weren't locked
};

/// Everything that a study holds but its evaluations.
struct StudySummary {
  std::string scene;  ///< its name
  StudyPlan plan;
  std::vector<std::string> locked;  ///< variables that don't change
  std::vector<StudyRound> rounds;
  std::vector<StudyAct> acts;
  std::vector<StudyAct> waiting;  ///< acts since the last round began
};

/// A file that holds scenes, every evaluation before it is used, and every act. One
/// process searches at a time; others may look and act meanwhile.
class Study {
 public:
  /// Begin one. @throws std::runtime_error the file exists, or can't be made
  static Study create(const std::filesystem::path& file, const Scene& scene,
                      const std::filesystem::path& folder, const StudyPlan& plan,
                      PluginRegistry& plugins);
  /// Begin one from studies that each have a part of its starts; run() recalls what
  /// they have evaluated, and gives the same as if it had searched alone.
  /// @param parts one or more
  /// @throws std::runtime_error as create(), or as opening one of them
  /// @throws std::invalid_argument one of them is steered, is about something else,
  ///         of another version or there twice, or one is missing: by name
  static Study merge(const std::filesystem::path& file,
                     const std::vector<std::filesystem::path>& parts,
                     PluginRegistry& plugins);
  /// One that can't be written, or whose folder can't, can still be looked at.
  /// @throws std::runtime_error there is none, or it isn't one
  /// @throws std::runtime_error its file is damaged or cut short
  Study(const std::filesystem::path& file, PluginRegistry& plugins);
  Study(Study&&) noexcept;
  ~Study();

  [[nodiscard]] StudySummary summary() const;

  /// The scene of a round with its best values; of a round that hasn't ended, with
  /// those it began with. 0: the scene as it was given. −1: the last round.
  /// @throws std::invalid_argument there is no such round
  [[nodiscard]] Scene scene(int round = -1) const;

  /// The scene that a round began with, without the variables that were locked.
  /// @param round −1: the last one
  /// @throws std::invalid_argument there is no such round
  [[nodiscard]] Scene searched_scene(int round = -1) const;

  /// All evaluations of a round, start after start, in the order of each.
  /// @throws std::runtime_error one is no design of the round: the file is damaged
  [[nodiscard]] std::vector<StudyEvaluation> evaluations(int round) const;

  /// Journal an act, for a search that runs or for the next one.
  ///
  ///   lock PATTERN · unlock PATTERN     variables, by path; * is any part of a name
  ///   set PATH=VALUE                    anything of the scene, as --set
  ///   keep {spacing: 1, devices: "*"}   one more constraint, as scenes write it
  ///   drop NAME                         one constraint less
  ///   forbid REGION                     a region of the scene that no device may
  ///                                     enter, a body as scenes write it, or a box by
  ///                                     two corners X,Y,Z X,Y,Z
  ///   inject VARIABLE=VALUE …           a design, SI, a line each: the search goes on
  ///                                     from it
  ///   extend N                          N more evaluations from the best so far
  ///   undo                              the last act that isn't undone, of any round;
  ///                                     variables that it didn't move stay as found
  ///
  /// @throws std::invalid_argument what is wrong with it; nothing is journalled then
  void act(const std::string& verb, const std::string& argument);
  /// Several at once: no round begins between them.
  /// @param acts verb and argument of each; their numbers are the study's
  /// @throws std::invalid_argument what is wrong with one; none is journalled then
  void act(const std::vector<StudyAct>& acts);

  /// Ask a search that runs to stop, with its best so far; resumed, it goes on as if it
  /// hadn't been.
  void pause();

  /// Where relative paths of the scene start.
  [[nodiscard]] std::filesystem::path folder() const;

  /// Search until the rounds have come to their end; continues what was interrupted,
  /// with the same result as if it hadn't been. Acts of others end a round within a few
  /// evaluations.
  /// @param options its cancel, progress and threads are used
  /// @param told called with each evaluation, also with those that are remembered; from
  ///        any thread, but never from two at once
  /// @throws std::runtime_error another process is searching; or the disk is full, …
  /// @throws std::runtime_error somebody deleted the file meanwhile
  /// @throws std::runtime_error what is remembered isn't of this search
  /// @throws std::invalid_argument as optimize()
  using Told = std::function<void(const StudyEvaluation&)>;
  OptimizeResult run(const OptimizeOptions& options, const Told& told = {});

  /// Everything as text, for people and to compare: the same study gives the same
  /// bytes.
  [[nodiscard]] std::string dump() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace delos
