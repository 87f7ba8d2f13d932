// What the commands of the program share: options, scenes, exit codes.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "interrupt.h"
#include "progress.h"
#include "session/loaded_scene.h"
#include "session/refusal.h"
#include "session/scene_field.h"

namespace delos::cli {

/// How the program ends.
enum ExitCode : int {
  kDone = 0,
  kDiagnostics = 1,  ///< the scene or a plugin is at fault
  kUsage = 2,        ///< the command line is at fault
  kCancelled = 3,    ///< stopped before the end; what was reached is written
  kInternal = 70,
};

/// Thrown to end a command with a message on stderr.
struct Failure {
  ExitCode code;
  std::string message;
};

/// Options of every command that evaluates a scene.
struct SceneOptions {
  std::vector<std::string> set;
  std::vector<std::filesystem::path> plugin_dirs;
  std::string metric, solver = "auto", fusion, covariance;
  int threads = 0;
  bool json = false;
};
void add_scene_options(CLI::App& command, SceneOptions& options);

/// What these options change of a scene.
/// @throws Failure kUsage
[[nodiscard]] std::vector<Override> overrides_of(const SceneOptions& options);

using session::LoadedScene;

/// What the session makes of an option's value.
/// @throws Failure kUsage what it refuses, with the option's dashes before its name
template <class Read>
auto read_option(Read&& read) {
  try {
    return read();
  } catch (const session::Refusal& refusal) {
    throw Failure{kUsage, "--" + std::string(refusal.what())};
  }
}

/// Load, override and build; findings are appended, warnings too.
/// @returns nullopt where one of them is an error
/// @throws Failure kUsage
[[nodiscard]] std::optional<LoadedScene> load(const std::filesystem::path& file,
                                              const SceneOptions& options,
                                              PluginRegistry& plugins,
                                              Diagnostics& diagnostics);

/// The same; prints every finding to stderr.
/// @throws Failure kDiagnostics or kUsage
[[nodiscard]] LoadedScene load(const std::filesystem::path& file,
                               const SceneOptions& options, PluginRegistry& plugins);

/// What a system that the solver can't do ends with: the scene's fault, or that of a
/// forced
/// --solver.
[[nodiscard]] Failure unsolvable(const SceneOptions& options,
                                 const std::invalid_argument& error);

/// How fields are evaluated by these options.
/// @param interrupt, progress kept by reference
/// @throws Failure kUsage
[[nodiscard]] FieldOptions field_options(const SceneOptions& options,
                                         const Interrupt& interrupt,
                                         Progress& progress);

/// Evaluate with progress on stderr and a clean end at Ctrl-C. The interrupt outlives
/// the evaluation, so that writing the result isn't cut short either.
/// @throws Failure as unsolvable()
[[nodiscard]] Field evaluate(const LoadedScene& loaded, Samples samples,
                             const SceneOptions& options, const Interrupt& interrupt);

/// "1.5,2,0.3" as three numbers, each with an optional unit.
/// @throws Failure kUsage
[[nodiscard]] Eigen::Vector3d three_numbers(const std::string& text, const char* unit,
                                            const char* option);

void add_field_command(CLI::App& program, int& exit_code);
void add_show_command(CLI::App& program, int& exit_code);
void add_point_command(CLI::App& program, int& exit_code);
void add_compare_command(CLI::App& program, int& exit_code);
void add_check_command(CLI::App& program, int& exit_code);
void add_devices_command(CLI::App& program, int& exit_code);
void add_new_device_command(CLI::App& program, int& exit_code);
void add_schema_command(CLI::App& program, int& exit_code);
void add_import_command(CLI::App& program, int& exit_code);
void add_export_command(CLI::App& program, int& exit_code);
void add_optimize_command(CLI::App& program, int& exit_code);
void add_study_command(CLI::App& program, int& exit_code);
void add_select_command(CLI::App& program, int& exit_code);
void add_tradeoff_command(CLI::App& program, int& exit_code);
void add_render_command(CLI::App& program, int& exit_code);
void add_report_command(CLI::App& program, int& exit_code);
void add_demo_command(CLI::App& program, int& exit_code);
void add_sample_time_command(CLI::App& program, int& exit_code);
void add_fit_motion_command(CLI::App& program, int& exit_code);
void add_motions_command(CLI::App& program, int& exit_code);
void add_noise_command(CLI::App& program, int& exit_code);
void add_power_command(CLI::App& program, int& exit_code);
void add_shutter_command(CLI::App& program, int& exit_code);
void add_explore_command(CLI::App& program, int& exit_code);
void add_simulate_command(CLI::App& program, int& exit_code);
void add_compare_measured_command(CLI::App& program, int& exit_code);
void add_merge_command(CLI::App& program, int& exit_code);
void add_manual_command(CLI::App& program, int& exit_code);

}  // namespace delos::cli
