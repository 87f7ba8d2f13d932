#include "scene/motion_word_keys.h"

#include <vector>

#include "delos/model/motion_words.h"

namespace delos {

std::vector<const char*> motion_names() {
  std::vector<const char*> names;
  for (const NamedMotion& motion : named_motions()) names.push_back(motion.name);
  return names;
}

void read_named_motion(Reader& reader, const Place& at, MotionModel& out) {
  const Node& node = at.node();
  for (std::size_t i = 0; i < node.keys.size(); ++i)
    if (node.keys[i].text != "named")
      reader.error_within(at, node.keys[i].mark, node.keys[i].text,
                          "a named motion says all; leave this out, or write type and "
                          "q instead of the name");
  const Place name(at, "named", *node.find("named"));
  std::vector<std::string> known;
  for (const NamedMotion& motion : named_motions()) known.emplace_back(motion.name);
  const auto index = reader.choice(name, known);
  if (!index) return;
  const NamedMotion& motion = named_motions()[*index];
  out.layout = StateLayout{};
  out.layout.order = motion.order;
  out.dynamics = ChainMotion{CoordinateMatrix(motion.q.asDiagonal())};
}

bool has_motion_words(const Node& motion) {
  for (const char* key : {"speed", "acceleration", "vertical", "changes_within"})
    if (motion.find(key)) return true;
  return false;
}

std::optional<CoordinateMatrix> q_of_words(Reader& reader, const Place& at,
                                           const StateLayout& layout) {
  const Node& node = at.node();
  const bool third = layout.order == 3;
  const char* fast = third ? "acceleration" : "speed";
  const char* wrong = third ? "speed" : "acceleration";
  const std::size_t before = reader.findings.errors();
  if (const Node* q = node.find("q"))
    reader.error_within(at, q->mark, "q", "stands beside words that say it, too");
  if (const Node* value = node.find(wrong))
    reader.error_within(at, value->mark, wrong,
                        std::string("this type is described by ") + fast);
  for (const char* key : {fast, "changes_within"})
    if (!node.find(key))
      reader.error_within(at, node.mark, key,
                          "missing: words say how fast, and within which time that "
                          "changes");
  if (layout.pose != PoseState::position && layout.pose != PoseState::planar)
    reader.error_within(at, node.find("state")->mark, "state",
                        "words say nothing of how the target turns; give q instead");
  const auto number = [&](const char* key, const char* unit) -> std::optional<double> {
    const Node* value = node.find(key);
    if (!value) return std::nullopt;
    const auto read = reader.number(Place(at, key, *value), unit);
    if (read && !(*read > 0)) reader.error(Place(at, key, *value), "must be above 0");
    return read;
  };
  const char* unit = third ? "m/s^2" : "m/s";
  MotionWords words{number(fast, unit).value_or(0),
                    number("changes_within", "s").value_or(0),
                    number("vertical", unit)};
  if (reader.findings.errors() > before) return std::nullopt;
  // A target that stays at its height moves along the level.
  const int d = layout.coordinates();
  if (d == 2) words.vertical = words.fast;
  return CoordinateMatrix(q_of(words, layout.order).head(d).asDiagonal());
}

}  // namespace delos
