// delos motions: motions by name, and from words to q.
#include "motions.h"

#include <iostream>
#include <memory>

#include "delos/text/words.h"
#include "json.h"
#include "motion/motion_fit.h"
#include "quantity.h"
#include "session/motion_json.h"
#include "summary.h"

namespace delos::cli {
namespace {

struct MotionsCommand {
  std::string name, type = "position_velocity", fast, vertical, within;
  bool json = false;
};

int order_of(const std::string& type) {
  for (int order = 1; order <= motion::kOrders; ++order)
    if (type == motion::type_of_order(order)) return order;
  throw Failure{kUsage, "--type '" + type +
                            "': choose position, position_velocity or "
                            "position_velocity_acceleration"};
}

std::string q_text(const Eigen::Vector3d& q) {
  std::string text = "[";
  for (int axis = 0; axis < 3; ++axis) {
    char number[40];
    std::snprintf(number, sizeof number, "%.6g", q(axis));
    text += (axis ? ", " : "") + std::string(number);
  }
  return text + "]";
}

std::string block(const Eigen::Vector3d& q, int order, const std::string& why) {
  const int power = 2 * order - 1;
  return "motion:  # " + why + "\n  type: " + motion::type_of_order(order) +
         "\n  q: " + q_text(q) + "  # m²/s" +
         (power == 1 ? "" : "^" + std::to_string(power)) + "\n";
}

/// The motion in words, with how its q came about.
/// @throws Failure kUsage
Json in_words(const MotionsCommand& command) {
  if (command.fast.empty() || command.within.empty())
    throw Failure{kUsage,
                  "words need --speed (or --acceleration) and --changes-within, such "
                  "as --speed '1.5 m/s' --changes-within '0.5 s'"};
  const int order = order_of(command.type);
  const char* unit = order == 3 ? "m/s^2" : "m/s";
  MotionWords words{
      quantity_above_0(command.fast, unit, order == 3 ? "--acceleration" : "--speed"),
      quantity_above_0(command.within, "s", "--changes-within"), std::nullopt};
  if (!command.vertical.empty())
    words.vertical = quantity_above_0(command.vertical, unit, "--vertical");
  const Eigen::Vector3d q = q_of(words, order);
  std::string why = command.fast + ", changes within " + command.within + ": q = 2 s² ";
  why += order == 1 ? "T" : "/ T";
  why += words.vertical ? ", s² = fast² / 2, along z vertical²" : ", s² = fast² / 3";
  return {{"order", order},
          {"q", {q.x(), q.y(), q.z()}},
          {"source", why},
          {"motion", block(q, order, why)}};
}

Json json_of(const NamedMotion& named) {
  return {{"name", named.name},
          {"what", named.what},
          {"order", named.order},
          {"q", {named.q.x(), named.q.y(), named.q.z()}},
          {"source", named.source},
          {"assumed", named.assumed},
          {"motion",
           block(named.q, named.order, std::string(named.what) + "; " + named.source)}};
}

int run(const MotionsCommand& command) {
  const bool words =
      !command.fast.empty() || !command.within.empty() || !command.vertical.empty();
  Json answer;
  if (words) {
    if (!command.name.empty())
      throw Failure{kUsage, "say a motion by name or in words, not both"};
    answer = in_words(command);
  } else if (!command.name.empty()) {
    const NamedMotion* named = named_motion(command.name);
    if (!named) {
      std::vector<std::string> known;
      for (const NamedMotion& each : named_motions()) known.emplace_back(each.name);
      throw Failure{kUsage, "'" + command.name + "': there are " + joined(known)};
    }
    answer = json_of(*named);
  } else {
    answer = Json::array();
    for (const NamedMotion& each : named_motions()) answer.push_back(json_of(each));
  }
  if (command.json) {
    print_document(answer);
    return kDone;
  }
  if (answer.is_object()) {
    std::cout << answer["motion"].get<std::string>();
    return kDone;
  }
  for (const NamedMotion& each : named_motions())
    std::cout << cell(each.name, 15) << each.what << "\n"
              << cell("", 15) << motion::type_of_order(each.order) << ", q "
              << q_text(each.q) << "\n"
              << cell("", 15) << each.source << "\n";
  return kDone;
}

}  // namespace

SceneOptions with_motion(const SceneOptions& options, const Scene& scene,
                         const std::string& name) {
  SceneOptions out = options;
  std::vector<std::string> known;
  for (const MotionEntry& entry : scene.motions) {
    known.push_back(entry.name);
    if (entry.name != name) continue;
    const Override change = motion_override(entry);
    out.set.insert(out.set.begin(), change.path + "=" + change.value);
    return out;
  }
  throw Failure{kUsage, "--motion '" + name + "': " +
                            (known.empty() ? "the scene has no motions: a mapping of "
                                             "names to what motion says"
                                           : "there are " + joined(known) +
                                                 ", and all for each of them")};
}

void add_motions_command(CLI::App& program, int& exit_code) {
  auto command = std::make_shared<MotionsCommand>();
  CLI::App* app = program.add_subcommand(
      "motions", "Motions by name, and from words to q: a motion: block each");
  app->add_option("name", command->name, "One of them; default: list all");
  app->add_option("--type", command->type,
                  "Of words: position, position_velocity or "
                  "position_velocity_acceleration")
      ->capture_default_str();
  app->add_option("--speed,--acceleration", command->fast,
                  "How fast: of position_velocity_acceleration the acceleration");
  app->add_option("--vertical", command->vertical,
                  "That along z, root mean square; default: alike in all directions");
  app->add_option("--changes-within", command->within,
                  "The time in which velocity or acceleration is forgotten");
  app->add_flag("--json", command->json, "JSON on stdout");
  app->footer(
      "Examples:\n"
      "  delos motions\n"
      "  delos motions walk\n"
      "  delos motions --speed '1.5 m/s' --vertical '0.2 m/s' --changes-within "
      "'0.5 s'");
  app->callback([command, &exit_code] { exit_code = run(*command); });
}

}  // namespace delos::cli
