// delos noise: the noise of a light sensor from its electronics.
#include <cmath>
#include <iostream>
#include <memory>
#include <numbers>

#include "command.h"
#include "delos/text/format.h"
#include "json.h"
#include "quantity.h"
#include "session/readings_json.h"
#include "summary.h"

namespace delos::cli {
namespace {

struct NoiseCommand {
  std::vector<std::string> windows = {"100 us"};
  std::string feedback = "200 kohm", interelectrode = "7.5 kohm";
  double voltage = 4.5e-9, current = 6e-13;
  std::string voltage_corner, current_corner, temperature = "300 K",
                                              bandwidth = "160 kHz", gap = "20 us";
  std::string photocurrent;
  double x = 0, readings = 1;
  bool json = false;
};

void print(std::ostream& out, const session::NoiseAnswer& answer) {
  for (std::size_t i = 0; i < answer.windows.size(); ++i) {
    const readings::PositionNoise& noise = answer.noise[i];
    out << "window " << format_quantity(answer.windows[i], "s") << "\n";
    for (std::size_t end = 0; end < 2; ++end) {
      out << "  end " << end + 1 << ", " << format_quantity(noise.current[end], "A", 4)
          << ": " << format_quantity(noise.rms[end], "V", 4) << "\n";
      for (std::size_t s = 0; s < readings::kSources; ++s) {
        const readings::SourceNoise& source = noise.sources[end][s];
        out << "    " << cell(readings::kSourceNames[s], 16)
            << cell(format_quantity(source.density * 1e9, "1", 4) + " nV/√Hz", 18)
            << format_quantity(source.rms, "V", 4) << "\n";
      }
    }
    char text[120];
    std::snprintf(text, sizeof text,
                  "  X_n  %.6e where both ends add up, %.6e where their squares do\n",
                  noise.linear, noise.independent);
    out << text;
  }
  out << "in a scene: noise_over_time: {law: photodiode, at: "
      << format_quantity(answer.windows.front(), "s", 6)
      << ", bandwidth: " << format_quantity(answer.amplifier.bandwidth, "Hz", 6)
      << ", gap: " << format_quantity(answer.amplifier.gap, "s", 6) << "}\n";
}

int run(const NoiseCommand& command) {
  readings::Amplifier a;
  a.feedback = quantity_above_0(command.feedback, "ohm", "--feedback");
  a.interelectrode =
      command.interelectrode == "none"
          ? INFINITY
          : quantity_above_0(command.interelectrode, "ohm", "--interelectrode");
  a.voltage = command.voltage;
  a.current = command.current;
  a.voltage_corner = quantity_from_0(command.voltage_corner, "Hz", "--voltage-corner");
  a.current_corner = quantity_from_0(command.current_corner, "Hz", "--current-corner");
  a.temperature = quantity_from_0(command.temperature, "K", "--temperature");
  a.bandwidth = quantity_above_0(command.bandwidth, "Hz", "--bandwidth");
  a.gap = quantity_from_0(command.gap, "s", "--gap");
  const double current = quantity_above_0(command.photocurrent, "A", "--current");
  std::vector<double> windows;
  for (const std::string& text : command.windows)
    windows.push_back(quantity_above_0(text, "s", "--window"));
  for (const double window : windows)
    if (a.gap > 1e4 * window)
      throw Failure{kUsage, "--gap must not be above 10,000 windows"};
  const session::NoiseAnswer answer =
      session::answer_noise(a, current, command.x, command.readings, windows);
  if (command.json)
    print_document(session::noise_json(answer));
  else
    print(std::cout, answer);
  return kDone;
}

}  // namespace

void add_noise_command(CLI::App& program, int& exit_code) {
  auto command = std::make_shared<NoiseCommand>();
  CLI::App* app = program.add_subcommand(
      "noise", "A light sensor's noise from its electronics, each source by itself");
  app->add_option("--current", command->photocurrent,
                  "Photocurrent of both ends together, such as '1.2 uA'")
      ->required();
  app->add_option("--at", command->x, "Where the light is, from end to end -1 to 1")
      ->check(CLI::Range(-1.0, 1.0))
      ->capture_default_str();
  app->add_option("--window", command->windows,
                  "Of light, and then of darkness; repeatable")
      ->allow_extra_args(false)
      ->capture_default_str();
  app->add_option("--average", command->readings, "Readings that are averaged")
      ->check(CLI::Range(1.0, 1e9))
      ->capture_default_str();
  app->add_option("--feedback", command->feedback, "rf of the amplifiers")
      ->capture_default_str();
  app->add_option("--interelectrode", command->interelectrode,
                  "Rie between the ends, or none")
      ->capture_default_str();
  app->add_option("--voltage-noise", command->voltage, "vn, V/√Hz")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app->add_option("--voltage-corner", command->voltage_corner,
                  "Below which vn² grows as 1/f; default: none");
  app->add_option("--current-noise", command->current, "in, A/√Hz")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app->add_option("--current-corner", command->current_corner, "Likewise of in");
  app->add_option("--temperature", command->temperature, "Of the resistances")
      ->capture_default_str();
  app->add_option("--bandwidth", command->bandwidth, "f0 of a one-pole filter")
      ->capture_default_str();
  app->add_option("--gap", command->gap, "From the light to the dark window")
      ->capture_default_str();
  app->add_flag("--json", command->json, "JSON on stdout");
  app->footer(
      "Examples:\n"
      "  delos noise --current '298 nA' --at 0.5\n"
      "  delos noise --current '5.36 uA' --at 0.5 --window '21 us' --window '630 us'\n"
      "  delos noise --current '1 uA' --interelectrode none --voltage-corner '100 Hz'");
  app->callback([command, &exit_code] { exit_code = run(*command); });
}

}  // namespace delos::cli
