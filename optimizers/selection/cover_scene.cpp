#include "delos/optimize/cover_scene.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <stdexcept>

#include "delos/layers/candidate_information.h"
#include "delos/model/infinity.h"
#include "delos/scene/definition.h"
#include "delos/text/words.h"
#include "selection/question.h"

namespace delos {
namespace {

/// What must be seen: samples outside solids, each in every orientation.
std::vector<TargetPose> poses_to_see(const Scene& scene, const System& system) {
  const Samples samples = all_samples(scene);
  const std::vector<unsigned char> inside =
      samples_inside_solids(system, samples, scene.orientations);
  std::vector<TargetPose> poses;
  for (std::size_t s = 0; s < samples.points.size(); ++s) {
    if (!inside.empty() && inside[s]) continue;
    for (const Eigen::Vector3d& rpy : scene.orientations.rpy)
      poses.push_back({rotation_from_rpy(rpy), samples.points[s]});
  }
  return poses;
}

CoverProblem problem_of(const CandidateScene& all, CandidateViews views) {
  CoverProblem problem;
  problem.samples = static_cast<int>(views.always.size());
  problem.start.assign(views.first.begin(), views.first.end());
  problem.seen = std::move(views.poses);
  for (const std::int32_t always : views.always)
    problem.demand.push_back(std::max(0, *all.scene.selection.cover - always));
  for (const Candidate& c : all.candidates) {
    problem.cost.push_back(c.cost);
    problem.group.push_back(c.spot);
    problem.fixed.push_back(c.kept       ? Membership::in
                            : c.left_out ? Membership::out
                                         : Membership::free);
  }
  return problem;
}

/// The part of the time in which it must be known what candidates see: the rest is for
/// a first cover and bound.
constexpr double kForViews = 0.85;

/// What candidates see, with progress, unless the time ends first.
CandidateViews views_in_time(const System& system, const CandidateScene& all,
                             const std::vector<TargetPose>& poses,
                             const SelectOptions& options,
                             const std::function<double()>& elapsed) {
  double part = 0;
  CandidateViews views =
      candidate_views(system, all, poses, options.threads, [&](double ready) {
        part = ready;
        if (options.progress) options.progress({kInfinity, 0, 0, ready});
        return elapsed() < kForViews * options.seconds &&
               !(options.cancel && options.cancel->load());
      });
  if (!views.first.empty()) return views;
  throw std::invalid_argument(
      std::to_string(static_cast<int>(100 * part)) + " % of " +
      std::to_string(all.candidates.size()) +
      " candidates were asked what they see of " + std::to_string(poses.size()) +
      " samples before the time was over; allow more seconds, or fewer of them");
}

/// The first few samples that are seen too seldom, for the user.
std::string blind_text(const std::vector<int>& blind,
                       const std::vector<TargetPose>& poses, int wanted) {
  constexpr std::size_t kShown = 5;
  std::string text = std::to_string(blind.size()) + " of " +
                     std::to_string(poses.size()) + " samples can't be seen " +
                     (wanted == 1 ? "at all" : std::to_string(wanted) + " times") +
                     ", whatever is chosen:";
  for (std::size_t i = 0; i < std::min(kShown, blind.size()); ++i)
    text += "\n  at " + coordinates(poses[static_cast<std::size_t>(blind[i])].p);
  if (blind.size() > kShown)
    text += "\n  and " + std::to_string(blind.size() - kShown) + " more";
  return text;
}

}  // namespace

SceneCover cover_scene(const Scene& scene, PluginRegistry& plugins,
                       const SelectOptions& options) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  const auto elapsed = [&] {
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  if (!scene.selection.cover) throw std::invalid_argument("the selection has no cover");
  auto written = write_out_candidates(with_definition(scene));
  if (const auto* problem = std::get_if<std::string>(&written))
    throw std::invalid_argument(*problem);
  SceneCover cover;
  cover.all = std::get<0>(std::move(written));
  const System system = build_system(cover.all.scene, plugins);
  const std::vector<TargetPose> poses = poses_to_see(scene, system);
  const CoverProblem problem =
      problem_of(cover.all, views_in_time(system, cover.all, poses, options, elapsed));

  CoverOptions how;
  how.seed = options.seed;
  how.seconds = std::max(0.1, options.seconds - elapsed());
  how.threads = options.threads;
  how.cancel = options.cancel;
  if (options.progress)
    how.progress = [&](const CoverProgress& at) {
      options.progress({at.cost, at.bound, 0});
    };
  const CoverAnswer answer = [&] {
    try {
      return solve_cover(problem, how);
    } catch (const Uncoverable& blind) {
      throw std::invalid_argument(
          blind_text(blind.samples, poses, *scene.selection.cover));
    }
  }();
  if (!answer.found())
    throw std::invalid_argument(
        answer.stop == CoverStop::infeasible
            ? "no cover exists: candidates of one spot exclude each other"
            : "no cover was found in time; allow more seconds");
  cover.chosen.assign(answer.chosen.begin(), answer.chosen.end());
  cover.cost = answer.cost;
  cover.lower_bound = answer.lower_bound;
  cover.samples = poses.size();
  cover.stop = answer.stop;
  cover.seconds = elapsed();
  return cover;
}

}  // namespace delos
