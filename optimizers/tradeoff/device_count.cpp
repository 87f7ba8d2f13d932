#include "tradeoff/device_count.h"

#include <algorithm>
#include <stdexcept>

namespace delos {
namespace {

/// Whether a path is about a device: "devices.NAME.…".
bool is_of(const std::string& path, const std::string& device) {
  return path.rfind("devices." + device + ".", 0) == 0;
}

void check_free(const Scene& scene, const std::string& device) {
  for (const VariableEntry& v : scene.variables)
    for (const Follower& f : v.followers)
      if (is_of(v.path, device) != is_of(f.path, device) &&
          (is_of(v.path, device) || is_of(f.path, device)))
        throw std::invalid_argument(
            v.path + " and " + f.path + " move together, so that " + device +
            " can't come or go alone; take the tie or mirror out");
}

/// The names that a constraint is about; null where it is about none.
std::vector<std::string>* devices_of(ConstraintEntry& entry) {
  return std::visit(
      [](auto& keep) -> std::vector<std::string>* {
        if constexpr (requires { keep.devices; })
          return &keep.devices;
        else
          return nullptr;
      },
      entry.what);
}

/// NAME_2, or the next that is free.
std::string free_name(const Scene& scene, const std::string& device) {
  for (int i = 2;; ++i) {
    const std::string name = device + "_" + std::to_string(i);
    const bool taken =
        std::any_of(scene.devices.begin(), scene.devices.end(),
                    [&](const DeviceEntry& other) { return other.name == name; });
    if (!taken) return name;
  }
}

std::string renamed(const std::string& path, const std::string& device,
                    const std::string& name) {
  return "devices." + name +
         path.substr(std::string("devices.").size() + device.size());
}

}  // namespace

bool has_variables(const Scene& scene, const std::string& device) {
  return std::any_of(scene.variables.begin(), scene.variables.end(),
                     [&](const VariableEntry& v) { return is_of(v.path, device); });
}

Scene without_device(Scene scene, const std::string& device) {
  check_free(scene, device);
  std::erase_if(scene.devices, [&](const DeviceEntry& d) { return d.name == device; });
  std::erase_if(scene.variables,
                [&](const VariableEntry& v) { return is_of(v.path, device); });
  std::erase(scene.objective.robust.failures, device);
  std::erase_if(scene.constraints, [&](ConstraintEntry& entry) {
    if (auto* names = devices_of(entry)) {
      std::erase(*names, device);
      return names->empty();
    }
    auto* sum = std::get_if<KeepSum>(&entry.what);
    if (!sum) return false;
    std::erase_if(sum->factors,
                  [&](const auto& factor) { return is_of(factor.first, device); });
    return sum->factors.empty();
  });
  return scene;
}

Scene with_copy(Scene scene, const std::string& device) {
  check_free(scene, device);
  const std::string name = free_name(scene, device);
  const auto own = std::find_if(scene.devices.begin(), scene.devices.end(),
                                [&](const DeviceEntry& d) { return d.name == device; });
  DeviceEntry copy = *own;
  copy.name = name;
  scene.devices.push_back(std::move(copy));

  std::vector<VariableEntry> more;
  for (VariableEntry v : scene.variables) {
    if (!is_of(v.path, device)) continue;
    v.path = renamed(v.path, device, name);
    for (Follower& f : v.followers) f.path = renamed(f.path, device, name);
    more.push_back(std::move(v));
  }
  scene.variables.insert(scene.variables.end(), more.begin(), more.end());

  const auto take_along = [&](std::vector<std::string>& names) {
    if (std::find(names.begin(), names.end(), device) != names.end())
      names.push_back(name);
  };
  take_along(scene.objective.robust.failures);
  for (ConstraintEntry& entry : scene.constraints) {
    if (auto* names = devices_of(entry)) {
      take_along(*names);
    } else if (auto* sum = std::get_if<KeepSum>(&entry.what)) {
      const auto factors = sum->factors;
      for (const auto& [path, factor] : factors)
        if (is_of(path, device))
          sum->factors.emplace_back(renamed(path, device, name), factor);
    }
  }
  return scene;
}

}  // namespace delos
