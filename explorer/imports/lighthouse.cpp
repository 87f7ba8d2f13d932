// Geometry of base stations as the Crazyflie's client writes it: YAML.
//
// R takes a station's axes, x out of its glass, y left, z up, to the world's:
// p_S = Rᵀ (p_W − origin). Here x is right, y down, z forward.
#include <Eigen/Geometry>

#include "imports/rig.h"

namespace delos::imports {

bool is_lighthouse(const Value& root) {
  return root.find("geos") != nullptr && root.find("geos")->kind == Value::Kind::map;
}

Rig read_lighthouse(const Value& root, const ImportOptions& options, Source& source,
                    std::vector<Pose>& sights) {
  Rig rig;
  rig.kind = "geometry of lighthouse base stations (.yaml)";
  const double unit = options.unit.value_or(1);
  const std::string system = text_or_empty(root, "systemType");
  const std::string generation = system == "1" ? "v1" : "v2";
  if (system != "1" && system != "2" && !system.empty())
    source.error(*root.find("systemType"), "'systemType' is 1 or 2");
  rig.facts.emplace_back("places in m, station to world; z up");
  rig.facts.push_back("generation " + generation +
                      (system.empty() ? ", since the file doesn't say it" : ""));
  Calibration turned;
  for (const auto& [name, station] : root.find("geos")->members) {
    const auto origin = numbers(station, "origin", 3, source);
    const auto R = rotation_in(station, "rotation", source);
    if (!origin || !R) continue;
    Eigen::Matrix3d axes;
    axes << 0, 0, 1, -1, 0, 0, 0, -1, 0;
    CalibratedCamera pose;  // for its pose alone, so that one function turns worlds
    pose.name = "station" + name;
    pose.size = pose.f = Eigen::Vector2d::Ones();
    pose.c = pose.size / 2;
    pose.X_WC = Pose{*R * axes,
                     unit * Eigen::Vector3d((*origin)[0], (*origin)[1], (*origin)[2])};
    turned.cameras.push_back(pose);
  }
  check(turned, options, source);
  for (const CalibratedCamera& station : turned.cameras) {
    RigDevice d;
    d.name = scene_name(station.name);
    d.type = "lighthouse";
    d.rate = generation == "v1" ? "30 Hz" : "50 Hz";
    d.rate_remark = "assumed";
    d.placement.at = station.X_WC->p;
    const Eigen::Quaterniond q(station.X_WC->R);
    d.placement.facing = QuaternionWxyz{{q.w(), q.x(), q.y(), q.z()}};
    d.params.emplace_back("generation", generation);
    rig.devices.push_back(std::move(d));
    sights.push_back(*station.X_WC);
  }
  for (const std::string& fact : turned.facts) rig.facts.push_back(fact);
  if (root.find("calibs"))
    rig.facts.emplace_back(
        "tilt, phase, curve, gib and ogee of single sweeps are a filter's to undo, and "
        "aren't read; without them rays are some 200 mm apart");
  rig.assumed.emplace_back("noise is that of the plugin, of one photodiode");
  return rig;
}

}  // namespace delos::imports
