// delos field: a metric over the samples of a scene.
#include <iostream>
#include <memory>

#include "command.h"
#include "delos/output/write.h"
#include "delos/sampling/samples.h"
#include "delos/scene/units.h"
#include "summary.h"

namespace delos::cli {
namespace {

struct FieldCommand {
  SceneOptions options;
  std::filesystem::path scene;
  std::vector<std::filesystem::path> out;
  bool log10 = false;
  std::string slice;
};

int run(const FieldCommand& command) {
  PluginRegistry plugins(plugin_folders(command.options.plugin_dirs));
  const LoadedScene loaded = load(command.scene, command.options, plugins);
  const Samples samples = make_samples(loaded.scene.samples);
  for (const auto& file : command.out) {
    if (const std::string problem = writable(samples, file); !problem.empty()) {
      throw Failure{kUsage, problem};
    }
  }
  PictureOptions picture;
  picture.log10 = command.log10;
  picture.larger_is_better = loaded.metric.larger_is_better;
  if (!command.slice.empty()) {
    const auto z = parse_quantity(command.slice, "m");
    if (const auto* problem = std::get_if<std::string>(&z)) {
      throw Failure{kUsage, "--slice: " + *problem};
    }
    picture.slice_z = std::get<double>(z);
    picture.has_slice = true;
  }

  const Interrupt interrupt;
  const Field field = evaluate(loaded, samples, command.options, interrupt);
  for (const auto& file : command.out) {
    if (const std::string problem = write_field(field, file, picture);
        !problem.empty()) {
      throw Failure{kDiagnostics, problem};
    }
  }
  if (command.options.json) {
    std::cout << field_json(field);
  } else {
    print_summary(std::cout, loaded, field);
    for (const auto& file : command.out) std::cout << "wrote " << file.string() << "\n";
  }
  if (field.cancelled) {
    std::cerr << "delos: stopped after " << field.evaluated << " of "
              << samples.points.size() << " samples; the rest count as blind\n";
    return kCancelled;
  }
  return kDone;
}

}  // namespace

void add_field_command(CLI::App& program, int& exit_code) {
  auto command = std::make_shared<FieldCommand>();
  CLI::App* app = program.add_subcommand("field", "The field and its statistics");
  app->add_option("scene", command->scene, "Scene file")->required();
  add_scene_options(*app, command->options);
  app->add_option("--out", command->out,
                  "Write .vti, .vtp, .csv, .json or .png; repeatable")
      ->allow_extra_args(false);
  app->add_option("--slice", command->slice,
                  "Height of the .png slice, for example 1.5 or '50 cm'");
  app->add_flag("--log10", command->log10, "Colours of the .png follow log10");
  app->footer(
      "Examples:\n"
      "  delos field scenes/01-acoustic.yaml --json\n"
      "  delos field scenes/05-optitrack-lab.yaml --out lab.vti --out lab.png --slice "
      "1.6\n"
      "  delos field scenes/01-acoustic.yaml --set devices.s1.at.z='90 cm' --metric "
      "sigma_z");
  app->callback([command, &exit_code] { exit_code = run(*command); });
}

}  // namespace delos::cli
