// Names and units of the state vector.
#include "delos/model/state.h"

#include <array>

namespace delos {
namespace {

/// Calls visit(derivative, coordinate) in the order of the state vector.
template <class Visit>
void for_each_chain_state(const StateLayout& layout, Visit visit) {
  for (int derivative = 0; derivative < layout.order; ++derivative)
    for (const int coordinate : estimated(layout.pose)) visit(derivative, coordinate);
}

}  // namespace

std::vector<std::string> StateLayout::names() const {
  static constexpr std::array kPrefixes{"", "v", "a"};
  static constexpr std::array kCoordinates{"x", "y", "z", "roll", "pitch", "yaw"};
  std::vector<std::string> names;
  for_each_chain_state(*this, [&](int derivative, int coordinate) {
    names.push_back(std::string(kPrefixes[derivative]) + kCoordinates[coordinate]);
  });
  names.insert(names.end(), extra.begin(), extra.end());
  return names;
}

std::vector<std::string> StateLayout::units() const {
  static constexpr std::array kSuffixes{"", "/s", "/s^2"};
  std::vector<std::string> units;
  for_each_chain_state(*this, [&](int derivative, int coordinate) {
    units.push_back(std::string(coordinate < 3 ? "m" : "rad") + kSuffixes[derivative]);
  });
  units.insert(units.end(), extra_units.begin(), extra_units.end());
  units.resize(names().size(), "1");
  return units;
}

}  // namespace delos
