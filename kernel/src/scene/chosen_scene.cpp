#include <algorithm>
#include <map>
#include <set>

#include "delos/device/beacons.h"
#include "delos/scene/candidates.h"

namespace delos {
namespace {

/// What became of names: a pattern's means its chosen copies, that of a device which
/// wasn't chosen means nothing. Other names mean themselves.
class Successors {
 public:
  Successors(const CandidateScene& all, const std::vector<bool>& stays) {
    for (const CandidateSet& set : all.scene.selection.candidates)
      if (const auto* copies = std::get_if<CandidateCopies>(&set.what)) of_[copies->of];
    for (std::size_t i = 0; i < all.scene.devices.size(); ++i) {
      const DeviceEntry& device = all.scene.devices[i];
      if (!stays[i]) {
        of_[device.name];
        continue;
      }
      devices_[device.name] = &device;
      if (!all.copy_of[i].empty()) of_[all.copy_of[i]].push_back(device.name);
    }
  }

  [[nodiscard]] std::vector<std::string> of(const std::string& name) const {
    const auto found = of_.find(name);
    return found == of_.end() ? std::vector{name} : found->second;
  }

  [[nodiscard]] std::vector<std::string> of(
      const std::vector<std::string>& names) const {
    std::vector<std::string> all;
    for (const std::string& name : names)
      for (std::string& successor : of(name)) all.push_back(std::move(successor));
    return all;
  }

  /// What became of a number, given by its path; a device that has no such number is
  /// passed over.
  [[nodiscard]] std::vector<std::string> of_path(const std::string& path) const {
    constexpr std::string_view kDevices = "devices.";
    if (path.compare(0, kDevices.size(), kDevices) != 0) return {path};
    const std::size_t dot = path.find('.', kDevices.size());
    const std::string rest = path.substr(dot);
    std::vector<std::string> paths;
    for (const std::string& name :
         of(path.substr(kDevices.size(), dot - kDevices.size())))
      if (has(*devices_.at(name), rest)) paths.push_back("devices." + name + rest);
    return paths;
  }

 private:
  /// Whether a device has numbers of this kind: how it is placed decides.
  static bool has(const DeviceEntry& device, std::string_view rest) {
    const auto begins = [&](std::string_view part) { return rest.starts_with(part); };
    const auto& facing = device.placement.facing;
    if (begins(".at.")) return !device.mounting;
    if (begins(".coordinates.")) return device.mounting.has_value();
    if (begins(".aim.")) return std::holds_alternative<Aim>(facing);
    if (rest == ".roll") return std::holds_alternative<Aim>(facing);
    if (begins(".rpy.")) return std::holds_alternative<Rpy>(facing);
    if (begins(".quaternion_wxyz."))
      return std::holds_alternative<QuaternionWxyz>(facing);
    return true;
  }

  std::map<std::string, std::vector<std::string>> of_;
  std::map<std::string, const DeviceEntry*> devices_;
};

/// A variable of a pattern becomes one of each copy; so do those that follow it.
std::vector<VariableEntry> variables_of(const Scene& scene, const Successors& names) {
  std::vector<VariableEntry> variables;
  for (const VariableEntry& variable : scene.variables) {
    const std::vector<std::string> paths = names.of_path(variable.path);
    for (std::size_t i = 0; i < paths.size(); ++i) {
      VariableEntry own = variable;
      own.path = paths[i];
      own.followers.clear();
      for (const Follower& follower : variable.followers) {
        const std::vector<std::string> followers = names.of_path(follower.path);
        if (followers.size() == paths.size())
          own.followers.push_back({followers[i], follower.factor, follower.offset});
        else if (i == 0)
          for (const std::string& path : followers)
            own.followers.push_back({path, follower.factor, follower.offset});
      }
      variables.push_back(std::move(own));
    }
  }
  return variables;
}

/// @returns whether there is still something that the constraint is about
bool adapt(ConstraintEntry& entry, const Successors& names) {
  return std::visit(
      [&](auto& what) {
        if constexpr (requires { what.devices; }) {
          what.devices = names.of(what.devices);
          return !what.devices.empty();
        } else if constexpr (requires { what.factors; }) {
          std::vector<std::pair<std::string, double>> factors;
          for (const auto& [path, factor] : what.factors)
            for (std::string& own : names.of_path(path))
              factors.emplace_back(std::move(own), factor);
          what.factors = std::move(factors);
          return !what.factors.empty();
        } else {
          return true;
        }
      },
      entry.what);
}

/// The set with some of its beacons, as a list.
BeaconSet part_of(const BeaconSet& set, const std::vector<bool>& stays) {
  const std::vector<Beacon> lit = lit_beacons(set);
  BeaconList list;
  for (std::size_t b = 0; b < lit.size(); ++b) {
    if (!stays[b]) continue;
    BeaconEntry entry{lit[b].p, std::nullopt, 1};
    if (const auto* all = std::get_if<BeaconList>(&set.layout)) entry = all->entries[b];
    list.entries.push_back(entry);
  }
  BeaconSet part = set;
  part.layout = std::move(list);
  return part;
}

}  // namespace

Scene chosen_scene(const CandidateScene& all, std::span<const std::size_t> chosen) {
  const std::set<std::size_t> is_chosen(chosen.begin(), chosen.end());
  const auto stays = [&](int candidate) {
    return candidate < 0 || is_chosen.contains(static_cast<std::size_t>(candidate));
  };
  std::vector<bool> devices;
  for (const int candidate : all.of_device) devices.push_back(stays(candidate));

  Scene scene = all.scene;
  scene.selection = {};
  scene.devices.clear();
  for (std::size_t i = 0; i < devices.size(); ++i)
    if (devices[i]) scene.devices.push_back(all.scene.devices[i]);

  scene.beacons.clear();
  for (std::size_t s = 0; s < all.scene.beacons.size(); ++s) {
    std::vector<bool> lit;
    for (const int candidate : all.of_beacon[s]) lit.push_back(stays(candidate));
    const auto count = std::count(lit.begin(), lit.end(), true);
    if (count == static_cast<std::ptrdiff_t>(lit.size()))
      scene.beacons.push_back(all.scene.beacons[s]);
    else if (count > 0)
      scene.beacons.push_back(part_of(all.scene.beacons[s], lit));
  }

  const Successors names(all, devices);
  scene.variables = variables_of(all.scene, names);
  std::erase_if(scene.constraints,
                [&](ConstraintEntry& entry) { return !adapt(entry, names); });
  return scene;
}

}  // namespace delos
