#include "scene/placement_keys.h"

#include "document/node_text.h"

namespace delos {
namespace {

constexpr std::array<const char*, 4> kQuaternion = {"w", "x", "y", "z"};

}  // namespace

void read_at(Reader& reader, const Place& at, Placement& out) {
  if (const auto v = reader.vector3(at, "m")) out.at = *v;
}

void read_aim(Reader& reader, const Place& at, Placement& out) {
  if (const auto v = reader.vector3(at, "m")) out.facing = Aim{*v};
}

// Read after `aim`; check_facing() tells where there is none.
void read_roll(Reader& reader, const Place& at, Placement& out) {
  const auto roll = reader.angle(at);
  if (auto* aim = std::get_if<Aim>(&out.facing); aim && roll) aim->roll = *roll;
}

void read_rpy(Reader& reader, const Place& at, Placement& out) {
  if (const auto v = reader.vector3(at, "rad", kAngles)) out.facing = Rpy{*v};
}

void read_quaternion(Reader& reader, const Place& at, Placement& out) {
  if (!reader.expect(at, Node::Kind::list, "four numbers [w, x, y, z]")) return;
  const auto& items = at.node().items;
  if (items.size() != kQuaternion.size()) {
    reader.error(at, "expected four numbers [w, x, y, z], not " +
                         std::to_string(items.size()) + " members");
    return;
  }
  const std::size_t before = reader.findings.errors();
  QuaternionWxyz q;
  for (std::size_t i = 0; i < items.size(); ++i)
    if (const auto value = reader.number(Place(at, kQuaternion[i], items[i]), "1"))
      q.wxyz[static_cast<Eigen::Index>(i)] = *value;
  if (reader.findings.errors() != before) return;
  if (q.wxyz.isZero(0))
    reader.error(at,
                 "has length zero, which is no orientation; identity is [1, 0, 0, 0]");
  out.facing = q;
}

std::optional<Node> write_at(const Placement& placement) {
  return vector_node(placement.at);
}

std::optional<Node> write_aim(const Placement& placement) {
  const auto* aim = std::get_if<Aim>(&placement.facing);
  if (!aim) return std::nullopt;
  return vector_node(aim->at);
}

std::optional<Node> write_roll(const Placement& placement) {
  const auto* aim = std::get_if<Aim>(&placement.facing);
  if (!aim || aim->roll == 0) return std::nullopt;
  return to_node(aim->roll);
}

std::optional<Node> write_rpy(const Placement& placement) {
  const auto* rpy = std::get_if<Rpy>(&placement.facing);
  if (!rpy) return std::nullopt;
  return vector_node(rpy->angles);
}

std::optional<Node> write_quaternion(const Placement& placement) {
  const auto* q = std::get_if<QuaternionWxyz>(&placement.facing);
  if (!q) return std::nullopt;
  return vector_node(q->wxyz);
}

void check_placement(Reader& reader, const Place& at, const Placement& placement) {
  check_facing(reader, at, placement, &placement.at);
}

void check_facing(Reader& reader, const Place& at, const Placement& placement,
                  const Eigen::Vector3d* p) {
  std::string given;
  for (const char* key : {"aim", "rpy", "quaternion_wxyz"}) {
    const Node* node = at.node().find(key);
    if (!node) continue;
    if (!given.empty())
      reader.error_within(
          at, node->mark, key,
          "the orientation is given by '" + given + "' already; keep one");
    given = key;
  }
  const Node* node = at.node().find("aim");
  if (const Node* roll = at.node().find("roll"); roll && !node)
    reader.error_within(at, roll->mark, "roll",
                        "goes with 'aim'; the roll of 'rpy' is its first angle");
  const auto* aim = std::get_if<Aim>(&placement.facing);
  if (aim && node && p && aim->at == *p)
    reader.error_within(at, node->mark, "aim",
                        p == &placement.at
                            ? "is the same point as 'at'; choose a point to look at"
                            : "is where it stands; choose a point to look at");
}

}  // namespace delos
