#include "session/device_worth.h"

#include <cmath>

#include "delos/layers/layers.h"

namespace delos::session {
namespace {

DeviceWorth worth_of(const Field& with, const Field& without) {
  DeviceWorth worth;
  double sum_with = 0, sum_without = 0;
  std::size_t common = 0;
  for (std::size_t i = 0; i < with.value.size(); ++i) {
    if (!with.inside.empty() && with.inside[i] != 0) continue;
    worth.lost += with.observable[i] != 0 && without.observable[i] == 0;
    if (!std::isfinite(with.value[i])) continue;
    if (!std::isfinite(without.value[i])) {
      ++worth.blinded;
      continue;
    }
    ++common;
    sum_with += with.value[i];
    sum_without += without.value[i];
  }
  const double rise = sum_without / sum_with - 1;
  worth.rise = common == 0 ? std::nan("") : with.larger_is_better ? -rise : rise;
  return worth;
}

}  // namespace

std::vector<DeviceWorth> device_worth(const LoadedScene& loaded, const Samples& samples,
                                      const FieldOptions& options) {
  const Orientations& turns = loaded.scene.orientations;
  const std::size_t count = loaded.system.devices.size();
  if (count < 2) return {};
  const InformationLayers layers(loaded.system, field_poses(samples, turns));
  const auto evaluate = [&](const InformationLayers& of) {
    return evaluate_field(of, samples, turns, loaded.metric, options);
  };
  const Field with = evaluate(layers);
  std::vector<DeviceWorth> all;
  for (std::size_t i = 0; i < count; ++i) {
    const Field without = evaluate(layers.without(i));
    if (without.cancelled) return {};
    all.push_back(worth_of(with, without));
    all.back().name = loaded.system.devices[i].name;
  }
  return all;
}

Json worth_json(const std::vector<DeviceWorth>& worth, const Samples& samples) {
  Json json{{"samples", samples.points.size()}, {"devices", Json::array()}};
  for (const DeviceWorth& w : worth)
    json["devices"].push_back({{"name", w.name},
                               {"blinded", w.blinded},
                               {"lost", w.lost},
                               {"rise", number(w.rise)}});
  return json;
}

}  // namespace delos::session
