#include "session/term_values.h"

#include "delos/optimize/problem.h"
#include "session/search_answer.h"

namespace delos::session {

Json term_values(const Scene& scene, const std::vector<VariableValues>& designs,
                 std::size_t samples, int threads, const std::atomic<bool>* stop,
                 PluginRegistry& plugins) {
  const ProblemOptions options{.samples = samples, .threads = threads};
  std::vector<std::vector<double>> points;
  for (const VariableValues& values : designs)
    points.push_back(
        ::delos::Design(with_values(scene, values, plugins), plugins).start());
  // Where the objective says no guess, it is that of the scene as it is now.
  const double guess = Problem(scene, plugins, options).guess();
  Json terms = Json::array(), all(designs.size(), Json::array());
  const std::vector<ObjectiveTerm> given = scene.objective.terms.empty()
                                               ? std::vector<ObjectiveTerm>(1)
                                               : scene.objective.terms;
  for (const ObjectiveTerm& term : given) {
    Scene alone = scene;
    alone.objective.terms = {term};
    alone.objective.terms.front().weight = 1;
    alone.objective.guess = guess;
    terms.push_back({{"name", objective_text(alone)}, {"unit", objective_unit(alone)}});
    Problem problem(alone, plugins, options);
    for (std::size_t i = 0; i < points.size() && !(stop && *stop); ++i)
      all[i].push_back(
          number(objective_shown(alone, problem.score(points[i]).objective)));
  }
  return {{"terms", terms}, {"values", all}};
}

}  // namespace delos::session
