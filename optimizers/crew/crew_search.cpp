#include "crew/crew_search.h"

#include <fstream>
#include <iterator>
#include <set>
#include <stdexcept>

#include "crew/bytes.h"
#include "crew/crew_ledger.h"
#include "delos/optimize/crew.h"
#include "delos/scene/io.h"

namespace delos {
namespace {

/// FNV-1a, 64 bits.
std::uint64_t hash_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (std::istreambuf_iterator<char> at(in), end; at != end; ++at)
    hash = (hash ^ static_cast<unsigned char>(*at)) * 0x100000001b3u;
  return hash;
}

/// The plugins that a scene needs, as this process has them.
std::string plugins_text(const Scene& scene, PluginRegistry& plugins) {
  std::set<std::string> types;
  for (const DeviceEntry& device : scene.devices) types.insert(device.type);
  std::string text;
  for (const std::string& type : types) {
    const PluginLoad& load = plugins.find(type);
    text += type + ' ' + (load.info ? load.info->version : "missing") + ' ' +
            std::to_string(hash_of(load.path)) + '\n';
  }
  return text;
}

/// @throws std::runtime_error a process has other plugins than rank 0
void compare_plugins(Crew& crew, const std::string& mine) {
  ByteWriter said;
  said.put(crew.host());
  said.put(mine);
  std::string first;
  const std::vector<std::string> all = crew.exchange(said.bytes());
  for (std::size_t rank = 0; rank < all.size(); ++rank) {
    ByteReader of(all[rank]);
    const std::string host = of.text(), theirs = of.text();
    if (rank == 0) first = theirs;
    if (theirs == first) continue;
    std::size_t at = 0;
    while (at < theirs.size() && at < first.size() && theirs[at] == first[at]) ++at;
    const std::size_t line = first.rfind('\n', at > 0 ? at - 1 : 0);
    const std::string from = first.substr(line == std::string::npos ? 0 : line + 1);
    throw std::runtime_error("process " + std::to_string(rank) + " on " + host +
                             " has another plugin '" + from.substr(0, from.find(' ')) +
                             "' than process 0; install the same Delos on all "
                             "machines, and the same DELOS_PLUGIN_PATH");
  }
}

std::string job_of(const Scene& scene, const OptimizeOptions& options) {
  ByteWriter job;
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
  compare_plugins(crew, plugins_text(scene, plugins));
  CrewLedger ledger(crew, options.ledger, options.cancel);
  ledger.begin();
  options.ledger = &ledger;
  options.cancel = &ledger.stop();
  options.crew = nullptr;
  options.parts = {crew.rank(), crew.size()};
  options.meet = [&](const std::string& problem) { ledger.meet(problem); };
  return optimize(scene, plugins, options);
}

/// What isn't refused by all processes alike is the end of their work together.
template <class Step>
auto together(Crew& crew, Step&& step) {
  try {
    return step();
  } catch (const std::invalid_argument&) {
    throw;
  } catch (...) {
    crew.abandon();
    throw;
  }
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

void serve(Crew& crew, PluginRegistry& plugins, int threads) {
  for (;;) {
    const std::string asked = crew.exchange({}).front();
    if (asked.empty()) return;
    ByteReader job(asked);
    const std::string text = job.text();
    OptimizeOptions options;
    options.algorithm = job.text();
    options.evaluations = static_cast<int>(job.whole());
    options.starts = static_cast<int>(job.whole());
    options.seed = job.whole();
    options.samples = job.whole();
    options.threads = threads;
    try {
      together(crew, [&] {
        Diagnostics findings;
        const auto scene = parse_scene(text, "scene.yaml", {}, plugins, findings);
        if (scene)
          (void)my_part(*scene, plugins, options, crew);
        else
          compare_plugins(crew, to_string(findings.front()));
      });
    } catch (const std::invalid_argument&) {
      // Rank 0 is refused by the same sentence.
    }
  }
}

void dismiss(Crew& crew) { (void)crew.exchange({}); }

}  // namespace delos
