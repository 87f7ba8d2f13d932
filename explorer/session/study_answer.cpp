#include "session/study_answer.h"

#include <stdexcept>

#include "delos/scene/io.h"
#include "delos/scene/number.h"
#include "delos/text/units.h"

namespace delos::session {

Json study_json(const StudySummary& s) {
  Json rounds = Json::array(), acts = Json::array();
  for (const StudyRound& r : s.rounds)
    rounds.push_back({{"round", r.number},
                      {"ended", r.ended},
                      {"evaluations", r.evaluations},
                      {"initial", r.ended ? number(r.initial) : Json()},
                      {"best", r.ended ? number(r.best) : Json()}});
  for (const StudyAct& a : s.acts)
    acts.push_back({{"act", a.number},
                    {"after_round", a.after_round},
                    {"verb", a.verb},
                    {"argument", a.argument}});
  return {{"scene", s.scene},
          {"algorithm", s.plan.algorithm},
          {"seed", s.plan.seed},
          {"locked", s.locked},
          {"rounds", rounds},
          {"acts", acts},
          {"waiting_acts", s.waiting.size()}};
}

std::string design_of(const std::filesystem::path& file, const Study& study,
                      PluginRegistry& plugins) {
  Diagnostics findings;
  auto scene = load_scene(file, {}, plugins, findings);
  if (!scene) throw std::invalid_argument(to_string(findings.front()));
  std::string text;
  for (const VariableEntry& v : study.scene().variables) {
    const auto found = find_number(*scene, v.path, plugins);
    if (const auto* problem = std::get_if<std::string>(&found))
      throw std::invalid_argument(file.string() + ": " + v.path + ": " + *problem);
    text += (text.empty() ? "" : "\n") + v.path + '=' +
            shortest(*std::get<SceneNumber>(found).value);
  }
  return text;
}

}  // namespace delos::session
