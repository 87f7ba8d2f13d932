// delos compare: scenes side by side on the samples of the first.
#include <iomanip>
#include <iostream>
#include <memory>

#include "command.h"
#include "delos/output/format.h"
#include "delos/output/write.h"
#include "delos/sampling/samples.h"
#include "evaluation.h"
#include "json.h"

namespace delos::cli {
namespace {

struct CompareCommand {
  SceneOptions options;
  std::vector<std::filesystem::path> scenes;
  std::vector<std::filesystem::path> out;
};

/// "field.png" for the second scene, "field-3.png" for the third, …
std::filesystem::path numbered(const std::filesystem::path& file, std::size_t scene) {
  if (scene == 1) return file;
  return file.parent_path() / (file.stem().string() + "-" + std::to_string(scene + 1) +
                               file.extension().string());
}

Json to_json(const Comparison& c) {
  return {{"mean", number(c.mean)},
          {"min", number(c.min)},
          {"max", number(c.max)},
          {"improved_fraction", number(c.improved_fraction)},
          {"common", c.common}};
}

void print(std::ostream& out, const std::vector<Field>& fields,
           const std::vector<Comparison>& comparisons) {
  const std::string& unit = fields.front().unit;
  const auto value = [&](double v) { return format_quantity(v, unit) + " "; };
  out << fields.front().metric << " over " << fields.front().samples.points.size()
      << " samples of " << fields.front().scene << "\n"
      << std::left << std::setw(44) << "scene" << std::setw(12) << "least"
      << std::setw(12) << "median" << std::setw(12) << "95 %" << std::setw(12)
      << "greatest"
      << "observable\n";
  for (const Field& f : fields) {
    const FieldStatistics s = summarize(f);
    out << std::setw(44) << f.scene.substr(0, 43) << std::setw(12) << value(s.min.value)
        << std::setw(12) << value(s.median) << std::setw(12) << value(s.p95)
        << std::setw(12) << value(s.max.value) << s.observable << "\n";
  }
  for (std::size_t i = 0; i < comparisons.size(); ++i) {
    const Comparison& c = comparisons[i];
    out << fields[i + 1].scene << " against the first: better at "
        << std::setprecision(3) << 100 * c.improved_fraction << " % of the samples";
    if (c.common > 0) {
      out << ", by " << value(c.mean) << "in the mean, from " << value(c.min) << "to "
          << format_quantity(c.max, unit);
    }
    out << "\n";
  }
}

int run(const CompareCommand& command) {
  PluginRegistry plugins(plugin_folders(command.options.plugin_dirs));
  std::vector<LoadedScene> scenes;
  for (const auto& file : command.scenes) {
    scenes.push_back(load(file, command.options, plugins));
  }
  const Metric& metric = scenes.front().metric;
  for (std::size_t i = 1; i < scenes.size(); ++i) {
    if (scenes[i].metric.name != metric.name || scenes[i].metric.unit != metric.unit) {
      throw Failure{kUsage, command.scenes[i].string() + " shows " +
                                scenes[i].metric.name + " and " +
                                command.scenes.front().string() + " shows " +
                                metric.name + "; choose one for all with --metric"};
    }
  }
  Samples samples = planned_samples(scenes.front().scene);
  for (const auto& file : command.out) {
    if (const std::string problem = writable(samples, file); !problem.empty()) {
      throw Failure{kUsage, problem};
    }
  }

  const Interrupt interrupt;
  std::vector<Field> fields;
  std::vector<Comparison> comparisons;
  for (const LoadedScene& scene : scenes) {
    if (fields.empty()) {
      fields.push_back(evaluate_scene(scene, command.options, interrupt).field);
      samples = fields.front().samples;
    } else {
      fields.push_back(evaluate(scene, samples, command.options, interrupt));
      fields.back().weight = fields.front().weight;
    }
    if (fields.back().cancelled) {
      std::cerr
          << "delos: stopped; a comparison needs every scene, nothing was written\n";
      return kCancelled;
    }
    if (fields.size() == 1) continue;
    comparisons.push_back(
        compare_fields(fields.front(), fields.back(), metric.larger_is_better));
  }
  for (std::size_t i = 0; i < comparisons.size(); ++i) {
    for (const auto& file : command.out) {
      const std::string problem =
          write_field(comparisons[i].difference, numbered(file, i + 1));
      if (!problem.empty()) throw Failure{kDiagnostics, problem};
    }
  }

  if (!command.options.json) {
    print(std::cout, fields, comparisons);
    return kDone;
  }
  Json json;
  json["scenes"] = Json::array();
  for (const Field& field : fields)
    json["scenes"].push_back(Json::parse(field_json(field)));
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
  app->add_option("scenes", command->scenes, "Scene files, two or more")
      ->required()
      ->expected(2, 1000);
  add_scene_options(*app, command->options);
  app->add_option(
         "--out", command->out,
         "Write the difference, later minus first; of a third scene to NAME-3, …")
      ->allow_extra_args(false);
  app->footer(
      "Example:\n"
      "  delos compare scenes/02-eight-cameras.yaml scenes/03-hybrid.yaml --json");
  app->callback([command, &exit_code] { exit_code = run(*command); });
}

}  // namespace delos::cli
