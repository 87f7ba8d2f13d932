// delos shutter: an exposure in pieces, by a code.
#include <cmath>
#include <iostream>
#include <memory>

#include "command.h"
#include "delos/text/format.h"
#include "json.h"
#include "quantity.h"
#include "session/readings_json.h"
#include "summary.h"

namespace delos::cli {
namespace {

struct ShutterCommand {
  std::string code, time;
  bool json = false;
};

/// A line a quantity: of the code, of one window as long, of one of as much light.
void print(std::ostream& out, const readings::CodedWindow& coded) {
  readings::CodedWindow whole = coded, brief = coded;
  whole.open.assign(coded.open.size(), true);
  brief.open.assign(static_cast<std::size_t>(std::lround(coded.light() / coded.chop)),
                    true);
  const auto line = [&](const char* name, auto&& text_of) {
    out << cell(name, 34) << cell(text_of(coded), 14) << cell(text_of(whole), 14)
        << text_of(brief) << "\n";
  };
  const auto factor = [](double value) {
    return std::isfinite(value) ? format_quantity(value, "1", 4) : std::string("none");
  };
  out << cell("", 34) << cell("coded", 14) << cell("as long", 14) << "as much light\n";
  line("from begin to end", [](const readings::CodedWindow& w) {
    return format_quantity(w.duration(), "s", 4);
  });
  line("photon noise R, of that as long", [&](const readings::CodedWindow& w) {
    return factor(whole.light() / w.light());
  });
  line("smear of 1 m/s, deviation", [](const readings::CodedWindow& w) {
    return format_quantity(readings::spread_of(w), "m", 4);
  });
  const char* names[] = {"motion of P, q = 1", "motion of PV, q = 1",
                         "motion of PVA, q = 1"};
  for (int order = 1; order <= 3; ++order)
    line(names[order - 1], [order](const readings::CodedWindow& w) {
      char text[40];
      std::snprintf(text, sizeof text, "%.4g", readings::motion_of(w, order));
      return std::string(text) + " m²";
    });
  line("least of the spectrum", [&](const readings::CodedWindow& w) {
    return factor(readings::smear_of(w).least);
  });
  line("noise gain of undoing the smear", [&](const readings::CodedWindow& w) {
    return factor(readings::smear_of(w).noise_gain);
  });
}

int run(const ShutterCommand& command) {
  const auto open = readings::code_of(command.code);
  if (!open)
    throw Failure{kUsage,
                  "the code '" + command.code.substr(0, 60) +
                      "' must be of 0 and 1, with a 1, and 1000 digits at most"};
  const double time = quantity_above_0(command.time, "s", "--time");
  const readings::CodedWindow window{*open, time / static_cast<double>(open->size())};
  if (command.json)
    print_document(session::shutter_json(window));
  else
    print(std::cout, window);
  return kDone;
}

}  // namespace

void add_shutter_command(CLI::App& program, int& exit_code) {
  auto command = std::make_shared<ShutterCommand>();
  CLI::App* app = program.add_subcommand(
      "shutter", "An exposure in pieces by a code: noise, motion and smear");
  app->add_option("code", command->code,
                  "Of 0 and 1, a chop each: whether light comes in")
      ->required();
  app->add_option("--time", command->time,
                  "From the first chop to the last, as '10 ms'")
      ->required();
  app->add_flag("--json", command->json, "JSON on stdout");
  app->footer(
      "Example:\n"
      "  delos shutter 1010000111000001010000110011110111010111001001100111 --time "
      "'10 ms'");
  app->callback([command, &exit_code] { exit_code = run(*command); });
}

}  // namespace delos::cli
