// delos study: look at, steer and resume a search that is kept in a file.

#include <cmath>
#include <iomanip>
#include <iostream>
#include <memory>

#include "command.h"
#include "consensus.h"
#include "delos/text/format.h"
#include "delos/text/units.h"
#include "delos/text/words.h"
#include "search_report.h"
#include "session/joined_crew.h"
#include "session/search_answer.h"
#include "session/study_answer.h"
#include "summary.h"

namespace delos::cli {
namespace {

struct StudyCommand {
  SceneOptions options;
  std::filesystem::path file;
  std::string action = "show";
  std::vector<std::string> arguments;
  int round = -1;
  std::size_t most = 10;
};

const std::vector<std::string> kActions = {
    "show", "resume", "best",   "export", "pause",  "lock", "unlock",   "set",
    "keep", "drop",   "forbid", "inject", "extend", "undo", "consensus"};

void show(const Study& study, const SceneOptions& options) {
  const StudySummary s = study.summary();
  if (options.json) {
    print_document(session::study_json(s));
    return;
  }
  const std::string unit = objective_unit(study.scene());
  std::cout << s.scene << ": " << objective_text(study.scene()) << ", "
            << s.plan.algorithm << ", seed " << s.plan.seed << "\n";
  for (const StudyRound& r : s.rounds) {
    std::cout << "round " << r.number << ": " << counted(r.evaluations, "evaluation");
    if (r.ended && std::isnan(r.best))
      std::cout << ", no design keeps its constraints\n";
    else if (r.ended)
      std::cout << ", " << format_quantity(std::abs(r.initial), unit) << " -> "
                << format_quantity(std::abs(r.best), unit) << "\n";
    else
      std::cout << ", not at its end: delos study FILE resume\n";
    for (const StudyAct& a : s.acts)
      if (a.after_round == r.number)
        std::cout << "  act " << a.number << ": " << a.verb << " "
                  << a.argument.substr(0, a.argument.find('\n')) << "\n";
  }
  if (!s.waiting.empty()) std::cout << "The last acts hold from the next round on.\n";
  for (const std::string& path : s.locked) std::cout << "locked: " << path << "\n";
}

int resume(Study& study, StudyCommand& command, const session::JoinedCrew& crew,
           PluginRegistry& plugins) {
  const Interrupt interrupt;
  const Scene scene = study.scene();
  SearchLine line(scene);
  OptimizeOptions options;
  options.threads = crew.threads();
  options.crew = crew.get();
  options.cancel = &interrupt.requested();
  options.progress = [&](const SearchProgress& at) { line.update(at); };
  return finish_search([&] { return study.run(options); }, line, command.file,
                       command.file, plugins, command.options.json);
}

int run(StudyCommand& command) {
  PluginRegistry plugins(plugin_folders(command.options.plugin_dirs));
  const session::JoinedCrew crew(command.options.threads);
  if (crew.served(plugins)) return kDone;
  const auto needs = [&](std::size_t count, const char* what) {
    if (command.arguments.size() != count)
      throw Failure{kUsage, "delos study FILE " + command.action + " " + what};
  };
  try {
    Study study(command.file, plugins);
    if (command.action == "show") {
      show(study, command.options);
    } else if (command.action == "best") {
      needs(1, "SCENE.yaml");
      const std::string problem =
          save_scene(study.scene(command.round), study.folder(), command.arguments[0]);
      if (!problem.empty()) throw Failure{kDiagnostics, problem};
    } else if (command.action == "consensus") {
      const session::StudyConsensus found =
          session::study_consensus(study, plugins, command.round, command.most);
      if (command.options.json)
        print_document(session::consensus_json(found));
      else
        print_consensus(std::cout, found);
    } else if (command.action == "export") {
      std::cout << study.dump();
    } else if (command.action == "pause") {
      study.pause();
    } else if (command.action == "resume") {
      return resume(study, command, crew, plugins);
    } else if (command.action == "inject") {
      needs(1, "SCENE.yaml");
      study.act("inject", session::design_of(command.arguments[0], study, plugins));
    } else {
      study.act(command.action, joined(command.arguments, " "));
    }
  } catch (const std::invalid_argument& refusal) {
    throw Failure{kDiagnostics, refusal.what()};
  } catch (const std::runtime_error& failure) {
    throw Failure{kDiagnostics, failure.what()};
  }
  return kDone;
}

}  // namespace

void add_study_command(CLI::App& program, int& exit_code) {
  auto command = std::make_shared<StudyCommand>();
  CLI::App* app = program.add_subcommand(
      "study", "Look at, steer and resume a search that is kept in a file");
  app->add_option("file", command->file, "Study, made by delos optimize --study")
      ->required();
  app->add_option(
         "action", command->action,
         "show, resume, best, export, pause, lock, unlock, set, keep, drop, forbid, "
         "inject, extend, undo, consensus")
      ->check(CLI::IsMember(kActions))
      ->capture_default_str();
  app->add_option("arguments", command->arguments, "What the action is about");
  app->add_option("--round", command->round,
                  "Round whose design `best` writes, or whose designs `consensus` "
                  "compares; 0: the scene as it was given");
  app->add_option("--best", command->most, "Layouts that `consensus` compares")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  app->add_option("--threads", command->options.threads, "Threads; 0: one a core")
      ->check(CLI::Range(0, 4096));
  app->add_option("--plugin-dir", command->options.plugin_dirs,
                  "Folder with device plugins, searched first; repeatable")
      ->allow_extra_args(false);
  app->add_flag("--json", command->options.json,
                "One JSON document on stdout, nothing else");
  app->footer(
      "Acts are journalled, and hold for a search that runs and for all that follow:\n"
      "  lock PATTERN, unlock PATTERN   variables by path; devices.c1 is all of c1's\n"
      "  set PATH=VALUE                 anything of the scene, as --set\n"
      "  keep '{spacing: 50 cm, devices: \"*\"}'   one more constraint\n"
      "  drop NAME                      one constraint less\n"
      "  forbid X,Y,Z X,Y,Z             a box that no device may enter; or the name "
      "of\n"
      "                                 a region, or a body '{sphere: {radius: 1}}'\n"
      "  inject SCENE.yaml              search on from that scene's design\n"
      "  extend N                       search on from the best, N evaluations\n"
      "  undo                           the last act that isn't undone\n"
      "Examples:\n"
      "  delos optimize scenes/09-camera-room.yaml --study room.study\n"
      "  delos study room.study lock 'devices.ceiling*'\n"
      "  delos study room.study forbid 0,3,2 1,5,3\n"
      "  delos study room.study resume\n"
      "  delos study room.study best best.yaml\n"
      "  delos study room.study consensus         where the best layouts agree");
  app->callback([command, &exit_code] { exit_code = run(*command); });
}

}  // namespace delos::cli
