// delos explore: the explorer in the browser.
#include "server/explore.h"

#include <spawn.h>
#include <unistd.h>

#include <cstdlib>
#include <iostream>
#include <memory>
#include <system_error>

#include "command.h"

namespace delos::cli {
namespace {

struct ExploreCommand {
  server::ExploreOptions options;
  std::vector<std::filesystem::path> plugin_dirs;
  bool no_open = false;
};

/// Where there is a desktop, its browser; else the printed address must do.
void show_in_browser(const std::string& address) {
  if (!std::getenv("DISPLAY") && !std::getenv("WAYLAND_DISPLAY")) return;
  std::string program = "xdg-open", argument = address;
  char* words[] = {program.data(), argument.data(), nullptr};
  pid_t child = 0;
  posix_spawnp(&child, words[0], nullptr, nullptr, words, environ);
}

/// A scene that isn't in order is told here, and not first in the browser.
void check_scene(const std::filesystem::path& file, PluginRegistry& plugins) {
  if (!file.empty()) static_cast<void>(load(file, SceneOptions{}, plugins));
}

int run(const ExploreCommand& command) {
  PluginRegistry plugins(plugin_folders(command.plugin_dirs));
  check_scene(command.options.scene, plugins);
  const Interrupt interrupt;
  const auto listening = [&](const std::string& address) {
    std::cout << "The explorer is at " << address << "\nCtrl-C ends it." << std::endl;
    if (!command.no_open) show_in_browser(address);
  };
  try {
    server::explore(command.options, plugins, interrupt.requested(), listening);
  } catch (const std::system_error& error) {
    throw Failure{kUsage, error.what()};
  }
  return kDone;
}

}  // namespace

void add_explore_command(CLI::App& program, int& exit_code) {
  auto command = std::make_shared<ExploreCommand>();
  CLI::App* app = program.add_subcommand(
      "explore", "See the field in the browser, drag a device, watch it change");
  app->add_option("scene", command->options.scene,
                  "Scene file; by default, one of those that come with the program");
  app->add_option("--port", command->options.port,
                  "Port of 127.0.0.1; 0: one that is free")
      ->capture_default_str();
  app->add_flag("--no-open", command->no_open, "Open no browser, print the address");
  app->add_option("--threads", command->options.threads, "Threads; 0: one a core")
      ->check(CLI::Range(0, 4096))
      ->capture_default_str();
  app->add_option("--plugin-dir", command->plugin_dirs,
                  "Folder with device plugins, searched first; repeatable")
      ->allow_extra_args(false);
  app->footer(
      "Only this machine can reach it. Ctrl-C ends it with exit code 0.\n"
      "Examples:\n"
      "  delos explore\n"
      "  delos explore scenes/05-optitrack-lab.yaml\n"
      "  delos explore my-room.yaml --port 8042 --no-open");
  app->callback([command, &exit_code] { exit_code = run(*command); });
}

}  // namespace delos::cli
