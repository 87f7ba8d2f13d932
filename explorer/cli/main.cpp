// delos: the command line. Each command stands in a file of its own.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <exception>
#include <iostream>
#include <system_error>

#include "command.h"
#include "session/refusal.h"

namespace delos::cli {
namespace {

/// What a command prints may leave as late as here, and find the disk full.
/// @returns the exit code: what was lost wasn't done
int ended(int exit_code) {
  errno = 0;
  if (std::cout.flush()) return exit_code;
  std::cerr << "delos: the output can't be written";
  if (errno != 0) std::cerr << ": " << std::generic_category().message(errno);
  std::cerr << "\n";
  return exit_code == kDone ? kDiagnostics : exit_code;
}

int run(int argc, char** argv) {
  CLI::App program{
      "Delos computes the best accuracy that any algorithm could reach with a "
      "tracking\n"
      "system, throughout its working volume: the steady-state error covariance.",
      "delos"};
  program.set_version_flag("--version", "delos " DELOS_VERSION);
  program.require_subcommand(1);
  program.footer(
      "Examples:\n"
      "  delos demo                                   a real laboratory, with a "
      "picture\n"
      "  delos explore                                the same in the browser: drag a "
      "camera\n"
      "  delos field scenes/01-acoustic.yaml          the field and its statistics\n"
      "  delos point scenes/01-acoustic.yaml --at 0.2,0.2,0.4\n"
      "  delos optimize scenes/09-camera-room.yaml    better places for its cameras\n"
      "  delos select scenes/12-ceiling-anchors.yaml  30 of 144 spots, with a proof\n"
      "  delos devices pinhole_camera                 a device's parameters\n"
      "Exit codes: 0 done, 1 scene, plugin or output at fault, 2 usage, 3 cancelled, "
      "70 "
      "internal.");

  int exit_code = kDone;
  add_field_command(program, exit_code);
  add_show_command(program, exit_code);
  add_point_command(program, exit_code);
  add_compare_command(program, exit_code);
  add_check_command(program, exit_code);
  add_devices_command(program, exit_code);
  add_schema_command(program, exit_code);
  add_new_device_command(program, exit_code);
  add_import_command(program, exit_code);
  add_export_command(program, exit_code);
  add_optimize_command(program, exit_code);
  add_study_command(program, exit_code);
  add_select_command(program, exit_code);
  add_tradeoff_command(program, exit_code);
  add_report_command(program, exit_code);
  add_render_command(program, exit_code);
  add_sample_time_command(program, exit_code);
  add_fit_motion_command(program, exit_code);
  add_motions_command(program, exit_code);
  add_noise_command(program, exit_code);
  add_power_command(program, exit_code);
  add_shutter_command(program, exit_code);
  add_demo_command(program, exit_code);
  add_explore_command(program, exit_code);
  add_simulate_command(program, exit_code);
  add_compare_measured_command(program, exit_code);
  add_merge_command(program, exit_code);
  add_manual_command(program, exit_code);
  try {
    program.parse(argc, argv);
    return ended(exit_code);
  } catch (const CLI::ParseError& error) {
    const auto commands = program.get_subcommands({});
    const bool known =
        std::any_of(commands.begin(), commands.end(), [&](const CLI::App* command) {
          return argc > 1 && command->get_name() == argv[1];
        });
    if (argc > 1 && argv[1][0] != '-' && !known) {
      std::cerr << "delos: '" << argv[1]
                << "' is not a command; delos --help lists them\n";
      return kUsage;
    }
    return ended(program.exit(error, std::cout, std::cerr) == 0 ? kDone : kUsage);
  } catch (const Failure& failure) {
    if (!failure.message.empty()) std::cerr << "delos: " << failure.message << "\n";
    return failure.code;
  } catch (const session::Refusal& refusal) {
    std::cerr << "delos: " << refusal.what() << "\n";
    return refusal.blame() == session::Blame::scene ? kDiagnostics : kUsage;
  } catch (const DeviceFault& fault) {
    std::cerr << "delos: " << fault.what() << "\n";
    return kDiagnostics;
  } catch (const std::exception& error) {
    std::cerr << "delos: internal error: " << error.what() << "\n";
    return kInternal;
  }
}

}  // namespace
}  // namespace delos::cli

// What run() can't say ends the program.
int main(int argc, char** argv) {  // NOLINT(bugprone-exception-escape)
  return delos::cli::run(argc, argv);
}
