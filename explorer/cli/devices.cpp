// delos devices: the device plugins and their parameter tables.
#include <iostream>
#include <memory>

#include "command.h"
#include "delos/text/units.h"
#include "json.h"
#include "session/palette.h"
#include "session/parameter_table.h"
#include "summary.h"

namespace delos::cli {
namespace {

using session::parameter_table;
using session::word;

struct DevicesCommand {
  std::string id;
  std::vector<std::filesystem::path> plugin_dirs;
  bool json = false, markdown = false, presets = false;
};

std::string default_of(const ParamSpec& p) {
  if (p.kind == ParamKind::number) {
    return std::isnan(p.initial) ? "required" : shortest(p.initial);
  }
  return p.text ? p.text : "required";
}

std::string range_of(const ParamSpec& p) {
  if (p.kind == ParamKind::choice) return p.choices;
  const bool lower = std::isfinite(p.lower), upper = std::isfinite(p.upper);
  if (lower && upper) return shortest(p.lower) + " … " + shortest(p.upper);
  if (lower) return "≥ " + shortest(p.lower);
  if (upper) return "≤ " + shortest(p.upper);
  return "any";
}

/// '|' would end a cell.
std::string escaped(std::string text) {
  for (std::size_t i = 0; (i = text.find('|', i)) != std::string::npos; i += 2) {
    text.insert(i, "\\");
  }
  return text;
}

void print_markdown(const PluginInfo& info) {
  std::cout << "### `" << info.id << "` " << info.version << "\n\n"
            << info.summary << "\n\n"
            << "| parameter | kind | unit | default | range | meaning |\n"
            << "|---|---|---|---|---|---|\n";
  for (std::uint32_t i = 0; i < info.n_params; ++i) {
    const ParamSpec& p = info.params[i];
    std::cout << "| `" << p.name << "` | " << word(p.kind) << " | " << p.unit << " | "
              << escaped(default_of(p)) << " | " << escaped(range_of(p)) << " | "
              << escaped(p.help) << " |\n";
  }
}

void print_plain(const PluginInfo& info) {
  std::cout << info.id << " " << info.version << ": " << info.summary << "\n";
  for (std::uint32_t i = 0; i < info.n_params; ++i) {
    const ParamSpec& p = info.params[i];
    std::cout << "  " << cell(p.name, 12) << p.help << "\n"
              << std::string(14, ' ') << word(p.kind) << ", unit " << p.unit
              << ", default " << default_of(p) << ", range " << range_of(p) << "\n";
  }
}

int show_one(const DevicesCommand& command, PluginRegistry& plugins) {
  const PluginLoad& load = plugins.find(command.id);
  if (!load.info) throw Failure{kDiagnostics, load.error};
  if (command.json) {
    print_document(parameter_table(*load.info));
  } else if (command.markdown) {
    print_markdown(*load.info);
  } else {
    print_plain(*load.info);
  }
  return kDone;
}

int show_all(const DevicesCommand& command, PluginRegistry& plugins) {
  int exit_code = kDone;
  Json json = Json::array();
  for (const PluginLoad& load : plugins.all()) {
    if (!load.info) {
      std::cerr << load.error << "\n";
      exit_code = kDiagnostics;
    } else if (command.json) {
      json.push_back(parameter_table(*load.info));
    } else if (command.markdown) {
      print_markdown(*load.info);
      std::cout << "\n";
    } else {
      std::cout << cell(load.info->id, 18) << load.info->summary << "\n";
    }
  }
  if (command.json) print_document(json);
  return exit_code;
}

/// What to write for devices that one can buy, of one plugin or of all.
int show_presets(const std::string& id) {
  bool any = false;
  for (const DevicePreset& preset : device_presets()) {
    if (!id.empty() && id != preset.type) continue;
    any = true;
    std::cout << preset.name << "\n  type: " << preset.type << ", params: {"
              << preset.params << "}\n";
    if (preset.add[0] != 0)
      std::cout << "  no figure is published for, and you add, such as: " << preset.add
                << "\n";
    std::cout << "  source: " << preset.source << "\n";
  }
  if (!any) throw Failure{kDiagnostics, "there is no preset of '" + id + "'"};
  return kDone;
}

}  // namespace

void add_devices_command(CLI::App& program, int& exit_code) {
  auto command = std::make_shared<DevicesCommand>();
  CLI::App* app =
      program.add_subcommand("devices", "Device plugins and their parameters");
  app->add_option("id", command->id, "One device: its parameter table");
  app->add_option("--plugin-dir", command->plugin_dirs,
                  "Folder with device plugins, searched first; repeatable")
      ->allow_extra_args(false);
  auto* json = app->add_flag("--json", command->json, "As JSON");
  app->add_flag("--markdown", command->markdown, "As Markdown tables")->excludes(json);
  app->add_flag("--presets", command->presets,
                "Published figures of devices that one can buy, with their sources")
      ->excludes(json);
  app->footer(
      "Examples:\n  delos devices\n  delos devices pinhole_camera --markdown\n"
      "  delos devices imu --presets");
  app->callback([command, &exit_code] {
    if (command->presets) {
      exit_code = show_presets(command->id);
      return;
    }
    for (const auto& folder : command->plugin_dirs) {
      std::error_code error;
      const std::filesystem::directory_iterator readable(folder, error);
      if (error)
        throw Failure{kDiagnostics,
                      "--plugin-dir " + folder.string() + ": " + error.message()};
    }
    PluginRegistry plugins(plugin_folders(command->plugin_dirs));
    exit_code =
        command->id.empty() ? show_all(*command, plugins) : show_one(*command, plugins);
  });
}

}  // namespace delos::cli
