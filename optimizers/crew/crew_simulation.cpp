#include "crew/crew_simulation.h"

#include "crew/crew_job.h"
#include "delos/scene/definition.h"
#include "delos/scene/io.h"

namespace delos {
namespace {

std::string job_of(const Scene& scene, const TargetPose& about,
                   const SimulationOptions& options) {
  ByteWriter job;
  job.put(static_cast<std::uint64_t>(CrewJob::simulation));
  job.put(write_scene(with_absolute_files(scene, std::filesystem::current_path())));
  job.put(std::span<const double>(about.R.data(), 9));
  job.put(std::span<const double>(about.p.data(), 3));
  job.put(static_cast<std::uint64_t>(options.runs));
  job.put(options.seed);
  job.put(static_cast<std::uint64_t>(options.filter));
  job.put(options.seconds);
  job.put(options.resume);
  const GivenPath path = options.path.value_or(GivenPath{});
  job.put(std::span<const double>(path.t));
  for (const Eigen::Vector3d& p : path.p) job.put(std::span<const double>(p.data(), 3));
  return job.bytes();
}

Eigen::Vector3d point_of(ByteReader& job) {
  const std::vector<double> p = job.numbers();
  return Eigen::Vector3d::Map(p.data());
}

Simulation my_part(const System& system, const TargetPose& about,
                   SimulationOptions options, Crew& crew) {
  options.parts = {crew.rank(), crew.size(),
                   [&crew](const std::string& said) { return crew.exchange(said); }};
  return simulate(system, about, options);
}

}  // namespace

Simulation simulate_with_crew(const Scene& scene, const TargetPose& about,
                              PluginRegistry& plugins, const SimulationOptions& options,
                              Crew& crew) {
  return together(crew, [&] {
    const System system = build_system(scene, plugins);
    (void)crew.exchange(job_of(scene, about, options));
    compare_plugins(crew, scene, plugins);
    return my_part(system, about, options, crew);
  });
}

void serve_simulation(ByteReader& job, Crew& crew, PluginRegistry& plugins,
                      int threads) {
  const std::string text = job.text();
  TargetPose about;
  const std::vector<double> R = job.numbers();
  about.R = Eigen::Matrix3d::Map(R.data());
  about.p = point_of(job);
  SimulationOptions options;
  options.runs = static_cast<int>(job.whole());
  options.seed = job.whole();
  options.filter = static_cast<FilterKind>(job.whole());
  options.seconds = job.real();
  options.resume = job.text();
  options.threads = threads;
  GivenPath path;
  path.t = job.numbers();
  for (std::size_t i = 0; i < path.t.size(); ++i) path.p.push_back(point_of(job));
  if (!path.t.empty()) options.path = std::move(path);

  Diagnostics findings;
  const auto scene = parse_scene(text, "scene.yaml", {}, plugins, findings);
  if (!scene) return compare_plugins(crew, to_string(findings.front()));
  compare_plugins(crew, *scene, plugins);
  (void)my_part(build_system(*scene, plugins), about, options, crew);
}

}  // namespace delos
