// delos new-device: a device of one's own, to begin with.
#include "session/new_device.h"

#include <iostream>
#include <memory>

#include "command.h"

namespace delos::cli {
namespace {

int run(const std::string& id, const std::filesystem::path& folder) {
  try {
    PluginRegistry plugins;
    if (plugins.find(id).info)
      throw std::runtime_error("there is a device '" + id +
                               "' already; 'delos devices " + id + "' shows it");
    const session::NewDevice made = session::write_new_device(id, folder);
    for (const auto& file : made.files) std::cout << file.string() << "\n";
    const std::string at = folder.string();
    std::cout << "Build it, test it, see it:\n"
              << "  cmake -S " << at << " -B " << at
              << "/build -D CMAKE_PREFIX_PATH=" << made.prefix.string() << "\n"
              << "  cmake --build " << at << "/build\n"
              << "  ctest --test-dir " << at << "/build\n"
              << "  delos field " << at << "/scene.yaml --plugin-dir " << at
              << "/build/lib/delos --out " << at << "/field.png\n";
    return kDone;
  } catch (const std::runtime_error& problem) {
    throw Failure{kDiagnostics, problem.what()};
  }
}

}  // namespace

void add_new_device_command(CLI::App& program, int& exit_code) {
  struct Command {
    std::string id;
    std::filesystem::path folder;
  };
  auto command = std::make_shared<Command>();
  CLI::App* app = program.add_subcommand(
      "new-device", "Begin a device of your own: source, build, test, scene");
  app->add_option("id", command->id, "What scenes call it, such as my_sensor")
      ->required();
  app->add_option("folder", command->folder, "Where its files are written")->required();
  app->footer("Example:\n  delos new-device my_sensor my_sensor");
  app->callback(
      [command, &exit_code] { exit_code = run(command->id, command->folder); });
}

}  // namespace delos::cli
