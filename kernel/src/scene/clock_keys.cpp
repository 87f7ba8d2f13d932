#include "scene/clock_keys.h"

#include <algorithm>

#include "delos/scene/definition.h"
#include "document/node_text.h"

namespace delos {
namespace {

using namespace shapes;

constexpr std::array<Key<ClockEntry>, 2> kClockKeys = {{
    member_key<&ClockEntry::density>(
        "density", Need::required,
        "spectral density of the noise that drives it, squared readings per second",
        number("m^2/s", at_least(0))),
    other_key<&ClockEntry::time_constant>("time_constant", Need::optional,
                                          "in which it forgets; default: a random walk",
                                          number("s", above(0))),
}};

}  // namespace

Shape clock_shape() { return map<kClockKeys>(); }

void read_clocks(Reader& reader, const Place& at, std::vector<ClockEntry>& out) {
  if (!reader.expect(at, Node::Kind::map, "a mapping of names to how they drift"))
    return;
  const Node& node = at.node();
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    ClockEntry entry;
    entry.name = reader.key_name(at, i);
    if (read_map(reader, Place(at, node.keys[i].text, node.items[i]), kClockKeys,
                 entry))
      out.push_back(std::move(entry));
  }
}

void check_clocks(Reader& reader, const Place& root, const Scene& scene) {
  const std::string problem = free_clock_problem(definition_of(scene));
  for (std::size_t i = 0; i < scene.devices.size(); ++i) {
    const DeviceEntry& device = scene.devices[i];
    const Node* given = root.node().find("devices")->items[i].find("clock");
    if (given && !problem.empty() && !clock_entry(scene, device.clock))
      reader.error_within(root, given->mark, "devices." + device.name + ".clock",
                          problem);
  }
  for (std::size_t i = 0; i < scene.clocks.size(); ++i) {
    const std::string& name = scene.clocks[i].name;
    if (std::none_of(scene.devices.begin(), scene.devices.end(),
                     [&](const DeviceEntry& device) { return device.clock == name; }))
      reader.error_within(root, root.node().find("clocks")->keys[i].mark,
                          "clocks." + name, "no device has this clock");
  }
}

Node write_clocks(const std::vector<ClockEntry>& clocks) {
  Node map;
  map.kind = Node::Kind::map;
  for (const ClockEntry& entry : clocks) {
    map.keys.push_back({entry.name, {}});
    map.items.push_back(write_map(kClockKeys, entry));
  }
  return map;
}

}  // namespace delos
