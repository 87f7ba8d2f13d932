// delos export: the cameras of a scene as matrices.
#include <iostream>
#include <memory>

#include "command.h"
#include "delos/text/words.h"
#include "imports/camera_export.h"
#include "session/written_field.h"

namespace delos::cli {
namespace {

using imports::MatrixFormat;

struct ExportCommand {
  std::filesystem::path file, out;
  std::string to = "matrix";
  SceneOptions options;
};

int run(const ExportCommand& command) {
  const std::pair<const char*, MatrixFormat> kFormats[] = {
      {"opencv-yaml", MatrixFormat::opencv_yaml},
      {"json", MatrixFormat::json},
      {"csv", MatrixFormat::csv},
      {"matrix", MatrixFormat::matrix}};
  PluginRegistry plugins(plugin_folders(command.options.plugin_dirs));
  const LoadedScene loaded = load(command.file, command.options, plugins);
  const auto cameras = imports::cameras_of(loaded.system);
  if (cameras.empty())
    throw Failure{
        kDiagnostics,
        command.file.string() + ": no camera stands in its world: none has a matrix"};
  std::string text;
  for (const auto& [word, format] : kFormats)
    if (command.to == word) text = imports::matrices_text(cameras, format);
  if (command.out.empty()) {
    std::cout << text;
  } else if (const std::string problem = write_text(command.out, text);
             !problem.empty()) {
    throw Failure{kDiagnostics, problem};
  }
  std::cerr << counted(cameras.size(), "camera") << " of "
            << counted(loaded.system.devices.size(), "device") << "\n";
  return kDone;
}

}  // namespace

void add_export_command(CLI::App& program, int& exit_code) {
  auto command = std::make_shared<ExportCommand>();
  CLI::App* app = program.add_subcommand(
      "export", "The cameras of a scene as matrices; imports.md");
  app->add_option("scene", command->file, "Scene file")->required();
  app->add_option("--to", command->to, "opencv-yaml, json, csv or matrix: 3x4, pixels")
      ->check(CLI::IsMember({"opencv-yaml", "json", "csv", "matrix"}))
      ->capture_default_str();
  app->add_option("-o,--out", command->out, "The file; default: stdout");
  app->add_option("--set", command->options.set,
                  "Change a value: PATH=VALUE, repeatable")
      ->type_name("PATH=VALUE")
      ->allow_extra_args(false);
  app->add_option("--plugin-dir", command->options.plugin_dirs,
                  "Folder with device plugins, searched first; repeatable")
      ->allow_extra_args(false);
  app->footer(
      "Examples:\n"
      "  delos export scenes/20-stereo-rig.yaml\n"
      "  delos export scenes/20-stereo-rig.yaml --to opencv-yaml -o rig.yml");
  app->callback([command, &exit_code] { exit_code = run(*command); });
}

}  // namespace delos::cli
