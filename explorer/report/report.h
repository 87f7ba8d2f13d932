// A scene or a study as a report tells it: values with one JSON form, and pictures.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "delos/field/evaluate.h"
#include "delos/optimize/study.h"
#include "session/json.h"
#include "session/loaded_scene.h"

namespace delos::report {

/// A picture for paper, and for readers without scripts.
struct Still {
  std::string caption;
  std::string says;  ///< what is to be seen, in a sentence
  std::string png;   ///< the bytes of a file
};

struct Report {
  std::string title;
  std::string headline;  ///< the answer in a few sentences
  session::Json data;    ///< what the page shows
  std::vector<Still> stills;
};

/// How a report is made.
struct Making {
  std::string file;     ///< as the user named it
  std::string version;  ///< of this program
  FieldOptions options;
  std::function<void()> between;  ///< called between its parts; may throw to stop
};

/// A scene as it stands:
///
///   {kind: "scene", headline, file, versions: [{part, version}], text: the scene,
///    design: {description: description(), around: surroundings(), field: packed()},
///    sees: {device: part of the samples outside solids}, worth: worth_json(),
///    blind: blind_json(), lattice: lattice_json(), installation: installation_json()}
///
/// A packed field is in base64; of one with more than kMostDrawn samples a coarser one
/// is drawn, with the whole one's summary.
/// @throws std::invalid_argument as make_steady_solver(), and what `between` throws
[[nodiscard]] Report scene_report(const session::LoadedScene& loaded,
                                  const Making& making, PluginRegistry& plugins);
inline constexpr std::size_t kMostDrawn = 200'000;

/// What is asked of a study besides.
struct StudyWish {
  double loss = 0.05;   ///< for which tolerances are told
  bool answers = true;  ///< tell tolerances and failures, which take longest
  std::vector<session::Json> tradeoffs;  ///< as tradeoff_json()
  std::function<void(std::size_t done, std::size_t of)> progress;  ///< of the answers
};

/// A search, as far as it is:
///
///   {kind: "study", headline, file, versions, text, commands, before, after: designs
///   as
///    above, difference: packed(),
///    objective: {name, unit, before, after, maximize}, constraints: [{name, words,
///    satisfied, slack, unit}], variables: [{path, unit, before, after, lower, upper,
///    locked}], search: SearchRecord::json() with {objective: {name, unit}, best},
///    study: study_json(), waiting: [act], answers: answers_json() or null, consensus:
///    consensus_json() or null, tradeoffs, installation}
///
/// Both designs are judged on the samples, by the metric and under the fusion of the
/// last.
/// @throws std::invalid_argument, std::runtime_error as Study, and as above
[[nodiscard]] Report study_report(const Study& study, const Making& making,
                                  const StudyWish& wish, PluginRegistry& plugins);

/// The report as one HTML page that asks nothing of a network: the explorer's page,
/// with its data frozen in.
[[nodiscard]] std::string page_of(const Report& report);

}  // namespace delos::report
