// delos show: a field that was kept, without computing it again.
#include <iostream>
#include <memory>

#include "command.h"
#include "delos/text/units.h"
#include "delos/text/words.h"
#include "json.h"
#include "session/stored_field.h"
#include "session/written_field.h"
#include "summary.h"

namespace delos::cli {
namespace {

struct ShowCommand {
  std::filesystem::path file;
  std::vector<std::filesystem::path> out;
  std::string slice;
  bool log10 = false, json = false;
};

PictureOptions picture_of(const ShowCommand& command,
                          const session::StoredField& stored) {
  PictureOptions picture;
  picture.log10 = command.log10;
  picture.larger_is_better = stored.field.larger_is_better;
  picture.devices = stored.devices;
  if (command.slice.empty()) return picture;
  const auto z = parse_quantity(command.slice, "m");
  if (const auto* problem = std::get_if<std::string>(&z))
    throw Failure{kUsage, "--slice: " + *problem};
  picture.slice_z = std::get<double>(z);
  picture.has_slice = true;
  return picture;
}

int run(const ShowCommand& command) {
  auto read = session::read_field(command.file);
  if (const auto* problem = std::get_if<std::string>(&read))
    throw Failure{kDiagnostics, *problem};
  const auto& stored = std::get<session::StoredField>(read);
  const PictureOptions picture = picture_of(command, stored);
  for (const auto& file : command.out)
    if (const std::string problem = writable(stored.field.samples, file);
        !problem.empty())
      throw Failure{kUsage, problem};
  for (const auto& file : command.out)
    if (const std::string problem = write_field(stored.field, file, picture);
        !problem.empty())
      throw Failure{kDiagnostics, problem};
  if (command.json) {
    print_document(Json::parse(field_json(stored.field)));
    return kDone;
  }
  std::cout << stored.field.scene << "\n"
            << stored.field.metric << " of the " << to_string(stored.field.definition)
            << ", kept in " << command.file.string() << "\n";
  print_statistics(std::cout, stored.field);
  return kDone;
}

}  // namespace

void add_show_command(CLI::App& program, int& exit_code) {
  auto command = std::make_shared<ShowCommand>();
  CLI::App* app = program.add_subcommand(
      "show", "A field that was kept in a file, without computing it again");
  app->add_option("file", command->file, "What delos field --out NAME.field wrote")
      ->required();
  app->add_option("--out", command->out,
                  "Write .vti, .vtu, .vtp, .csv, .json or .png; repeatable")
      ->allow_extra_args(false);
  app->add_option("--slice", command->slice,
                  "Height of the .png slice, for example 1.5 or '50 cm'");
  app->add_flag("--log10", command->log10, "Colours of the .png follow log10");
  app->add_flag("--json", command->json, "One JSON document on stdout, nothing else");
  app->footer(
      "Examples:\n"
      "  delos field scenes/05-optitrack-lab.yaml --out lab.field\n"
      "  delos show lab.field --out lab.png --slice 1.6\n"
      "  delos compare lab.field better.field");
  app->callback([command, &exit_code] { exit_code = run(*command); });
}

}  // namespace delos::cli
