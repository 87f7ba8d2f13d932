// delos tradeoff: the best designs for many limits, or for many numbers of devices.

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>

#include "command.h"
#include "delos/text/format.h"
#include "delos/text/units.h"
#include "search_report.h"
#include "session/joined_crew.h"
#include "session/tradeoff_answer.h"
#include "summary.h"

namespace delos::cli {
namespace {

struct TradeoffCommand {
  SceneOptions options;
  OptimizeOptions search;
  std::filesystem::path scene, scenes;
  std::string limit, devices;
  std::vector<std::string> prices;
  int levels = 6;
};

/// "FROM..TO" as two texts.
std::pair<std::string, std::string> range(const std::string& text, const char* option) {
  const std::size_t dots = text.find("..");
  if (dots == std::string::npos || dots == 0 || dots + 2 == text.size())
    throw Failure{kUsage, std::string(option) + " '" + text + "': write FROM..TO"};
  return {text.substr(0, dots), text.substr(dots + 2)};
}

double quantity(const std::string& text, const std::string& unit, const char* option) {
  const auto value = parse_quantity(text, unit);
  if (const auto* problem = std::get_if<std::string>(&value))
    throw Failure{kUsage, std::string(option) + " '" + text + "': " + *problem};
  return std::get<double>(value);
}

void save(const TradeoffCommand& command, const Scene& scene, const std::string& name) {
  if (command.scenes.empty()) return;
  const std::string problem =
      save_scene(scene, command.scene.parent_path(), command.scenes / (name + ".yaml"));
  if (!problem.empty()) throw Failure{kDiagnostics, problem};
}

/// Searches done, on stderr.
SearchesDone told(const std::string& label) {
  return [label](std::size_t done, std::size_t of) {
    std::cerr << label << ": search " << done + 1 << " of " << of << "\n";
  };
}

Json front(const TradeoffCommand& command, Scene& scene, PluginRegistry& plugins) {
  const std::size_t equals = command.limit.find('=');
  if (equals == std::string::npos)
    throw Failure{kUsage, "--limit '" + command.limit +
                              "': write CONSTRAINT=FROM..TO, such as budget=2..4.4"};
  const std::string name = command.limit.substr(0, equals);
  (void)constraint_limit(scene, name);
  const std::string unit = session::limit_unit(scene, name);
  const auto [from, to] = range(command.limit.substr(equals + 1), "--limit");
  const double first = quantity(from, unit, "--limit"),
               last = quantity(to, unit, "--limit");
  std::vector<double> levels;
  for (int i = 0; i < command.levels; ++i)
    levels.push_back(command.levels == 1
                         ? first
                         : std::lerp(first, last, i / (command.levels - 1.0)));

  const std::vector<FrontPoint> points =
      search_front(scene, plugins, name, levels, command.search, told(scene.name));
  int k = 0;
  for (const FrontPoint& point : points)
    save(command, point.scene, name + "-" + std::to_string(++k));
  return session::front_json(scene, name, points, plugins);
}

Prices prices_of(const TradeoffCommand& command, const Scene& scene) {
  Prices prices;
  for (const std::string& text : command.prices) {
    const std::size_t equals = text.find('=');
    const std::string name = text.substr(0, equals);
    const bool known =
        std::any_of(scene.devices.begin(), scene.devices.end(),
                    [&](const auto& d) { return d.name == name || d.type == name; });
    if (equals == std::string::npos || !known)
      throw Failure{kUsage, "--price '" + text +
                                "': write TYPE=PRICE or DEVICE=PRICE, of the scene"};
    prices[name] = quantity(text.substr(equals + 1), "1", "--price");
  }
  return prices;
}

Json counts(const TradeoffCommand& command, const Scene& scene,
            PluginRegistry& plugins) {
  const auto [from, to] = range(command.devices, "--devices");
  const double first = quantity(from, "1", "--devices"),
               last = quantity(to, "1", "--devices");
  constexpr double kMost = 10000;
  if (!(first >= 1 && first <= last && last <= kMost) || first != std::floor(first) ||
      last != std::floor(last))
    throw Failure{kUsage, "--devices '" + command.devices +
                              "': write whole numbers FROM..TO, from 1 up"};
  const auto points = search_counts(
      scene, plugins, static_cast<std::size_t>(first), static_cast<std::size_t>(last),
      prices_of(command, scene), command.search, told(scene.name));
  for (const DeviceCountPoint& point : points)
    save(command, point.scene, "devices-" + std::to_string(point.devices));
  return session::counts_json(scene, points, plugins);
}

void print(std::ostream& out, const Json& json) {
  const std::string unit = json["objective"]["unit"];
  const auto objective = [&](const Json& point) {
    return point["objective"].is_null()
               ? std::string("none")
               : format_quantity(point["objective"].get<double>(), unit, 4);
  };
  const bool of_limit = json.contains("limit");
  out << json["scene"].get<std::string>() << "\n"
      << json["covariance"].get<std::string>() << " covariance, "
      << json["fusion"].get<std::string>() << " fusion\n"
      << cell(of_limit ? "limit" : "devices", 14)
      << cell(of_limit ? "used" : "price", 14)
      << json["objective"]["name"].get<std::string>() << "\n";
  for (const Json& point : json["points"]) {
    const std::string of = of_limit ? json["limit"]["unit"].get<std::string>() : "1";
    const auto text = [&](const char* key, const std::string& in) {
      return format_quantity(point[key].get<double>(), in, 4);
    };
    out << cell(text(of_limit ? "limit" : "devices", of), 14)
        << cell(text(of_limit ? "used" : "price", of), 14) << cell(objective(point), 12)
        << (!point["kept"].get<bool>() ? "constraints NOT kept"
            : of_limit && point["dominated"].get<bool>()
                ? "no better than a tighter limit"
                : "")
        << "\n";
  }
  if (of_limit) return;
  if (json["cheapest"].is_null())
    out << "No kit of these keeps all constraints.\n";
  else
    out << "The cheapest kit that keeps all constraints has "
        << counted(json["cheapest"]["devices"].get<std::size_t>(), "device")
        << " and costs "
        << format_quantity(json["cheapest"]["price"].get<double>(), "1") << ".\n";
}

int run(TradeoffCommand& command) {
  if (command.limit.empty() == command.devices.empty())
    throw Failure{kUsage, "delos tradeoff needs one of --limit and --devices"};
  PluginRegistry plugins(plugin_folders(command.options.plugin_dirs));
  const session::JoinedCrew crew(command.options.threads);
  if (crew.served(plugins)) return kDone;
  LoadedScene loaded = load(command.scene, command.options, plugins);
  if (!command.scenes.empty()) std::filesystem::create_directories(command.scenes);
  const Interrupt interrupt;
  command.search.threads = crew.threads();
  command.search.crew = crew.get();
  command.search.cancel = &interrupt.requested();
  Json json;
  try {
    json = command.limit.empty() ? counts(command, loaded.scene, plugins)
                                 : front(command, loaded.scene, plugins);
  } catch (const std::invalid_argument& refusal) {
    throw Failure{kDiagnostics, command.scene.string() + ": " + refusal.what()};
  } catch (const std::runtime_error& failure) {
    throw Failure{kDiagnostics, failure.what()};
  }
  if (command.options.json)
    print_document(json);
  else
    print(std::cout, json);
  if (!interrupt.requested()) return kDone;
  std::cerr << "delos: stopped; these are the best so far\n";
  return kCancelled;
}

}  // namespace

void add_tradeoff_command(CLI::App& program, int& exit_code) {
  auto command = std::make_shared<TradeoffCommand>();
  CLI::App* app = program.add_subcommand(
      "tradeoff", "The best designs for many limits, or for many numbers of devices");
  app->add_option("scene", command->scene,
                  "Scene file with variables, and an objective and constraints")
      ->required();
  app->add_option("--limit", command->limit,
                  "Front of the objective against a constraint's limit")
      ->type_name("CONSTRAINT=FROM..TO");
  app->add_option("--levels", command->levels, "Limits between FROM and TO")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app->add_option("--devices", command->devices,
                  "Numbers of devices; the cheapest kit that keeps all constraints")
      ->type_name("FROM..TO");
  app->add_option("--price", command->prices,
                  "Price of a device, or of all of a type; others cost 1; repeatable")
      ->type_name("NAME=PRICE")
      ->allow_extra_args(false);
  app->add_option("--scenes", command->scenes,
                  "Write each best scene into this folder");
  app->add_option("--starts", command->search.starts,
                  "Starts of each search; 0: 4, or 16 where a worst sample decides")
      ->check(CLI::Range(0, 10000))
      ->capture_default_str();
  app->add_option("--evaluations", command->search.evaluations,
                  "Evaluations of each search at most; 0: by the number of variables")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app->add_option("--seed", command->search.seed, "Seed of all that is random")
      ->capture_default_str();
  app->add_option("--samples", command->search.samples,
                  "Samples looked at while searching; results are judged on all")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  add_scene_options(*app, command->options);
  app->footer(
      "Each search begins at its neighbour's best design. delos report STUDY "
      "--tradeoff\n"
      "FILE.json draws what --json wrote.\n"
      "Examples:\n"
      "  delos tradeoff scenes/09-camera-room.yaml --limit apart=0.5..3 --levels 4\n"
      "  delos tradeoff scenes/09-camera-room.yaml --devices 5..9 \\\n"
      "    --price pinhole_camera=800 --json > room.json");
  app->callback([command, &exit_code] { exit_code = run(*command); });
}

}  // namespace delos::cli
