// delos demo: the main job on a real laboratory, with a picture.
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <memory>

#include "command.h"
#include "session/shipped_scenes.h"
#include "session/written_field.h"
#include "summary.h"

namespace delos::cli {
namespace {

constexpr const char* kScene = "05-optitrack-lab.yaml";

int terminal_columns() {
  winsize size{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0)
    return size.ws_col;
  return 80;
}

int run(const SceneOptions& options, const std::filesystem::path& out) {
  const std::filesystem::path file =
      std::filesystem::proximate(session::scenes_folder() / kScene);
  PluginRegistry plugins(plugin_folders(options.plugin_dirs));
  const LoadedScene loaded = load(file, options, plugins);
  const Samples samples = make_samples(loaded.scene.samples);
  const Interrupt interrupt;
  const Field field = evaluate(loaded, samples, options, interrupt);
  const PictureOptions picture{.larger_is_better = loaded.metric.larger_is_better,
                               .devices = markers_of(loaded.scene, loaded.system)};
  if (const std::string problem = write_field(field, out, picture); !problem.empty()) {
    throw Failure{kDiagnostics, problem};
  }
  print_summary(std::cout, loaded, field);
  const bool colour = isatty(STDOUT_FILENO) && !std::getenv("NO_COLOR");
  std::cout << "\n"
            << terminal_picture(field, std::min(terminal_columns(), 100), colour,
                                picture)
            << "\nThe picture: " << out.string() << "\nThe scene:   " << file.string()
            << "\nTry next:    ./delos point " << file.string() << " --at 0,0,1.5\n";
  return field.cancelled ? kCancelled : kDone;
}

}  // namespace

void add_demo_command(CLI::App& program, int& exit_code) {
  struct Demo {
    SceneOptions options;
    std::filesystem::path out = "delos-demo.png";
  };
  auto demo = std::make_shared<Demo>();
  CLI::App* app = program.add_subcommand(
      "demo", "Evaluate and draw a real motion-capture laboratory of eight cameras");
  app->add_option("--out", demo->out, "Where the picture goes")->capture_default_str();
  app->footer("Example:\n  delos demo --out laboratory.png");
  app->callback([demo, &exit_code] { exit_code = run(demo->options, demo->out); });
}

}  // namespace delos::cli
