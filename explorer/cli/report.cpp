// delos report: a scene or a study as one HTML page.
#include "report/report.h"

#include <fstream>
#include <iostream>
#include <memory>

#include "command.h"
#include "delos/text/units.h"
#include "json.h"
#include "output/write.h"
#include "report/tradeoff.h"

namespace delos::cli {
namespace {

struct ReportCommand {
  SceneOptions options;
  std::filesystem::path input, out;
  std::string loss = "5 %";
  bool brief = false;
  std::vector<std::filesystem::path> tradeoffs;
};

/// Studies are SQLite databases, which begin with these bytes.
bool is_study(const std::filesystem::path& file) {
  constexpr std::string_view kMagic = "SQLite format 3";
  std::string start(kMagic.size(), ' ');
  std::ifstream(file, std::ios::binary)
      .read(start.data(), static_cast<std::streamsize>(start.size()));
  return start == kMagic;
}

/// What delos tradeoff found.
std::vector<Json> tradeoffs(const std::vector<std::filesystem::path>& files) {
  std::vector<Json> all;
  for (const std::filesystem::path& file : files) {
    std::ifstream in(file);
    if (!in) throw Failure{kUsage, file.string() + ": can't be read"};
    try {
      all.push_back(report::tradeoff_json(Json::parse(in)));
    } catch (const Json::parse_error&) {
      throw Failure{kDiagnostics, file.string() + ": isn't JSON"};
    } catch (const std::invalid_argument& refusal) {
      throw Failure{kDiagnostics, file.string() + ": " + refusal.what()};
    }
  }
  return all;
}

double loss_of(const ReportCommand& command) {
  const auto loss = parse_quantity(command.loss, "1");
  if (const auto* problem = std::get_if<std::string>(&loss))
    throw Failure{kUsage, "--loss '" + command.loss + "': " + *problem};
  return std::get<double>(loss);
}

report::Report study_report(const ReportCommand& command, const report::Making& making,
                            PluginRegistry& plugins) {
  const Study study(command.input, plugins);
  Progress progress(study.summary().scene + ", what the design depends on");
  const auto told = [&](std::size_t done, std::size_t of) {
    progress.update(done, of);
  };
  return report::study_report(
      study, making,
      {loss_of(command), !command.brief, tradeoffs(command.tradeoffs), told}, plugins);
}

report::Report report_of(const ReportCommand& command, PluginRegistry& plugins) {
  const Interrupt interrupt;
  Progress progress(command.input.stem().string());
  report::Making making{command.input.string(), DELOS_VERSION,
                        field_options(command.options, interrupt, progress), [&] {
                          if (interrupt.requested())
                            throw Failure{kCancelled, "stopped; nothing was written"};
                        }};
  try {
    return is_study(command.input)
               ? study_report(command, making, plugins)
               : report::scene_report(load(command.input, command.options, plugins),
                                      making, plugins);
  } catch (const std::invalid_argument& refusal) {
    throw Failure{kDiagnostics, refusal.what()};
  } catch (const std::runtime_error& failure) {
    throw Failure{kDiagnostics, failure.what()};
  }
}

int run(const ReportCommand& command) {
  PluginRegistry plugins(plugin_folders(command.options.plugin_dirs));
  const std::string page = report::page_of(report_of(command, plugins));
  if (const std::string problem = write_text(command.out, page); !problem.empty())
    throw Failure{kDiagnostics, problem};
  std::cerr << "wrote " << command.out.string() << "\n";
  return kDone;
}

}  // namespace

void add_report_command(CLI::App& program, int& exit_code) {
  auto command = std::make_shared<ReportCommand>();
  CLI::App* app = program.add_subcommand(
      "report", "A scene or a study as one HTML page, with pictures");
  app->add_option("input", command->input, "Scene file (.yaml), or study")->required();
  app->add_option("-o,--out", command->out, "The page to write, .html")->required();
  app->add_option("--loss", command->loss,
                  "Of a study: loss for which the variables' tolerances are told")
      ->capture_default_str();
  app->add_flag("--brief", command->brief,
                "Of a study: without tolerances and failures, which take longest");
  app->add_option("--tradeoff", command->tradeoffs,
                  "Of a study: also what delos tradeoff --json wrote; repeatable")
      ->allow_extra_args(false);
  app->add_option("--threads", command->options.threads, "Threads; 0: one a core")
      ->check(CLI::Range(0, 4096))
      ->capture_default_str();
  app->add_option("--metric", command->options.metric,
                  "Of a scene: metric instead of its own");
  app->add_option("--set", command->options.set,
                  "Of a scene: change a value: PATH=VALUE, repeatable")
      ->type_name("PATH=VALUE")
      ->allow_extra_args(false);
  app->add_option("--plugin-dir", command->options.plugin_dirs,
                  "Folder with device plugins, searched first; repeatable")
      ->allow_extra_args(false);
  app->footer(
      "The explorer's page with its data frozen in: it needs no other files and no\n"
      "network, and can be turned, sliced and printed. Without scripts it has "
      "pictures.\n"
      "Examples:\n"
      "  delos report scenes/06-furnished-lab.yaml -o lab.html\n"
      "  delos optimize scenes/09-camera-room.yaml --study room.study\n"
      "  delos report room.study -o room.html");
  app->callback([command, &exit_code] { exit_code = run(*command); });
}

}  // namespace delos::cli
