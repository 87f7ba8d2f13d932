// Selections of the shipped scenes: how near to their bounds in how long.
//
//     bench_select [SECONDS]          default: 30 s each
#include "delos/optimize/select.h"

#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include "delos/scene/io.h"

int main(int argc, char** argv) {
  using namespace delos;
  SelectOptions options;
  options.seconds = argc > 1 ? std::atof(argv[1]) : 30;
  PluginRegistry plugins(plugin_folders({}));
  std::printf("%-22s %6s %6s %8s %12s %12s %8s %10s %7s %6s\n", "scene", "of", "choose",
              "samples", "value", "bound", "gap", "variances", "nodes", "s");
  for (const char* name : {"12-ceiling-anchors", "13-camera-spots", "hiball/strips"}) {
    Diagnostics findings;
    const auto scene = load_scene(std::string(DELOS_SCENES "/") + name + ".yaml", {},
                                  plugins, findings);
    if (!scene) throw std::runtime_error(to_string(findings.front()));
    const SelectResult r = select(*scene, plugins, options);
    std::printf("%-22s %6zu %6zu %8zu %12.5g %12.5g %6.2f %% %8.2f %% %7zu %6.1f\n",
                name, r.all.candidates.size(), r.chosen.size(), r.samples, r.value,
                r.lower_bound, 100 * r.gap, 100 * r.variance_gap, r.nodes, r.seconds);
  }
}
