#include "scene/without_sight_keys.h"

#include "document/node_text.h"
#include "scene/reading_unit.h"

namespace delos {
namespace {

using namespace shapes;
using Written = std::optional<Node>;

constexpr std::array<Key<WithoutSight>, 3> kWithoutSightKeys = {{
    member_key<&WithoutSight::probability>(
        "probability", Need::required,
        "how often a reading comes through what stands in its way, 0 to 1",
        number("1", between(0, 1))),
    {"sigma", Need::optional,
     "standard deviation that its noise then has besides, in the reading's unit",
     number(nullptr, at_least(0)),
     [](Reader& r, const Place& p, WithoutSight& w) {
       const auto value = read_in_any_unit(r, p);
       if (!value) return;
       if (*value < 0) r.error(p, "is a standard deviation, which must not be below 0");
       w.sigma = *value;
     },
     [](const WithoutSight& w) -> Written {
       if (w.sigma == 0) return std::nullopt;
       return to_node(w.sigma);
     }},
    {"bias", Need::optional, "what it then is off by, in the reading's unit",
     number(nullptr),
     [](Reader& r, const Place& p, WithoutSight& w) {
       if (const auto value = read_in_any_unit(r, p)) w.bias = *value;
     },
     [](const WithoutSight& w) -> Written {
       if (w.bias == 0) return std::nullopt;
       return to_node(w.bias);
     }},
}};

}  // namespace

std::vector<KeyShape> without_sight_keys() { return keys_of<kWithoutSightKeys>(); }

void read_without_sight(Reader& reader, const Place& at, DeviceEntry& out) {
  WithoutSight read;
  if (read_map(reader, at, kWithoutSightKeys, read)) out.without_sight = read;
}

Written write_without_sight(const DeviceEntry& device) {
  if (device.without_sight == WithoutSight{}) return std::nullopt;
  return write_map(kWithoutSightKeys, device.without_sight);
}

void check_without_sight(Reader& reader, const Place& at, const DeviceEntry& entry,
                         const Device& device) {
  const Node* given = at.node().find("without_sight");
  if (!given) return;
  const auto refuse = [&](const char* problem) {
    reader.error_within(at, given->mark, "without_sight", problem);
  };
  if (entry.mount == Mount::target)
    refuse("is for a device that stands in the world");
  else if (device.span() != Span::point)
    refuse("is for a device that sees points; this one measures more of the target");
  else if (!device.shared_variance().isZero(0))
    refuse("isn't known where the points that are seen at once share noise");
  else if (!device.needs_sight())
    refuse("is for a device that something can hide from; nothing does from this one");
}

}  // namespace delos
