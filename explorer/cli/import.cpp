// delos import: a file that people have, as a scene.
#include "imports/import.h"

#include <iostream>
#include <memory>
#include <numbers>

#include "command.h"
#include "delos/text/format.h"
#include "delos/text/units.h"
#include "delos/text/words.h"
#include "figures/rig_figure.h"
#include "imports/opening.h"
#include "session/written_field.h"
#include "summary.h"

namespace delos::cli {
namespace {

using imports::ImportOptions;
using imports::Rig;

struct ImportCommand {
  std::filesystem::path file, out, picture;
  std::string unit, resolution, up, subject, height;
  bool mirrored = false;
  std::vector<std::filesystem::path> plugin_dirs;
};

/// @throws Failure kUsage
ImportOptions import_options(const ImportCommand& command) {
  ImportOptions options;
  options.up = command.up;
  options.subject = command.subject;
  options.mirrored = command.mirrored;
  if (!command.unit.empty()) {
    const bool number = command.unit.find_first_of("0123456789") == 0;
    const auto unit = parse_quantity((number ? "" : "1 ") + command.unit, "m");
    if (const auto* problem = std::get_if<std::string>(&unit))
      throw Failure{kUsage, "--unit '" + command.unit + "': " + *problem};
    if (!(std::get<double>(unit) > 0))
      throw Failure{kUsage, "--unit '" + command.unit + "': must be above 0"};
    options.unit = std::get<double>(unit);
  }
  if (!command.height.empty()) {
    const auto height = parse_quantity(command.height, "m");
    if (const auto* problem = std::get_if<std::string>(&height))
      throw Failure{kUsage, "--height '" + command.height + "': " + *problem};
    if (!(std::get<double>(height) > 0.5))
      throw Failure{kUsage, "--height '" + command.height + "': must be above 0.5 m"};
    options.height = std::get<double>(height);
  }
  if (!command.resolution.empty()) {
    int width = 0, height = 0, end = 0;
    if (std::sscanf(command.resolution.c_str(), "%6dx%6d%n", &width, &height, &end) !=
            2 ||
        static_cast<std::size_t>(end) != command.resolution.size() || width < 1 ||
        height < 1)
      throw Failure{kUsage, "--resolution '" + command.resolution +
                                "': write WIDTHxHEIGHT in pixels, such as 1280x1024"};
    options.resolution = Eigen::Vector2d(width, height);
  }
  return options;
}

void print_found(const Rig& rig, const ImportCommand& command,
                 const LoadedScene& loaded) {
  std::cout << command.file.filename().string() << ": " << rig.kind << ", "
            << counted(rig.devices.size(), "device") << "\n";
  for (const std::string& fact : rig.facts) std::cout << "  " << fact << "\n";
  std::cout << "  " << cell("device", 20) << cell("at [m]", 26)
            << cell("looks along", 24) << "view\n";
  constexpr std::size_t kListed = 40;
  for (std::size_t i = 0; i < loaded.system.devices.size(); ++i) {
    const PlacedDevice& device = loaded.system.devices[i];
    if (i == kListed) {
      std::cout << "  and " << loaded.system.devices.size() - kListed << " more\n";
      break;
    }
    std::cout << "  " << cell(device.name, 20) << cell(coordinates(device.X_WS().p), 26)
              << cell(coordinates(device.X_WS().R.col(2), 2), 24)
              << imports::opening_text(device) << "\n";
  }
  for (const imports::RigVariable& v : rig.variables)
    std::cout << "  variable " << v.path
              << (v.lower.empty() ? "" : " from " + v.lower + " to " + v.upper)
              << (v.remark.empty() ? "" : ", " + v.remark) << "\n";
  if (!rig.assumed.empty()) std::cout << "Assumed, since the file doesn't say it:\n";
  for (const std::string& each : rig.assumed) std::cout << "  " << each << "\n";
}

/// The scene's text, read as a scene: what Delos would say of it is said now.
LoadedScene built(const std::string& text, const std::filesystem::path& file,
                  PluginRegistry& plugins) {
  Diagnostics findings;
  const auto scene = parse_scene(text, file, {}, plugins, findings);
  for (const Diagnostic& d : findings) std::cerr << to_string(d) << "\n";
  if (!scene) throw Failure{kDiagnostics, ""};
  return {*scene, build_system(*scene, plugins), {}};
}

void write_or_fail(const std::filesystem::path& file, const std::string& text) {
  if (const std::string problem = write_text(file, text); !problem.empty())
    throw Failure{kDiagnostics, problem};
  std::cout << "written: " << file.string() << "\n";
}

int run(const ImportCommand& command) {
  const ImportOptions options = import_options(command);
  Diagnostics findings;
  const std::filesystem::path folder =
      command.out.empty() ? command.file.parent_path() : command.out.parent_path();
  const auto rig = imports::import_file(command.file, folder.empty() ? "." : folder,
                                        options, findings);
  for (const Diagnostic& d : findings) std::cerr << to_string(d) << "\n";
  if (!rig) return kDiagnostics;
  const std::string name = command.file.filename().string();
  const std::string text = imports::scene_text(*rig, name, name);
  const std::filesystem::path scene =
      command.out.empty() ? command.file.parent_path() / "scene.yaml" : command.out;
  PluginRegistry plugins(plugin_folders(command.plugin_dirs));
  const LoadedScene loaded = built(text, scene, plugins);
  print_found(*rig, command, loaded);
  if (!command.picture.empty())
    write_or_fail(command.picture, figures::rig_figure(loaded.scene, loaded.system));
  if (!command.out.empty()) {
    write_or_fail(command.out, text);
    std::cout << "next:    delos field " << command.out.string() << "\n";
  }
  return kDone;
}

}  // namespace

void add_import_command(CLI::App& program, int& exit_code) {
  auto command = std::make_shared<ImportCommand>();
  CLI::App* app = program.add_subcommand(
      "import",
      "A calibration, an Artemis file or a floor plan as a scene; imports.md");
  app->add_option("file", command->file,
                  "What it is, its contents say: Qualisys, Vicon, Motive, Caliscope, "
                  "Pose2Sim, aniposelib, Kalibr, Human3.6M, mrcal, ROS, EasyMocap, "
                  "OpenCV, COLMAP, lighthouse, Artemis, GeoJSON, SVG")
      ->required();
  app->add_option("-o,--out", command->out,
                  "The scene; without it the file is only looked at");
  app->add_option(
      "--picture", command->picture,
      "An SVG of where devices stand and look: is it the room that you know?");
  app->add_option(
      "--unit", command->unit,
      "Of its lengths, where the file doesn't say it, or says it wrong: mm, m, "
      "'0.35 m'");
  app->add_option("--resolution", command->resolution,
                  "Of images, where the file doesn't say it: 1280x1024");
  app->add_option(
      "--up", command->up,
      "Which way is up in the file: z, y or -y; default: as its format has it");
  app->add_option("--subject", command->subject,
                  "Of files with several, such as Human3.6M");
  app->add_option("--height", command->height, "Of the rooms of a floor plan: 3 m");
  app->add_flag("--mirrored", command->mirrored,
                "Vicon: principal points count from the opposite corner");
  app->add_option("--plugin-dir", command->plugin_dirs,
                  "Folder with device plugins, searched first; repeatable")
      ->allow_extra_args(false);
  app->footer(
      "Examples:\n"
      "  delos import Calib.qca.txt -o rig.yaml --picture rig.svg\n"
      "  delos import calibration.toml --unit mm -o rig.yaml\n"
      "  delos import study.ext -o study.yaml\n"
      "  delos import floor.geojson --height '2.7 m' -o room.yaml");
  app->callback([command, &exit_code] { exit_code = run(*command); });
}

}  // namespace delos::cli
