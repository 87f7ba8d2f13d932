// delos fit-motion: a motion model from a recording.
#include <algorithm>
#include <iomanip>
#include <iostream>
#include <memory>

#include "command.h"
#include "delos/text/format.h"
#include "delos/text/units.h"
#include "delos/text/words.h"
#include "json.h"
#include "session/motion_json.h"
#include "summary.h"

namespace delos::cli {
namespace {

using motion::ChainFit;
using motion::Edge;
using motion::MotionFit;
using motion::OrderFit;
using recordings::Recording;
using recordings::Track;

struct FitMotionCommand {
  std::filesystem::path file;
  std::string marker, rate, interval, from, to;
  bool json = false;
};

/// @throws Failure kUsage
double quantity_from_0(const std::string& text, const char* unit, const char* option) {
  if (text.empty()) return 0;
  const auto value = parse_quantity(text, unit);
  if (const auto* problem = std::get_if<std::string>(&value))
    throw Failure{kUsage, std::string(option) + " '" + text + "': " + *problem};
  if (std::get<double>(value) < 0)
    throw Failure{kUsage, std::string(option) + " '" + text + "': must not be below 0"};
  return std::get<double>(value);
}

/// @throws Failure kUsage
const Track& track_named(const Recording& recording, const std::string& name) {
  if (name.empty()) return recording.tracks.front();
  for (const Track& track : recording.tracks)
    if (track.name == name) return track;
  std::vector<std::string> known;
  for (const Track& track : recording.tracks) known.push_back(track.name);
  throw Failure{kUsage, "--marker '" + name + "': there are " + joined(known)};
}

std::string interval_text(const motion::Estimate& e) {
  char text[80];
  std::snprintf(text, sizeof text, "%.3g (%.3g to %.3g)", e.value, e.low, e.high);
  return text;
}

const char* doubt_of(const ChainFit& fit) {
  switch (fit.edge) {
    case Edge::none:
      break;
    case Edge::no_noise:
      return ", noise doesn't show";
    case Edge::no_motion:
      return ", motion doesn't show";
  }
  return "";
}

void print(std::ostream& out, const MotionFit& fit, const std::string& source) {
  out << source << ", '" << fit.track << "': " << counted(fit.frames, "frame")
      << ", one every " << format_quantity(fit.dt, "s") << ", "
      << counted(fit.gaps, "gap") << "\n";
  const double best = fit.orders[static_cast<std::size_t>(fit.best)].bayes;
  for (const OrderFit& order : fit.orders) {
    out << motion::type_of_order(order.axes[0].order) << ": "
        << (order.bayes == best ? std::string("likeliest")
                                : "BIC " + format_quantity(order.bayes - best, "1", 4) +
                                      " above the likeliest")
        << ", whiteness p = " << std::setprecision(2) << order.p_value << "\n";
    for (std::size_t a = 0; a < 3; ++a) {
      const ChainFit& axis = order.axes[a];
      out << "  "
          << "xyz"[a] << "  q " << cell(interval_text(axis.q), 34) << "r "
          << cell(interval_text(axis.r), 34) << "rho1 " << std::setprecision(2)
          << axis.first_correlation << ", Ljung-Box " << std::setprecision(4)
          << axis.ljung_box << " over " << axis.lags << " lags" << doubt_of(axis)
          << "\n";
    }
  }
  if (!fit.fits)
    out << "None of them fits: what the likeliest leaves isn't white. Its q is what a "
           "filter at this interval would do best with; a longer --interval, or a part "
           "by --from and --to, may fit.\n";
  if (fit.still) out << "The target doesn't move beyond the noise.\n";
  out << motion::motion_block(fit, source);
}

int run(const FitMotionCommand& command) {
  recordings::ReadOptions reading;
  reading.rate = quantity_from_0(command.rate, "1/s", "--rate");
  Diagnostics findings;
  const auto recording = recordings::read_recording(command.file, reading, findings);
  for (const Diagnostic& d : findings) std::cerr << to_string(d) << "\n";
  if (!recording) return kDiagnostics;
  motion::FitQuestion question;
  question.interval = quantity_from_0(command.interval, "s", "--interval");
  question.from = quantity_from_0(command.from, "s", "--from");
  if (!command.to.empty()) question.to = quantity_from_0(command.to, "s", "--to");
  const Track& track = track_named(*recording, command.marker);
  const auto answer = motion::fit_motion(track, recording->period, question);
  if (const auto* problem = std::get_if<std::string>(&answer))
    throw Failure{kDiagnostics, command.file.string() + ": " + *problem};
  const auto& fit = std::get<MotionFit>(answer);
  const std::string source = command.file.filename().string();
  if (command.json) {
    print_document(session::motion_json(fit, source));
    return kDone;
  }
  print(std::cout, fit, source);
  if (recording->tracks.size() > 1 && command.marker.empty())
    std::cerr << "of " << recording->tracks.size()
              << " tracks the first; --marker NAME takes another\n";
  return kDone;
}

}  // namespace

void add_fit_motion_command(CLI::App& program, int& exit_code) {
  auto command = std::make_shared<FitMotionCommand>();
  CLI::App* app = program.add_subcommand(
      "fit-motion", "A motion model from a recording: order, q, and whether it fits");
  app->add_option("file", command->file, "Recording: .csv, .trc or .tum")->required();
  app->add_option("--marker", command->marker, "Which track; default: the first");
  app->add_option(
      "--interval", command->interval,
      "Between updates of the device, such as '40 ms'; default: each frame");
  app->add_option("--rate", command->rate, "Frames a second of a .csv without times");
  app->add_option("--from", command->from,
                  "Begin so many seconds after the first frame");
  app->add_option("--to", command->to, "End so many seconds after the first frame");
  app->add_flag("--json", command->json, "JSON on stdout");
  app->footer(
      "Examples:\n"
      "  delos fit-motion walk.trc --marker head --interval '20 ms'\n"
      "  delos fit-motion hand.csv --from '50 s' --json");
  app->callback([command, &exit_code] { exit_code = run(*command); });
}

}  // namespace delos::cli
