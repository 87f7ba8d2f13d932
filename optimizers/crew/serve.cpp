// What the processes do that don't ask.
#include "crew/crew_job.h"
#include "crew/crew_search.h"
#include "crew/crew_simulation.h"

namespace delos {

void serve(Crew& crew, PluginRegistry& plugins, int threads) {
  for (;;) {
    const std::string asked = crew.exchange({}).front();
    if (asked.empty()) return;
    ByteReader job(asked);
    const auto kind = static_cast<CrewJob>(job.whole());
    try {
      together(crew, [&] {
        if (kind == CrewJob::search)
          serve_search(job, crew, plugins, threads);
        else
          serve_simulation(job, crew, plugins, threads);
      });
    } catch (const std::invalid_argument&) {
      // Rank 0 is refused by the same sentence.
    }
  }
}

void dismiss(Crew& crew) { (void)crew.exchange({}); }

}  // namespace delos
