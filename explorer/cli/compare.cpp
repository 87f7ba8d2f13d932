// delos compare: scenes side by side on the samples of the first.
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "command.h"
#include "delos/model/metric_expression.h"
#include "delos/observe/beacon_use.h"
#include "delos/output/write.h"
#include "delos/sampling/samples.h"
#include "delos/scene/definition.h"
#include "delos/text/format.h"
#include "delos/text/units.h"
#include "evaluation.h"
#include "json.h"
#include "specs.h"
#include "summary.h"

namespace delos::cli {
namespace {

struct CompareCommand {
  SceneOptions options;
  std::vector<std::string> scenes;
  std::string better_than;
  std::vector<std::string> specs;
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
  constexpr std::string_view kNoStart = "0123456789.";  // of a path
  constexpr std::string_view kPath =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZ_abcdefghijklmnopqrstuvwxyz0123456789.";
  std::vector<std::string> parts(1);
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::size_t end = text.find_first_not_of(kPath, i + 1);
    const bool change = text[i] == '+' && end != std::string::npos && end > i + 1 &&
                        text[end] == '=' &&
                        kNoStart.find(text[i + 1]) == std::string_view::npos;
    if (change)
      parts.emplace_back();
    else
      parts.back() += text[i];
  }
  return {parts.front(), {parts.begin() + 1, parts.end()}};
}

/// What one scene of the comparison shows, in a row of the table.
struct Row {
  Field field;
  FieldStatistics statistics;
  std::optional<double> better;  ///< the part of the samples that is better than asked
  std::vector<MetSpec> specs;
  std::optional<BeaconUse> use;  ///< where devices on the target see beacons
};

/// "field.png" for the second scene, "field-3.png" for the third, …
std::filesystem::path numbered(const std::filesystem::path& file, std::size_t scene) {
  if (scene == 1) return file;
  return file.parent_path() / (file.stem().string() + "-" + std::to_string(scene + 1) +
                               file.extension().string());
}

/// Numbers over the volume where the samples are adaptive, and the difference at the
/// samples.
Comparison compared(const Field& first, const Field& second) {
  Comparison c = compare_fields(first, second);
  if (!first.spread) return c;
  Comparison by_volume = compare_fields(*first.spread, *second.spread);
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

/// A cell of a specification's column, which is as wide as what it says.
std::string spec_cell(const MetSpec& met, const std::string& text) {
  return cell(text, std::max<std::size_t>(met.spec.text.size(), 8) + 3);
}

void print_rows(std::ostream& out, const std::vector<Row>& rows, double limit) {
  const std::string& unit = rows.front().field.unit;
  const auto value = [&](double v) { return cell(format_quantity(v, unit), 11); };
  const bool better = rows.front().better.has_value();
  const bool beacons = std::any_of(rows.begin(), rows.end(),
                                   [](const Row& r) { return r.use.has_value(); });
  out << cell("best", 11) << cell("median", 11) << cell("95 %", 11)
      << cell("worst", 11);
  if (better) out << cell("better than " + format_quantity(limit, unit), 22);
  for (const MetSpec& met : rows.front().specs) out << spec_cell(met, met.spec.text);
  if (beacons) out << cell("beacons", 9) << cell("views", 7);
  out << "observable  scene\n";
  for (const Row& row : rows) {
    const FieldStatistics& s = row.statistics;
    for (const double v : {s.best().value, s.median, s.p95, s.worst().value}) {
      out << (s.finite > 0 ? value(v) : cell("none", 11));
    }
    if (better) out << cell(format_quantity(100 * *row.better, "1") + " %", 22);
    for (const MetSpec& met : row.specs)
      out << spec_cell(met, percent(met.share.share));
    if (beacons) {
      out << cell(row.use ? format_quantity(row.use->beacons, "1") : "", 9)
          << cell(row.use ? format_quantity(row.use->views, "1") : "", 7);
    }
    out << cell(std::to_string(s.observable), 12) << row.field.scene << "\n";
  }
}

bool evaluated_alike(const std::vector<Row>& rows) {
  return std::all_of(rows.begin(), rows.end(), [&](const Row& row) {
    return alike(row.field.definition, rows.front().field.definition);
  });
}

/// Of what covariance the values are: the same for all sides, or else a warning.
void print_definition(std::ostream& out, const std::vector<Row>& rows) {
  if (evaluated_alike(rows)) {
    out << "of the " << to_string(rows.front().field.definition) << ", for all\n";
    return;
  }
  out << "NOT ALIKE: differences are of what is computed, too\n";
  for (const Row& row : rows)
    out << "  " << row.field.scene << ": " << to_string(row.field.definition) << "\n";
  out << "  choose one for all with --fusion and --covariance\n";
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
  print_definition(out, rows);
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
  if (!row.specs.empty()) json["specs"] = specs_json(row.specs);
  if (row.use) {
    json["beacons_used"] = number(row.use->beacons);
    json["views_used"] = number(row.use->views);
    json["sightings_used"] = number(row.use->sightings);
  }
  return json;
}

/// What --better-than asks for, if anything.
std::optional<Spec> better_spec(const CompareCommand& command, const Metric& metric) {
  if (command.better_than.empty()) return std::nullopt;
  const auto limit = parse_quantity(command.better_than, metric.unit);
  if (const auto* problem = std::get_if<std::string>(&limit)) {
    throw Failure{kUsage, "--better-than '" + command.better_than + "': " + *problem};
  }
  return Spec{"", metric, metric.larger_is_better ? Relation::above : Relation::below,
              std::get<double>(limit)};
}

/// Whether a side's fusion is what the comparison is about.
bool sets_fusion(const Side& side) {
  return std::any_of(side.set.begin(), side.set.end(), [](const std::string& change) {
    return change.starts_with("fusion=");
  });
}

/// Give all sides one fusion, unless they demand different ones.
void evaluate_alike(std::vector<LoadedScene>& sides) {
  std::vector<const Scene*> scenes;
  for (const LoadedScene& side : sides) scenes.push_back(&side.scene);
  const auto fusion = common_fusion(scenes);
  if (!fusion) return;
  for (LoadedScene& side : sides)
    if (side.system.covariance != CovarianceKind::single) side.system.fusion = *fusion;
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

/// Long titles are cut: what two names have in common comes last, so that "room
/// (b.yaml)" against "room (a.yaml)" is "b.yaml − a.yaml, room".
std::string difference_title(const std::string& first, const std::string& second) {
  const std::size_t begin = first.rfind(" (");
  if (begin == std::string::npos || second.rfind(" (") != begin ||
      first.compare(0, begin, second, 0, begin) != 0 || !first.ends_with(')') ||
      !second.ends_with(')'))
    return second + " − " + first;
  const auto inner = [&](const std::string& name) {
    return name.substr(begin + 2, name.size() - begin - 3);
  };
  return inner(second) + " − " + inner(first) + ", " + first.substr(0, begin);
}

std::vector<LoadedScene> load_sides(const CompareCommand& command,
                                    PluginRegistry& plugins) {
  std::vector<LoadedScene> scenes;
  bool asked = false;
  for (const std::string& text : command.scenes) {
    const Side side = side_of(text);
    asked = asked || sets_fusion(side);
    SceneOptions options = command.options;
    options.set.insert(options.set.end(), side.set.begin(), side.set.end());
    scenes.push_back(load(side.file, options, plugins));
    for (const std::string& change : side.set) {
      scenes.back().scene.name += " + " + change;
    }
  }
  name_apart(command.scenes, scenes);
  if (!asked) evaluate_alike(scenes);
  const Metric& metric = scenes.front().metric;
  for (std::size_t i = 1; i < scenes.size(); ++i) {
    if (same_metric(scenes[i].metric, metric)) continue;
    if (scenes[i].metric.name == metric.name && scenes[i].metric.unit == metric.unit)
      throw Failure{kUsage, command.scenes[i] + " and " + command.scenes.front() +
                                " mean different things by " + metric.name +
                                "; give them one, or choose another --metric"};
    throw Failure{kUsage, command.scenes[i] + " shows " + scenes[i].metric.name +
                              " and " + command.scenes.front() + " shows " +
                              metric.name + "; choose one for all with --metric"};
  }
  return scenes;
}

Row row_of(Field field, const LoadedScene& loaded, const std::optional<Spec>& better,
           const CompareCommand& command, const Interrupt& interrupt) {
  const SceneOptions& options = command.options;
  Row row{std::move(field), {}, std::nullopt, {}, std::nullopt};
  row.statistics = summarize(row.field);
  if (better) row.better = share_meeting(row.field, *better).share;
  row.specs =
      met_specs(specs_of(command.specs, loaded), loaded, row.field, options, interrupt);
  const auto& devices = loaded.system.devices;
  if (std::any_of(devices.begin(), devices.end(),
                  [](const PlacedDevice& d) { return d.sees_beacons(); })) {
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
  const std::optional<Spec> better = better_spec(command, metric);
  const double limit = better ? better->limit : 0;
  for (const LoadedScene& scene : scenes) (void)specs_of(command.specs, scene);
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
    rows.push_back(row_of(std::move(field), scene, better, command, interrupt));
    if (rows.size() == 1) continue;
    comparisons.push_back(compared(rows.front().field, rows.back().field));
  }
  PictureOptions picture;
  picture.larger_is_better = metric.larger_is_better;
  picture.change = true;
  for (std::size_t i = 0; i < comparisons.size(); ++i) {
    picture.devices = markers_of(scenes[i + 1].scene, scenes[i + 1].system);
    comparisons[i].difference.scene =
        difference_title(scenes[0].scene.name, scenes[i + 1].scene.name);
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
  const bool same = evaluated_alike(rows);
  const Definition& definition = rows.front().field.definition;
  Json json;
  json["fusion"] = same ? Json(to_string(definition.fusion)) : Json();
  json["covariance"] = same ? Json(to_string(definition.covariance)) : Json();
  if (!same)
    std::cerr << "delos: warning: the scenes are evaluated differently; choose one for "
                 "all with --fusion and --covariance\n";
  json["scenes"] = Json::array();
  for (const Row& row : rows) json["scenes"].push_back(to_json(row));
  json["difference"] = to_json(comparisons.front());
  if (comparisons.size() > 1) {
    json["differences"] = Json::array();
    for (const Comparison& c : comparisons) json["differences"].push_back(to_json(c));
  }
  print_document(json);
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
  add_spec_option(*app, command->specs);
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
