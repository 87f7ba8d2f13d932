// delos schema: what scenes may hold.
#include "session/schema.h"

#include <iostream>
#include <memory>

#include "command.h"
#include "json.h"
#include "session/key_manual.h"

namespace delos::cli {
namespace {

struct SchemaCommand {
  std::vector<std::filesystem::path> plugin_dirs;
  bool markdown = false;
};

}  // namespace

void add_schema_command(CLI::App& program, int& exit_code) {
  auto command = std::make_shared<SchemaCommand>();
  CLI::App* app = program.add_subcommand(
      "schema",
      "What scenes may hold, as a JSON schema: editors that know it help while\n"
      "one writes");
  app->add_option("--plugin-dir", command->plugin_dirs,
                  "Folder with device plugins, searched first; repeatable")
      ->allow_extra_args(false);
  app->add_flag("--markdown", command->markdown,
                "As tables of keys in Markdown, without the plugins' parameters");
  app->footer(
      "Examples:\n  delos schema > delos.schema.json\n"
      "Then begin scenes with:\n"
      "  # yaml-language-server: $schema=delos.schema.json");
  app->callback([command, &exit_code] {
    exit_code = kDone;
    if (command->markdown) {
      std::cout << session::key_manual();
      return;
    }
    PluginRegistry plugins(plugin_folders(command->plugin_dirs));
    print_document(session::scene_schema(plugins));
  });
}

}  // namespace delos::cli
