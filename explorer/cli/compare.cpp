// delos compare: scenes side by side on the samples of the first.
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <limits>
#include <map>
#include <memory>
#include <regex>

#include "command.h"
#include "delos/observe/beacon_use.h"
#include "delos/output/write.h"
#include "delos/sampling/samples.h"
#include "delos/text/format.h"
#include "delos/text/units.h"
#include "evaluation.h"
#include "json.h"
#include "summary.h"

namespace delos::cli {
namespace {

struct CompareCommand {
  SceneOptions options;
  std::vector<std::string> scenes;
  std::string better_than;
  std::vector<std::filesystem::path> out;
};

/// One side of a comparison: "scene.yaml+PATH=VALUE+PATH=VALUE".
struct Side {
  std::filesystem::path file;
  std::vector<std::string> set;
};

/// A '+' begins a change where a path and '=' follow; other ones belong to a value or a
/// file's name.
Side side_of(const std::string& text) {
  static const std::regex change(R"(\+(?=[A-Za-z_][\w.]*=))");
  std::vector<std::string> parts(
      std::sregex_token_iterator(text.begin(), text.end(), change, -1), {});
  return {parts.front(), {parts.begin() + 1, parts.end()}};
}

/// What one scene of the comparison shows, in a row of the table.
struct Row {
  Field field;
  FieldStatistics statistics;
  std::optional<double> better;  ///< the part of the samples that is better than asked
  std::optional<BeaconUse> use;  ///< where devices on the target see beacons
};

/// The part of the samples outside solids whose value is better than `limit`, by volume
/// where they have weights.
double part_better(const Field& field, double limit, bool larger_is_better) {
  if (field.spread) return part_better(*field.spread, limit, larger_is_better);
  double better = 0, all = 0;
  for (std::size_t i = 0; i < field.value.size(); ++i) {
    if (!field.inside.empty() && field.inside[i]) continue;
    const double weight = field.weight.empty() ? 1 : field.weight[i];
    all += weight;
    if (!std::isfinite(field.value[i])) continue;
    if (larger_is_better ? field.value[i] > limit : field.value[i] < limit) {
      better += weight;
    }
  }
  return all > 0 ? better / all : 0;
}

/// "field.png" for the second scene, "field-3.png" for the third, …
std::filesystem::path numbered(const std::filesystem::path& file, std::size_t scene) {
  if (scene == 1) return file;
  return file.parent_path() / (file.stem().string() + "-" + std::to_string(scene + 1) +
                               file.extension().string());
}

/// Numbers over the volume where the samples are adaptive, and the difference at the
/// samples.
Comparison compared(const Field& first, const Field& second, bool larger_is_better) {
  Comparison c = compare_fields(first, second, larger_is_better);
  if (!first.spread) return c;
  Comparison by_volume =
      compare_fields(*first.spread, *second.spread, larger_is_better);
  by_volume.difference = std::move(c.difference);
  return by_volume;
}

Json to_json(const Comparison& c) {
  return {{"mean", number(c.mean)},
          {"min", number(c.min)},
          {"max", number(c.max)},
          {"improved_fraction", number(c.improved_fraction)},
          {"common", c.common}};
}

void print_rows(std::ostream& out, const std::vector<Row>& rows, double limit) {
  const std::string& unit = rows.front().field.unit;
  const auto value = [&](double v) { return cell(format_quantity(v, unit), 11); };
  const bool better = rows.front().better.has_value();
  const bool beacons = std::any_of(rows.begin(), rows.end(),
                                   [](const Row& r) { return r.use.has_value(); });
  out << cell("least", 11) << cell("median", 11) << cell("95 %", 11)
      << cell("greatest", 11);
  if (better) out << cell("better than " + format_quantity(limit, unit), 22);
  if (beacons) out << cell("beacons", 9) << cell("views", 7);
  out << "observable  scene\n";
  for (const Row& row : rows) {
    const FieldStatistics& s = row.statistics;
    for (const double v : {s.min.value, s.median, s.p95, s.max.value}) {
      out << (s.finite > 0 ? value(v) : cell("none", 11));
    }
    if (better) out << cell(format_quantity(100 * *row.better, "1") + " %", 22);
    if (beacons) {
      out << cell(row.use ? format_quantity(row.use->beacons, "1") : "", 9)
          << cell(row.use ? format_quantity(row.use->views, "1") : "", 7);
    }
    out << cell(std::to_string(s.observable), 12) << row.field.scene << "\n";
  }
}

void print(std::ostream& out, const std::vector<Row>& rows,
           const std::vector<Comparison>& comparisons, double limit) {
  const std::string& unit = rows.front().field.unit;
  const auto value = [&](double v) { return format_quantity(v, unit) + " "; };
  out << rows.front().field.metric << " over " << rows.front().statistics.samples
      << " samples of " << rows.front().field.scene;
  if (const std::size_t inside = rows.front().statistics.inside; inside > 0) {
    out << "; " << inside << " inside solids left out";
  }
  out << "\n";
  print_rows(out, rows, limit);
  for (std::size_t i = 0; i < comparisons.size(); ++i) {
    const Comparison& c = comparisons[i];
    out << rows[i + 1].field.scene << " against the first: better at "
        << std::setprecision(3) << 100 * c.improved_fraction << " % of the samples";
    if (c.common > 0) {
      out << ", by " << value(c.mean) << "in the mean, from " << value(c.min) << "to "
          << format_quantity(c.max, unit);
    }
    out << "\n";
  }
}

Json to_json(const Row& row) {
  Json json = Json::parse(field_json(row.field));
  if (row.better) json["better_than"] = number(*row.better);
  if (row.use) {
    json["beacons_used"] = number(row.use->beacons);
    json["views_used"] = number(row.use->views);
    json["sightings_used"] = number(row.use->sightings);
  }
  return json;
}

/// The limit that --better-than gives, in the metric's unit; NaN where it isn't given.
double limit_of(const CompareCommand& command, const Metric& metric) {
  if (command.better_than.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto limit = parse_quantity(command.better_than, metric.unit);
  if (const auto* problem = std::get_if<std::string>(&limit)) {
    throw Failure{kUsage, "--better-than '" + command.better_than + "': " + *problem};
  }
  return std::get<double>(limit);
}

/// Scenes of one name, a design and its optimum, are told apart by their files.
void name_apart(const std::vector<std::string>& sides,
                std::vector<LoadedScene>& scenes) {
  std::map<std::string, int> count;
  for (const LoadedScene& loaded : scenes) ++count[loaded.scene.name];
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    if (count[scenes[i].scene.name] < 2) continue;
    scenes[i].scene.name += " (" + side_of(sides[i]).file.filename().string() + ")";
  }
}

std::vector<LoadedScene> load_sides(const CompareCommand& command,
                                    PluginRegistry& plugins) {
  std::vector<LoadedScene> scenes;
  for (const std::string& text : command.scenes) {
    const Side side = side_of(text);
    SceneOptions options = command.options;
    options.set.insert(options.set.end(), side.set.begin(), side.set.end());
    scenes.push_back(load(side.file, options, plugins));
    for (const std::string& change : side.set) {
      scenes.back().scene.name += " + " + change;
    }
  }
  name_apart(command.scenes, scenes);
  const Metric& metric = scenes.front().metric;
  for (std::size_t i = 1; i < scenes.size(); ++i) {
    if (scenes[i].metric.name != metric.name || scenes[i].metric.unit != metric.unit) {
      throw Failure{kUsage, command.scenes[i] + " shows " + scenes[i].metric.name +
                                " and " + command.scenes.front() + " shows " +
                                metric.name + "; choose one for all with --metric"};
    }
  }
  return scenes;
}

Row row_of(Field field, const LoadedScene& loaded, double limit,
           const SceneOptions& options) {
  Row row{std::move(field), {}, std::nullopt, std::nullopt};
  row.statistics = summarize(row.field);
  if (!std::isnan(limit)) {
    row.better = part_better(row.field, limit, loaded.metric.larger_is_better);
  }
  const auto& devices = loaded.system.devices;
  if (std::any_of(devices.begin(), devices.end(),
                  [](const PlacedDevice& d) { return d.beacons != nullptr; })) {
    row.use = beacon_use(loaded.system,
                         field_poses(row.field.samples, loaded.scene.orientations),
                         options.threads);
  }
  return row;
}

int run(const CompareCommand& command) {
  PluginRegistry plugins(plugin_folders(command.options.plugin_dirs));
  const std::vector<LoadedScene> scenes = load_sides(command, plugins);
  const Metric& metric = scenes.front().metric;
  const double limit = limit_of(command, metric);
  Samples samples = planned_samples(scenes.front().scene);
  for (const auto& file : command.out) {
    if (const std::string problem = writable(samples, file); !problem.empty()) {
      throw Failure{kUsage, problem};
    }
  }

  const Interrupt interrupt;
  std::vector<Row> rows;
  std::vector<Comparison> comparisons;
  for (const LoadedScene& scene : scenes) {
    Field field;
    if (rows.empty()) {
      field = evaluate_scene(scene, command.options, interrupt).field;
      samples = field.samples;
    } else {
      field = evaluate(scene, samples, command.options, interrupt);
      field.weight = rows.front().field.weight;
      if (const auto& spread = rows.front().field.spread; spread && !field.cancelled) {
        Field same = evaluate(scene, spread->samples, command.options, interrupt);
        same.weight = spread->weight;
        field.cancelled = same.cancelled;
        field.spread = std::make_shared<const Field>(std::move(same));
      }
    }
    if (field.cancelled) {
      std::cerr
          << "delos: stopped; a comparison needs every scene, nothing was written\n";
      return kCancelled;
    }
    rows.push_back(row_of(std::move(field), scene, limit, command.options));
    if (rows.size() == 1) continue;
    comparisons.push_back(
        compared(rows.front().field, rows.back().field, metric.larger_is_better));
  }
  PictureOptions picture;
  picture.larger_is_better = metric.larger_is_better;
  picture.change = true;
  for (std::size_t i = 0; i < comparisons.size(); ++i) {
    picture.devices = markers_of(scenes[i + 1].scene, scenes[i + 1].system);
    for (const auto& file : command.out) {
      const std::string problem =
          write_field(comparisons[i].difference, numbered(file, i + 1), picture);
      if (!problem.empty()) throw Failure{kDiagnostics, problem};
    }
  }

  if (!command.options.json) {
    print(std::cout, rows, comparisons, limit);
    return kDone;
  }
  Json json;
  json["scenes"] = Json::array();
  for (const Row& row : rows) json["scenes"].push_back(to_json(row));
  json["difference"] = to_json(comparisons.front());
  if (comparisons.size() > 1) {
    json["differences"] = Json::array();
    for (const Comparison& c : comparisons) json["differences"].push_back(to_json(c));
  }
  std::cout << json.dump(2) << "\n";
  return kDone;
}

}  // namespace

void add_compare_command(CLI::App& program, int& exit_code) {
  auto command = std::make_shared<CompareCommand>();
  CLI::App* app = program.add_subcommand(
      "compare",
      "Scenes side by side, and their differences, on the first one's samples");
  app->add_option("scenes", command->scenes,
                  "Scene files, two or more; SCENE+PATH=VALUE+… changes one of them")
      ->required()
      ->expected(2, 1000);
  add_scene_options(*app, command->options);
  app->add_option("--better-than", command->better_than,
                  "Show which part of the samples is better than this value");
  app->add_option(
         "--out", command->out,
         "Write the difference, later minus first; of a third scene to NAME-3, …")
      ->allow_extra_args(false);
  app->footer(
      "Examples:\n"
      "  delos compare scenes/02-eight-cameras.yaml scenes/03-hybrid.yaml --json\n"
      "  delos compare scenes/hiball/six-lepd.yaml scenes/hiball/four-lepd.yaml \\\n"
      "    scenes/hiball/six-lepd.yaml+beacons.ceiling.pattern=half --better-than "
      "0.25mm");
  app->callback([command, &exit_code] { exit_code = run(*command); });
}

}  // namespace delos::cli
