// delos compare: scenes side by side on the samples of the first.
#include <algorithm>
#include <iomanip>
#include <iostream>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "command.h"
#include "delos/text/format.h"
#include "delos/text/units.h"
#include "evaluation.h"
#include "json.h"
#include "session/comparison.h"
#include "session/stored_field.h"
#include "session/written_field.h"
#include "specs.h"
#include "summary.h"

namespace delos::cli {
namespace {

using session::ComparedSide;
using session::ComparisonAnswer;

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

/// "field.png" for the second scene, "field-3.png" for the third, …
std::filesystem::path numbered(const std::filesystem::path& file, std::size_t scene) {
  if (scene == 1) return file;
  return file.parent_path() / (file.stem().string() + "-" + std::to_string(scene + 1) +
                               file.extension().string());
}

/// A cell of a specification's column, which is as wide as what it says.
std::string spec_cell(const MetSpec& met, const std::string& text) {
  return cell(text, std::max<std::size_t>(met.spec.text.size(), 8) + 3);
}

void print_rows(std::ostream& out, const std::vector<ComparedSide>& rows,
                double limit) {
  const std::string& unit = rows.front().field.unit;
  const auto value = [&](double v) { return cell(format_quantity(v, unit), 11); };
  const bool better = rows.front().better.has_value();
  const bool beacons = std::any_of(rows.begin(), rows.end(), [](const ComparedSide& r) {
    return r.use.has_value();
  });
  out << cell("best", 11) << cell("median", 11) << cell("95 %", 11)
      << cell("worst", 11);
  if (better) out << cell("better than " + format_quantity(limit, unit), 22);
  for (const MetSpec& met : rows.front().specs) out << spec_cell(met, met.spec.text);
  if (beacons) out << cell("beacons", 9) << cell("views", 7);
  out << "observable  scene\n";
  for (const ComparedSide& row : rows) {
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

/// Of what covariance the values are: the same for all sides, or else a warning.
void print_definition(std::ostream& out, const ComparisonAnswer& answer) {
  const std::vector<ComparedSide>& rows = answer.sides;
  if (evaluated_alike(answer)) {
    out << "of the " << to_string(rows.front().field.definition) << ", for all\n";
    return;
  }
  out << "NOT ALIKE: differences are of what is computed, too\n";
  for (const ComparedSide& row : rows)
    out << "  " << row.field.scene << ": " << to_string(row.field.definition) << "\n";
  out << "  choose one for all with --fusion and --covariance\n";
}

void print(std::ostream& out, const ComparisonAnswer& answer, double limit) {
  const std::vector<ComparedSide>& rows = answer.sides;
  const std::string& unit = rows.front().field.unit;
  const auto value = [&](double v) { return format_quantity(v, unit) + " "; };
  out << rows.front().field.metric << " over " << rows.front().statistics.samples
      << " samples of " << rows.front().field.scene;
  if (const std::size_t inside = rows.front().statistics.inside; inside > 0) {
    out << "; " << inside << " inside solids left out";
  }
  out << "\n";
  print_definition(out, answer);
  print_rows(out, rows, limit);
  for (std::size_t i = 0; i < answer.differences.size(); ++i) {
    const Comparison& c = answer.differences[i];
    out << rows[i + 1].field.scene << " against the first: better at "
        << std::setprecision(3) << 100 * c.improved_fraction << " % of the samples";
    if (c.common > 0) {
      out << ", by " << value(c.mean) << "in the mean, from " << value(c.min) << "to "
          << format_quantity(c.max, unit);
    }
    out << "\n";
  }
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
  if (!asked) session::evaluate_alike(scenes);
  if (const std::string no = session::incomparable(scenes, command.scenes); !no.empty())
    throw Failure{kUsage, no};
  return scenes;
}

ComparisonAnswer compared(const std::vector<LoadedScene>& scenes,
                          const session::ComparisonQuestion& question,
                          const SceneOptions& options, const Interrupt& interrupt) {
  Progress progress(scenes.front().scene.name);
  try {
    return session::compare_scenes(scenes, question,
                                   field_options(options, interrupt, progress));
  } catch (const std::invalid_argument& error) {
    throw unsolvable(options, error);
  }
}

void write_differences(ComparisonAnswer& answer,
                       const std::vector<std::vector<Marker>>& devices,
                       const std::vector<std::filesystem::path>& files) {
  const Field& first = answer.sides.front().field;
  PictureOptions picture;
  picture.larger_is_better = first.larger_is_better;
  picture.change = true;
  for (std::size_t i = 0; i < answer.differences.size(); ++i) {
    picture.devices = devices[i + 1];
    Field& difference = answer.differences[i].difference;
    difference.scene = difference_title(first.scene, answer.sides[i + 1].field.scene);
    for (const auto& file : files) {
      const std::string problem =
          write_field(difference, numbered(file, i + 1), picture);
      if (!problem.empty()) throw Failure{kDiagnostics, problem};
    }
  }
}

void check_out(const Samples& samples,
               const std::vector<std::filesystem::path>& files) {
  for (const auto& file : files)
    if (const std::string problem = writable(samples, file); !problem.empty())
      throw Failure{kUsage, problem};
}

int show(const ComparisonAnswer& answer, const CompareCommand& command, double limit) {
  if (!command.options.json) {
    print(std::cout, answer, limit);
    return kDone;
  }
  if (!evaluated_alike(answer))
    std::cerr << "delos: warning: the scenes are evaluated differently; choose one for "
                 "all with --fusion and --covariance\n";
  print_document(session::comparison_json(answer));
  return kDone;
}

/// Fields that were kept, without computing anything.
int run_stored(const CompareCommand& command) {
  if (!command.better_than.empty() || !command.specs.empty() ||
      !command.options.set.empty())
    throw Failure{kUsage,
                  "fields are compared as they are: leave --better-than, --spec and "
                  "--set out, or compare scenes"};
  std::vector<Field> fields;
  std::vector<std::vector<Marker>> devices;
  for (const std::string& file : command.scenes) {
    auto read = session::read_field(file);
    if (const auto* problem = std::get_if<std::string>(&read))
      throw Failure{kDiagnostics, *problem};
    auto& stored = std::get<session::StoredField>(read);
    fields.push_back(std::move(stored.field));
    devices.push_back(std::move(stored.devices));
  }
  check_out(fields.front().samples, command.out);
  ComparisonAnswer answer = session::compare_stored(std::move(fields));
  write_differences(answer, devices, command.out);
  return show(answer, command, 0);
}

int run(const CompareCommand& command) {
  if (std::all_of(command.scenes.begin(), command.scenes.end(),
                  [](const std::string& s) { return session::is_stored_field(s); }))
    return run_stored(command);
  PluginRegistry plugins(plugin_folders(command.options.plugin_dirs));
  const std::vector<LoadedScene> scenes = load_sides(command, plugins);
  const std::optional<Spec> better = better_spec(command, scenes.front().metric);
  for (const LoadedScene& scene : scenes) (void)asked_specs(command.specs, scene);
  check_out(planned_samples(scenes.front().scene), command.out);

  const Interrupt interrupt;
  ComparisonAnswer answer =
      compared(scenes, {better, command.specs}, command.options, interrupt);
  if (answer.cancelled) {
    std::cerr
        << "delos: stopped; a comparison needs every scene, nothing was written\n";
    return kCancelled;
  }
  std::vector<std::vector<Marker>> devices;
  for (const LoadedScene& scene : scenes)
    devices.push_back(markers_of(scene.scene, scene.system));
  write_differences(answer, devices, command.out);
  return show(answer, command, better ? better->limit : 0);
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
      "  delos compare before.field after.field --out change.png    as field --out "
      "kept "
      "them\n"
      "  delos compare scenes/hiball/six-lepd.yaml scenes/hiball/four-lepd.yaml \\\n"
      "    scenes/hiball/six-lepd.yaml+beacons.ceiling.pattern=half --better-than "
      "0.25mm");
  app->callback([command, &exit_code] { exit_code = run(*command); });
}

}  // namespace delos::cli
