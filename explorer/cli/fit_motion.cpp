// delos fit-motion: a motion model from a recording.
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <memory>

#include "command.h"
#include "delos/text/format.h"
#include "delos/text/units.h"
#include "delos/text/words.h"
#include "figures/chart.h"
#include "json.h"
#include "quantity.h"
#include "session/motion_json.h"
#include "session/written_field.h"
#include "summary.h"

namespace delos::cli {
namespace {

using motion::ChainFit;
using motion::Edge;
using motion::MotionFit;
using motion::OrderFit;
using motion::Segment;
using recordings::Recording;

constexpr const char* kShort[motion::kOrders] = {"P", "PV", "PVA"};
using recordings::Track;

struct FitMotionCommand {
  std::filesystem::path file, out;
  std::string marker, rate, unit, interval, from, to;
  bool segments = false, json = false;
};

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
  const double best = fit.orders[static_cast<std::size_t>(fit.likeliest)].bayes;
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
  else if (fit.best != fit.likeliest)
    out << "What the likeliest leaves isn't white; what "
        << motion::type_of_order(fit.best + 1) << " leaves is.\n";
  if (fit.still) out << "The target doesn't move beyond the noise.\n";
  out << motion::motion_block(fit, source);
}

const char* verdict(const MotionFit& fit) {
  return fit.still ? "still" : fit.fits ? "fits" : "none fits";
}

void print(std::ostream& out, const std::vector<Segment>& segments,
           const std::string& source) {
  for (const Segment& s : segments) {
    const OrderFit& best = s.fit.orders[static_cast<std::size_t>(s.fit.best)];
    out << cell(format_quantity(s.from, "s") + " to " + format_quantity(s.to, "s"), 20)
        << cell(motion::type_of_order(s.fit.best + 1), 32) << verdict(s.fit)
        << ", whiteness p = " << std::setprecision(2) << best.p_value << "\n";
  }
  out << motion::motions_block(segments, source);
}

/// A page with the way along each axis, cut where the motion changes.
std::string page_of(const Track& track, double period,
                    const std::vector<Segment>& segments, const std::string& source) {
  figures::Chart chart;
  chart.says = "where '" + track.name + "' was, along each axis";
  chart.x_name = "time";
  chart.x_unit = "s";
  chart.y_name = "from its first place";
  chart.y_unit = "m";
  // A curve shows no more points than this.
  constexpr Eigen::Index kMost = 3000;
  const Eigen::Index stride = std::max<Eigen::Index>(1, track.at.rows() / kMost);
  const double from = segments.front().from, to = segments.back().to;
  for (int axis = 0; axis < 3; ++axis) {
    figures::Series series{std::string(1, "xyz"[axis]), figures::Stroke::curve, {}};
    double first = NAN;
    for (Eigen::Index i = 0; i < track.at.rows(); i += stride) {
      const double time = period * static_cast<double>(i), at = track.at(i, axis);
      if (time < from || time > to || std::isnan(at)) continue;
      if (std::isnan(first)) first = at;
      series.points.push_back({time, at - first});
    }
    chart.series.push_back(std::move(series));
  }
  for (const Segment& s : segments)
    chart.marks.push_back(
        {s.from, std::string(kShort[s.fit.best]) + ", " + verdict(s.fit)});
  return figures::page(source,
                       figures::chart_figure(chart, source + ", " + track.name));
}

int run(const FitMotionCommand& command) {
  recordings::ReadOptions reading;
  reading.rate = quantity_from_0(command.rate, "1/s", "--rate");
  if (!command.unit.empty())
    reading.unit = quantity_above_0("1 " + command.unit, "m", "--unit");
  Diagnostics findings;
  const auto recording = recordings::read_recording(command.file, reading, findings);
  for (const Diagnostic& d : findings) std::cerr << to_string(d) << "\n";
  if (!recording) return kDiagnostics;
  motion::FitQuestion question;
  question.interval = quantity_from_0(command.interval, "s", "--interval");
  question.from = quantity_from_0(command.from, "s", "--from");
  if (!command.to.empty()) question.to = quantity_from_0(command.to, "s", "--to");
  const Track& track = track_named(*recording, command.marker);
  const std::string source = command.file.filename().string();
  const auto write_page = [&](const std::vector<Segment>& segments) {
    if (command.out.empty()) return;
    const std::string problem =
        write_text(command.out, page_of(track, recording->period, segments, source));
    if (!problem.empty()) throw Failure{kDiagnostics, problem};
    std::cerr << "wrote " << command.out.string() << "\n";
  };
  if (command.segments) {
    const auto parts = motion::fit_segments(track, recording->period, question);
    if (const auto* problem = std::get_if<std::string>(&parts))
      throw Failure{kDiagnostics, command.file.string() + ": " + *problem};
    const auto& segments = std::get<std::vector<Segment>>(parts);
    if (command.json)
      print_document(session::segments_json(segments, source));
    else
      print(std::cout, segments, source);
    write_page(segments);
    return kDone;
  }
  const auto answer = motion::fit_motion(track, recording->period, question);
  if (const auto* problem = std::get_if<std::string>(&answer))
    throw Failure{kDiagnostics, command.file.string() + ": " + *problem};
  const auto& fit = std::get<MotionFit>(answer);
  write_page(
      {{question.from,
        question.to.value_or(recording->period * static_cast<double>(track.at.rows())),
        fit}});
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
  app->add_option("file", command->file, "Recording: .bvh, .c3d, .csv, .trc or .tum")
      ->required();
  app->add_option("--marker", command->marker, "Which track; default: the first");
  app->add_option(
      "--interval", command->interval,
      "Between updates of the device, such as '40 ms'; default: each frame");
  app->add_option("--rate", command->rate, "Frames a second of a .csv without times");
  app->add_option("--unit", command->unit,
                  "Of lengths in a file that doesn't say it, such as cm");
  app->add_option("--from", command->from,
                  "Begin so many seconds after the first frame");
  app->add_option("--to", command->to, "End so many seconds after the first frame");
  app->add_option("--out", command->out, "Write a page, .html, with a picture");
  app->add_flag("--segments", command->segments,
                "Cut it where the motion changes: a model for each part");
  app->add_flag("--json", command->json, "JSON on stdout");
  app->footer(
      "Examples:\n"
      "  delos fit-motion walk.trc --marker head --interval '20 ms'\n"
      "  delos fit-motion dance.bvh --unit cm --marker LeftHand --segments\n"
      "  delos fit-motion hand.csv --from '50 s' --json");
  app->callback([command, &exit_code] { exit_code = run(*command); });
}

}  // namespace delos::cli
