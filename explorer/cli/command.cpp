#include "command.h"

#include <iostream>
#include <stdexcept>
#include <utility>

#include "delos/text/units.h"
#include "progress.h"
#include "session/named.h"

namespace delos::cli {

void add_scene_options(CLI::App& command, SceneOptions& options) {
  command.add_option("--set", options.set, "Change a value: PATH=VALUE, repeatable")
      ->type_name("PATH=VALUE")
      ->allow_extra_args(false);
  command.add_option("--metric", options.metric,
                     "Metric instead of the scene's: eigmax, sigma_x, coverage, …");
  command.add_option("--fusion", options.fusion,
                     "stacked, continuous, periodic, sequential or artemis");
  command.add_option("--covariance", options.covariance, "prior, posterior or single");
  command
      .add_option("--solver", options.solver, "auto, spectral, doubling or eigenvector")
      ->capture_default_str();
  command.add_option("--threads", options.threads, "Threads; 0: one a core")
      ->check(CLI::Range(0, 4096))
      ->capture_default_str();
  command
      .add_option("--plugin-dir", options.plugin_dirs,
                  "Folder with device plugins, searched first; repeatable")
      ->allow_extra_args(false);
  command.add_flag("--json", options.json, "One JSON document on stdout, nothing else");
}

std::vector<Override> overrides_of(const SceneOptions& options) {
  std::vector<Override> overrides;
  for (const std::string& text : options.set) {
    std::optional<Override> change = parse_override(text);
    if (!change) {
      throw Failure{kUsage, "--set '" + text +
                                "': write PATH=VALUE, for example "
                                "--set devices.cam1.at.z=2.5"};
    }
    overrides.push_back(std::move(*change));
  }
  if (!options.metric.empty()) overrides.push_back({"metric", options.metric});
  if (!options.fusion.empty()) overrides.push_back({"fusion", options.fusion});
  if (!options.covariance.empty()) {
    overrides.push_back({"covariance", options.covariance});
  }
  return overrides;
}

std::optional<LoadedScene> load(const std::filesystem::path& file,
                                const SceneOptions& options, PluginRegistry& plugins,
                                Diagnostics& diagnostics) {
  std::optional<Progress> reading;
  std::filesystem::path read_now;
  const MeshProgress progress = [&](const std::filesystem::path& mesh, double part) {
    if (!reading || mesh != read_now) reading.emplace("reading " + mesh.string());
    read_now = mesh;
    reading->update(static_cast<std::size_t>(1000 * part), 1000);
  };
  return session::load(file, overrides_of(options), plugins, diagnostics, progress);
}

LoadedScene load(const std::filesystem::path& file, const SceneOptions& options,
                 PluginRegistry& plugins) {
  Diagnostics diagnostics;
  std::optional<LoadedScene> loaded = load(file, options, plugins, diagnostics);
  for (const Diagnostic& d : diagnostics) std::cerr << to_string(d) << "\n";
  if (!loaded) throw Failure{kDiagnostics, ""};
  return std::move(*loaded);
}

Failure unsolvable(const SceneOptions& options, const std::invalid_argument& error) {
  const auto* unsuitable = dynamic_cast<const UnsuitableSolver*>(&error);
  if (unsuitable)
    return {kUsage, unsuitable->problem() + "; use --solver " +
                        to_string(unsuitable->instead())};
  return {options.solver == "auto" ? kDiagnostics : kUsage, error.what()};
}

FieldOptions field_options(const SceneOptions& options, const Interrupt& interrupt,
                           Progress& progress) {
  FieldOptions all;
  all.solver = read_option([&] { return session::solver_named(options.solver); });
  all.threads = options.threads;
  all.cancel = &interrupt.requested();
  all.progress = [&progress](std::size_t done, std::size_t of) {
    progress.update(done, of);
  };
  return all;
}

Field evaluate(const LoadedScene& loaded, Samples samples, const SceneOptions& options,
               const Interrupt& interrupt) {
  Progress progress(loaded.scene.name);
  try {
    Field field =
        evaluate_field(loaded.system, std::move(samples), loaded.scene.orientations,
                       loaded.metric, field_options(options, interrupt, progress));
    field.scene = loaded.scene.name;
    return field;
  } catch (const std::invalid_argument& error) {
    throw unsolvable(options, error);
  }
}

Eigen::Vector3d three_numbers(const std::string& text, const char* unit,
                              const char* option) {
  Eigen::Vector3d numbers;
  std::size_t from = 0;
  for (int i = 0; i < 3; ++i) {
    const std::size_t comma = text.find(',', from);
    if ((comma == std::string::npos) != (i == 2)) {
      throw Failure{kUsage,
                    std::string(option) + " '" + text +
                        "': write three values with commas, for example 0.5,1,1.8"};
    }
    const auto value = parse_quantity(text.substr(from, comma - from), unit);
    if (const auto* problem = std::get_if<std::string>(&value)) {
      throw Failure{kUsage, std::string(option) + " '" + text + "': " + *problem};
    }
    numbers(i) = std::get<double>(value);
    from = comma + 1;
  }
  return numbers;
}

}  // namespace delos::cli
