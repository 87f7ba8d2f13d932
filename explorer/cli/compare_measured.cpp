// delos compare-measured: recordings beside what is predicted.
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>

#include "command.h"
#include "delos/text/format.h"
#include "delos/text/units.h"
#include "delos/text/words.h"
#include "evaluation.h"
#include "json.h"
#include "measured/windows.h"
#include "recordings/recording.h"
#include "render/picture.h"
#include "session/measured_json.h"
#include "session/named.h"
#include "session/written_field.h"
#include "summary.h"
#include "through.h"

namespace delos::cli {
namespace {

using measured::MeasuredPath;
using measured::PosesComparison;
using measured::ReadingsComparison;

struct MeasuredCommand {
  SceneOptions options;
  std::filesystem::path scene, out;
  std::vector<std::filesystem::path> files;
  std::string of = "measured", view, skip = "0 s", filter = "extended";
  ThroughOptions surface{.method = "natural-neighbour"};
  int degree = 4;
  std::size_t window = 25;
  bool debias = false;
};

struct NamedValue {
  const char* name;
  measured::WindowValue value;
};
constexpr NamedValue kWindowValues[3] = {
    {"measured", measured::WindowValue::measured},
    {"predicted", measured::WindowValue::predicted},
    {"ratio", measured::WindowValue::ratio}};

measured::WindowValue window_value_named(const std::string& name) {
  const auto* found = std::ranges::find(kWindowValues, name, &NamedValue::name);
  if (found != std::end(kWindowValues)) return found->value;
  throw Failure{kUsage, "--of '" + name + "': choose measured, predicted or ratio"};
}

/// The scene's first orientation.
Eigen::Vector3d orientation_of(const Scene& scene) {
  const auto& turns = scene.orientations.rpy;
  return turns.empty() ? Eigen::Vector3d::Zero().eval() : turns.front();
}

/// The tracks of a recording as paths; one that is called truth is that of the others.
std::vector<MeasuredPath> paths_of(const std::filesystem::path& file) {
  Diagnostics findings;
  const auto recording = recordings::read_recording(file, {}, findings);
  for (const Diagnostic& d : findings) std::cerr << to_string(d) << "\n";
  if (!recording) throw Failure{kDiagnostics, ""};
  const recordings::Track* truth = nullptr;
  for (const recordings::Track& track : recording->tracks)
    if (track.name == "truth") truth = &track;
  std::vector<MeasuredPath> paths;
  for (const recordings::Track& track : recording->tracks) {
    if (&track == truth) continue;
    MeasuredPath path;
    path.name = recording->tracks.size() == (truth ? 2u : 1u)
                    ? file.stem().string()
                    : file.stem().string() + ", " + track.name;
    for (Eigen::Index i = 0; i < track.at.rows(); ++i) {
      if (!track.at.row(i).allFinite()) continue;
      if (truth && !truth->at.row(i).allFinite()) continue;
      path.t.push_back(static_cast<double>(i) * recording->period);
      path.p.emplace_back(track.at.row(i).transpose());
      if (truth) path.truth.emplace_back(truth->at.row(i).transpose());
    }
    paths.push_back(std::move(path));
  }
  return paths;
}

std::string ratio_text(double measured, double predicted) {
  std::ostringstream out;
  out << std::setprecision(3) << measured / predicted;
  return out.str();
}

void print_axes(std::ostream& out, const Eigen::Vector3d& measured,
                const Eigen::Vector3d& predicted, int axes) {
  for (int k = 0; k < axes; ++k)
    out << "    " << cell(std::string(1, "xyz"[k]), 6) << "scatter "
        << cell(format_quantity(measured(k), "m"), 12) << "predicted "
        << cell(format_quantity(predicted(k), "m"), 12) << "measured/predicted "
        << ratio_text(measured(k), predicted(k)) << "\n";
}

void print(std::ostream& out, const PosesComparison& answer,
           const LoadedScene& loaded) {
  const int axes = loaded.system.motion.layout.positions();
  std::size_t blind = 0;
  for (const measured::PathComparison& path : answer.paths) {
    out << "  " << path.name << ": " << counted(path.places, "place");
    if (path.bias)
      out << ", bias " << format_quantity(path.bias->head(axes).norm(), "m")
          << " along the path";
    out << "\n";
    print_axes(out, path.scatter, path.predicted, axes);
    blind += path.blind;
  }
  if (answer.paths.size() > 1) {
    out << "  all " << answer.paths.size() << " paths\n";
    print_axes(out, answer.scatter, answer.predicted, axes);
  }
  if (blind > 0)
    out << "  " << counted(blind, "place")
        << " without a finite P∞ count in no prediction\n";
}

void print(std::ostream& out, const ReadingsComparison& answer,
           const LoadedScene& loaded) {
  out << "  " << cell("device", 16) << cell("readings", 10) << cell("bias", 12)
      << cell("scatter", 12) << cell("predicted", 12)
      << "measured/predicted, correlation of neighbours\n";
  for (const measured::DeviceComparison& d : answer.devices)
    out << "  " << cell(d.name, 16) << cell(std::to_string(d.readings), 10)
        << std::setprecision(3) << cell(format_quantity(d.bias, "1"), 12)
        << cell(format_quantity(d.scatter, "1"), 12)
        << cell(format_quantity(d.predicted, "1"), 12)
        << ratio_text(d.scatter, d.predicted) << ", " << d.correlation << "\n";
  out << "  NIS " << std::setprecision(3) << answer.nis
      << " a row, expected 1; the longest gap "
      << format_quantity(answer.longest_gap, "s") << "\n";
  if (answer.dropped > 0)
    out << "  " << answer.dropped
        << " readings were of what the estimate had out of view\n";
  if (!answer.track) {
    out << "  where the target was isn't in the file: no error is known\n";
    return;
  }
  const measured::TrackComparison& t = *answer.track;
  const int axes = loaded.system.motion.layout.positions();
  out << "  the filter's places beside the truth, "
      << counted(answer.with_truth, "instant") << "\n";
  print_axes(out, t.scatter, t.predicted, axes);
  for (int k = 0; k < axes; ++k)
    out << "    " << cell(std::string(1, "xyz"[k]), 6) << "bias "
        << cell(format_quantity(t.bias(k), "m"), 12) << "filter's own σ "
        << format_quantity(t.filter(k), "m") << "\n";
  out << "  NEES " << std::setprecision(3) << t.nees << ", expected " << t.nees_expected
      << "\n";
}

/// What in recorded readings doesn't go with the scene.
void warn_of_rates(const ReadingsComparison& answer) {
  for (const measured::DeviceComparison& d : answer.devices) {
    if (d.readings == 0)
      std::cerr << "delos: " << d.name << " has no reading in the file\n";
    else if (d.rate > 0 && std::abs(d.rate / d.scene_rate - 1) > 0.1)
      std::cerr << "delos: " << d.name << " reads " << format_quantity(d.rate, "Hz")
                << " in the file, but " << format_quantity(d.scene_rate, "Hz")
                << " in the scene, of which P∞ is\n";
  }
}

std::string window_rows(const std::vector<measured::Window>& windows) {
  std::ostringstream rows;
  rows.precision(9);
  rows << "x [m],y [m],z [m],measured [m],predicted [m]\n";
  for (const measured::Window& w : windows) {
    rows << w.p.x() << "," << w.p.y() << "," << w.p.z() << "," << w.measured << ",";
    if (std::isfinite(w.predicted)) rows << w.predicted;
    rows << "\n";
  }
  return rows.str();
}

/// The surface in its room.
std::string room_picture(const MeasuredCommand& command,
                         const std::vector<measured::Window>& windows,
                         const LoadedScene& loaded) {
  render::PictureOptions picture;
  picture.view = read_option([&] { return render::view_of(command.view); });
  picture.through = through_of(command.surface, "surface");
  return read_option([&] {
    return png_of(render::render_picture(
        loaded,
        session::drawn_over(measured::window_field(
            windows, window_value_named(command.of), loaded.scene.name)),
        picture));
  });
}

void write_out(const MeasuredCommand& command,
               const std::vector<measured::Window>& windows,
               const LoadedScene& loaded) {
  if (command.out.empty()) return;
  std::string problem;
  if (command.out.extension() == ".csv") {
    problem = write_text(command.out, window_rows(windows));
  } else if (!command.view.empty()) {
    problem = write_text(command.out, room_picture(command, windows, loaded));
  } else {
    try {
      const Field field = measured::measured_surface(
          windows, window_value_named(command.of),
          through_of(command.surface, "surface").how, loaded.scene.name);
      problem = write_field(field, command.out);
    } catch (const std::invalid_argument& error) {
      problem = command.out.string() + ": " + error.what();
    }
  }
  if (!problem.empty()) throw Failure{kDiagnostics, problem};
}

int compare_places(const MeasuredCommand& command, const LoadedScene& loaded) {
  std::vector<MeasuredPath> paths;
  for (const auto& file : command.files)
    for (MeasuredPath& path : paths_of(file)) paths.push_back(std::move(path));
  const auto answer = measured::compare_poses(loaded.system, paths, command.degree,
                                              orientation_of(loaded.scene));
  if (const auto* problem = std::get_if<std::string>(&answer))
    throw Failure{kDiagnostics, *problem};
  const auto& poses = std::get<PosesComparison>(answer);
  const auto windows = measured::windows_of(poses, command.window);
  write_out(command, windows, loaded);
  if (command.options.json)
    print_document(session::measured_json(poses, windows, loaded));
  else
    print(std::cout << loaded.scene.name << ", curves of degree " << command.degree
                    << "\n",
          poses, loaded);
  return kDone;
}

int compare_read(const MeasuredCommand& command, const LoadedScene& loaded) {
  if (command.files.size() != 1) throw Failure{kUsage, "readings are of one file"};
  if (!command.out.empty())
    throw Failure{kUsage, "--out is of places, and this file has readings"};
  Diagnostics findings;
  const auto readings =
      measured::read_readings(command.files.front(), loaded.system, findings);
  for (const Diagnostic& d : findings) std::cerr << to_string(d) << "\n";
  if (!readings) return kDiagnostics;
  const auto skip = parse_quantity(command.skip, "s");
  if (const auto* problem = std::get_if<std::string>(&skip))
    throw Failure{kUsage, "--skip '" + command.skip + "': " + *problem};
  if (!readings->without_truth.empty())
    std::cerr << "delos: " << counted(readings->without_truth.size(), "reading")
              << " without the target's place count for the filter alone\n";
  const Samples samples = planned_samples(loaded.scene);
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : samples.points)
    middle += p / static_cast<double>(samples.points.size());
  const auto answer = measured::compare_readings(
      loaded.system, middle, orientation_of(loaded.scene), *readings,
      *make_filter(read_option([&] { return session::filter_named(command.filter); })),
      std::get<double>(skip), command.debias);
  if (const auto* problem = std::get_if<std::string>(&answer))
    throw Failure{kDiagnostics, *problem};
  const auto& compared = std::get<ReadingsComparison>(answer);
  warn_of_rates(compared);
  if (command.options.json)
    print_document(session::measured_json(compared, loaded));
  else
    print(std::cout << loaded.scene.name << ", "
                    << counted(readings->all.size(), "reading") << "\n",
          compared, loaded);
  return kDone;
}

int run(const MeasuredCommand& command) {
  PluginRegistry plugins(plugin_folders(command.options.plugin_dirs));
  static_cast<void>(through_of(command.surface, "surface"));
  static_cast<void>(window_value_named(command.of));
  if (!command.view.empty() && command.out.extension() != ".png")
    throw Failure{kUsage, "--view is of a picture: --out should end in .png"};
  const LoadedScene loaded = load(command.scene, command.options, plugins);
  try {
    return measured::has_readings(command.files.front())
               ? compare_read(command, loaded)
               : compare_places(command, loaded);
  } catch (const std::invalid_argument& error) {
    throw unsolvable(command.options, error);
  }
}

}  // namespace

void add_compare_measured_command(CLI::App& program, int& exit_code) {
  auto command = std::make_shared<MeasuredCommand>();
  CLI::App* app = program.add_subcommand(
      "compare-measured", "Recorded places or readings beside what is predicted");
  app->add_option("scene", command->scene, "Scene file")->required();
  app->add_option("files", command->files,
                  "Recordings of places (.csv, .trc, .tum), a path each track; or one "
                  ".csv of readings: t,device,z1,…,x,y,z")
      ->required();
  app->add_option("--degree", command->degree,
                  "Of the curve along a path that scatter is about")
      ->check(CLI::Range(0, 20))
      ->capture_default_str();
  app->add_option("--skip", command->skip,
                  "Of readings: seconds until the filter has settled")
      ->capture_default_str();
  app->add_option("--filter", command->filter,
                  "Of readings: extended, iterated, sequential or unscented")
      ->capture_default_str();
  app->add_flag("--debias", command->debias,
                "Of readings: take each device's mean off first");
  app->add_option("--out", command->out,
                  "Of places: windows as rows (.csv), or their surface (.png, .vti)");
  app->add_option("--window", command->window, "Places a window")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  add_through_options(*app, "surface", command->surface);
  app->add_option("--relief", command->surface.relief,
                  "Of that surface: lift the greatest value above the least by this")
      ->capture_default_str();
  app->add_option("--of", command->of,
                  "What the surface goes through: measured, predicted or ratio")
      ->capture_default_str();
  app->add_option("--view", command->view,
                  "The surface in its room, as delos render looks at it: corner, top, "
                  "…, or azimuth,elevation[,distance]");
  add_scene_options(*app, command->options);
  app->footer(
      "Examples:\n"
      "  delos compare-measured scenes/34-uwb-labyrinth.yaml \\\n"
      "    scenes/data/uwb-labyrinth/readings.csv --skip '5 s' --debias\n"
      "  delos compare-measured scenes/hiball/six-lepd.yaml rail1.tum rail2.tum "
      "--degree 4 --out rail.png --view 215,30 --relief '1 m'");
  app->callback([command, &exit_code] { exit_code = run(*command); });
}

}  // namespace delos::cli
