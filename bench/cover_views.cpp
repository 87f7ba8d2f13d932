// What candidates of a cover see: each asked about every sample, and as
// candidate_views() does it, which asks whole boxes of samples first.
//
//     bench_cover_views [SIDE]...       default: rooms of 5, 10, 15, 25 and 50 m
//
// The rooms are those of scenes/14-camera-cover.yaml. Processor seconds of all threads.
// Asking every sample is left out above 20 m. Both lists are compared.
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "delos/layers/candidate_information.h"
#include "delos/sampling/samples.h"
#include "delos/scene/io.h"

namespace {

using namespace delos;

double processor() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Without bodies that hide: blocks of kLanes samples, one after the other.
std::vector<std::int32_t> every_sample(const System& system,
                                       const std::vector<TargetPose>& poses) {
  std::vector<std::int32_t> seen;
  PointLanes points{};
  RowLanes rows{};
  for (const PlacedDevice& placed : system.devices) {
    const Pose X_SW = placed.X_WS().inverse();
    for (std::size_t first = 0; first < poses.size(); first += kLanes) {
      points.count =
          static_cast<int>(std::min<std::size_t>(kLanes, poses.size() - first));
      for (int l = 0; l < points.count; ++l) {
        const Eigen::Vector3d p = X_SW * poses[first + static_cast<std::size_t>(l)].p;
        for (int k = 0; k < 3; ++k) points.p[k][l] = p(k);
      }
      if (!placed.device->observe_lanes(points, rows)) std::abort();
      for (int l = 0; l < points.count; ++l)
        if (rows.seen[l] > 0) seen.push_back(static_cast<std::int32_t>(first) + l);
    }
  }
  return seen;
}

void run(int side, PluginRegistry& plugins) {
  const std::string end = "[" + std::to_string(side) + ", " + std::to_string(side);
  Diagnostics findings;
  const auto scene = load_scene(std::string(DELOS_SCENES) + "/14-camera-cover.yaml",
                                {{"selection.candidates.0.grid.max", end + ", 2.5]"},
                                 {"sample.volume.max", end + ", 2]"}},
                                plugins, findings);
  if (!scene) std::abort();
  const auto all = std::get<CandidateScene>(write_out_candidates(*scene));
  const System system = build_system(all.scene, plugins);
  std::vector<TargetPose> poses;
  for (const Eigen::Vector3d& p : make_samples(scene->samples).points)
    poses.push_back({Eigen::Matrix3d::Identity(), p});

  double start = processor();
  const CandidateViews views = candidate_views(system, all, poses);
  std::printf("%4d %10zu %7zu %11zu %9.2f", side, all.candidates.size(), poses.size(),
              views.poses.size(), processor() - start);
  if (side <= 20) {
    start = processor();
    const std::vector<std::int32_t> seen = every_sample(system, poses);
    std::printf(" %13.2f   %s", processor() - start,
                seen == views.poses ? "the same" : "DIFFERENT");
  }
  std::printf("\n");
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  PluginRegistry plugins({DELOS_PLUGINS});
  std::vector<int> sides = {5, 10, 15, 25, 50};
  if (argc > 1) {
    sides.clear();
    for (int i = 1; i < argc; ++i) sides.push_back(std::atoi(argv[i]));
  }
  std::printf("side candidates samples   sightings   by boxes  every sample\n");
  for (const int side : sides) run(side, plugins);
}
