#include "crew/crew_search.h"

#include "crew/crew_job.h"
#include "crew/crew_ledger.h"
#include "delos/scene/io.h"

namespace delos {
namespace {

std::string job_of(const Scene& scene, const OptimizeOptions& options) {
  ByteWriter job;
  job.put(static_cast<std::uint64_t>(CrewJob::search));
  job.put(write_scene(with_absolute_files(scene, std::filesystem::current_path())));
  job.put(options.algorithm);
  job.put(static_cast<std::uint64_t>(options.evaluations));
  job.put(static_cast<std::uint64_t>(options.starts));
  job.put(options.seed);
  job.put(std::uint64_t{options.samples});
  return job.bytes();
}

/// The part of a search that is this process's, and all of it in the end.
OptimizeResult my_part(const Scene& scene, PluginRegistry& plugins,
                       OptimizeOptions options, Crew& crew) {
  compare_plugins(crew, scene, plugins);
  CrewLedger ledger(crew, options.ledger, options.cancel);
  ledger.begin();
  options.ledger = &ledger;
  options.cancel = &ledger.stop();
  options.crew = nullptr;
  options.parts = {crew.rank(), crew.size()};
  options.meet = [&](const std::string& problem) { ledger.meet(problem); };
  return optimize(scene, plugins, options);
}

}  // namespace

OptimizeResult search_with_crew(const Scene& scene, PluginRegistry& plugins,
                                const OptimizeOptions& options) {
  Crew& crew = *options.crew;
  return together(crew, [&] {
    (void)crew.exchange(job_of(scene, options));
    return my_part(scene, plugins, options, crew);
  });
}

void serve_search(ByteReader& job, Crew& crew, PluginRegistry& plugins, int threads) {
  const std::string text = job.text();
  OptimizeOptions options;
  options.algorithm = job.text();
  options.evaluations = static_cast<int>(job.whole());
  options.starts = static_cast<int>(job.whole());
  options.seed = job.whole();
  options.samples = job.whole();
  options.threads = threads;
  Diagnostics findings;
  const auto scene = parse_scene(text, "scene.yaml", {}, plugins, findings);
  if (scene)
    (void)my_part(*scene, plugins, options, crew);
  else
    compare_plugins(crew, to_string(findings.front()));
}

}  // namespace delos
