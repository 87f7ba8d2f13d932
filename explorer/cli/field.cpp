// delos field: a metric over the samples of a scene.
#include <iomanip>
#include <iostream>
#include <memory>

#include "command.h"
#include "delos/text/format.h"
#include "delos/text/units.h"
#include "evaluation.h"
#include "json.h"
#include "motions.h"
#include "session/motion_fields.h"
#include "session/scene_field.h"
#include "session/written_field.h"
#include "specs.h"
#include "summary.h"
#include "warnings.h"

namespace delos::cli {
namespace {

struct FieldCommand {
  SceneOptions options;
  std::filesystem::path scene;
  std::vector<std::filesystem::path> out;
  std::vector<std::string> specs;
  bool log10 = false, verify = false;
  std::string slice, motion;
};

/// The observed order of accuracy of the scene's one sample set.
Verification verify(const LoadedScene& loaded, const SceneOptions& options,
                    const Interrupt& interrupt) {
  Progress progress(loaded.scene.name + ", verification");
  Verification v;
  if (loaded.scene.samples.size() == 1) {
    v = verify_sampling(loaded.system, loaded.scene.samples.front(),
                        loaded.scene.orientations, loaded.metric,
                        field_options(options, interrupt, progress));
  }
  if (v.resolutions.empty() && !interrupt.requested()) {
    throw Failure{kUsage,
                  "--verify needs one volume or plane of at least five samples along "
                  "each axis, or an adaptive volume"};
  }
  return v;
}

void print(std::ostream& out, const Verification& v, const std::string& unit) {
  out << "Discretisation error, root mean square:\n";
  for (const Resolution& r : v.resolutions) {
    out << "  spacing " << format_quantity(r.spacing, "m") << ", "
        << counted(r.evaluations, "evaluation") << ": "
        << format_quantity(r.error, unit) << "\n";
  }
  if (v.resolutions.empty()) return;
  out << "  observed order of accuracy " << std::setprecision(3) << v.first_order
      << ", then " << v.second_order << "\n";
}

/// The scene's motions one after another, and their envelope.
int run_all_motions(const FieldCommand& command, const LoadedScene& first,
                    PluginRegistry& plugins) {
  if (first.scene.motions.empty())
    (void)with_motion(command.options, first.scene, "all");
  if (command.verify || !command.specs.empty() || !command.out.empty())
    throw Failure{kUsage,
                  "--verify, --spec and --out are about one motion: name it instead of "
                  "all"};
  if (session::adaptive_sampling(first.scene))
    throw Failure{kUsage,
                  "each motion has an octree of its own, of which there is no "
                  "envelope: name one instead of all, or take a step instead of "
                  "adaptive"};
  const Interrupt interrupt;
  std::vector<session::MotionField> fields;
  for (const MotionEntry& entry : first.scene.motions) {
    const SceneOptions options = with_motion(command.options, first.scene, entry.name);
    const LoadedScene loaded = load(command.scene, options, plugins);
    fields.push_back({entry.name, evaluate_scene(loaded, options, interrupt).field});
  }
  const Field envelope = session::envelope_of(fields);
  if (command.options.json) {
    print_document(session::motion_fields_json(first, envelope, fields));
  } else {
    for (const session::MotionField& of : fields) {
      const FieldStatistics s = summarize(of.field);
      std::cout << cell(of.name, 15);
      if (s.finite == 0)
        std::cout << "blind everywhere\n";
      else
        std::cout << "mean " << cell(format_quantity(s.mean, of.field.unit), 10)
                  << "worst " << format_quantity(s.worst().value, of.field.unit)
                  << "\n";
    }
    std::cout << "The worst of them at each sample:\n";
    print_summary(std::cout, first, envelope);
  }
  return envelope.cancelled ? kCancelled : kDone;
}

int run(const FieldCommand& command) {
  PluginRegistry plugins(plugin_folders(command.options.plugin_dirs));
  const LoadedScene loaded = load(command.scene, command.options, plugins);
  if (command.motion == "all") return run_all_motions(command, loaded, plugins);
  if (!command.motion.empty()) {
    FieldCommand of_one = command;
    of_one.options = with_motion(command.options, loaded.scene, command.motion);
    of_one.motion.clear();
    return run(of_one);
  }
  const std::vector<Spec> specs = asked_specs(command.specs, loaded);
  const Diagnostics warnings = print_doubts(command.scene, loaded, plugins);
  const Samples samples = planned_samples(loaded.scene);
  for (const auto& file : command.out) {
    const std::string problem = drawable(loaded.scene, samples, file);
    if (!problem.empty()) {
      throw Failure{kUsage, problem};
    }
  }
  PictureOptions picture;
  picture.log10 = command.log10;
  picture.larger_is_better = loaded.metric.larger_is_better;
  picture.devices = markers_of(loaded.scene, loaded.system);
  if (!command.slice.empty()) {
    const auto z = parse_quantity(command.slice, "m");
    if (const auto* problem = std::get_if<std::string>(&z)) {
      throw Failure{kUsage, "--slice: " + *problem};
    }
    picture.slice_z = std::get<double>(z);
    picture.has_slice = true;
    if (const std::string miss =
            session::missed_by_slice(loaded.scene, samples, picture.slice_z);
        !miss.empty())
      throw Failure{kUsage, "--slice '" + command.slice + "': " + miss};
  }

  const Interrupt interrupt;
  const Evaluation evaluation = evaluate_scene(loaded, command.options, interrupt);
  const Field& field = evaluation.field;
  for (const auto& file : command.out) {
    if (const std::string problem =
            write_evaluation(evaluation, loaded.scene, file, picture);
        !problem.empty()) {
      throw Failure{kDiagnostics, problem};
    }
  }
  const Verification verification =
      command.verify ? verify(loaded, command.options, interrupt) : Verification{};
  const std::vector<MetSpec> met =
      met_specs(specs, loaded, field, command.options, interrupt);
  if (command.options.json) {
    Json json = session::field_answer(loaded, field);
    if (!warnings.empty()) json["warnings"] = diagnostics_json(warnings);
    if (!met.empty()) json["specs"] = specs_json(met);
    if (command.verify) json["verification"] = session::verification_json(verification);
    print_document(json);
  } else {
    print_summary(std::cout, loaded, field);
    print_specs(std::cout, met);
    if (evaluation.octree) print_octree(std::cout, evaluation.octree->report());
    if (command.verify) print(std::cout, verification, field.unit);
    for (const auto& file : command.out) std::cout << "wrote " << file.string() << "\n";
  }
  if (field.cancelled && evaluation.octree) {
    std::cerr << "delos: stopped; the field is complete but coarser than was asked\n";
    return kCancelled;
  }
  if (field.cancelled) {
    std::cerr << "delos: stopped after " << field.evaluated << " of "
              << samples.points.size() << " samples; the rest count as blind\n";
    return kCancelled;
  }
  return kDone;
}

}  // namespace

void add_field_command(CLI::App& program, int& exit_code) {
  auto command = std::make_shared<FieldCommand>();
  CLI::App* app = program.add_subcommand("field", "The field and its statistics");
  app->add_option("scene", command->scene, "Scene file")->required();
  add_scene_options(*app, command->options);
  app->add_option("--out", command->out,
                  "Write .vti, .vtu, .vtp, .csv, .json or .png, or .field to keep "
                  "it for delos show; repeatable")
      ->allow_extra_args(false);
  add_spec_option(*app, command->specs);
  app->add_option("--slice", command->slice,
                  "Height of the .png slice, for example 1.5 or '50 cm'");
  app->add_option("--motion", command->motion,
                  "One of the scene's motions, or all: each, and the worst of them");
  app->add_flag("--verify", command->verify,
                "Also the observed order of accuracy, from three resolutions");
  app->add_flag("--log10", command->log10, "Colours of the .png follow log10");
  app->footer(
      "Examples:\n"
      "  delos field scenes/01-acoustic.yaml --json\n"
      "  delos field scenes/05-optitrack-lab.yaml --out lab.vti --out lab.png --slice "
      "1.6\n"
      "  delos field scenes/05-optitrack-lab.yaml --spec 'coverage >= 3' --spec "
      "'eigmax <= 1 mm'\n"
      "  delos field scenes/01-acoustic.yaml --set devices.s1.at.z='90 cm' --metric "
      "sigma_z");
  app->callback([command, &exit_code] { exit_code = run(*command); });
}

}  // namespace delos::cli
