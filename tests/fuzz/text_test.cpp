// Damaged texts: scenes, changes of them, quantities, tables of points and beacons.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>

#include "delos/scene/io.h"
#include "delos/text/units.h"
#include "fuzz/damage.h"

namespace delos::fuzz {
namespace {

PluginRegistry& all_plugins() {
  static PluginRegistry registry({DELOS_PLUGINS});
  return registry;
}

/// Everything that a scene can say, and no file.
const std::string kRich = R"(delos: 1
name: Rich
motion: {type: position_velocity, state: pose, q: [0.4, 0.4, 0.1, 0.1, 0.1, 0.1]}
sample:
  volume: {min: [0, 0, 0], max: [4, 3, 2 m], adaptive: {tolerance: 5 %, depth: 7}}
orientations: {rpy: [[0, 0, 0], [0, 90 deg, 0]], combine: worst}
groups: {rig: {at: [0, 0, 2], rpy: [0, 0, 30 deg]}}
markers: [[0, 0, 0.1], [0.1, 0, 0]]
surfaces:
  ceiling: {patch: {origin: [0, 0, 3], u: [0, 3, 0], v: [4, 0, 0]}}
  rail: {rail: [[0, 0, 2], [3, 0, 2], [3, 1, 2]]}
regions:
  stage: {box: {min: [1, 1, 0], max: [3, 2, 2]}}
beacons:
  top: {grid: {min: [0, 0, 2.8], max: [1, 1, 2.8], step: 0.5}, normal: [0, 0, -1]}
devices:
  - {name: c1, type: pinhole_camera, rate: 50 Hz, on: ceiling, coordinates: [0.5, 25 %],
     params: &lens {focal: 8 mm, pitch: 5 um, resolution: [1280, 1024], sigma: 0.3}}
  - {name: c2, type: pinhole_camera, rate: 50, on: rail, coordinates: 0.875,
     aim: [0, 0, 0], params: *lens}
  - {name: u1, type: uwb_range, rate: 10, group: rig, at: [1, 2, 3],
     params: {sigma: 10 cm}}
  - {name: eye, type: pinhole_camera, rate: 50, mount: target, aim: [0, 0, 1],
     beacons: top, select: nearest, count: 3, params: *lens}
occluders:
  - {name: table, box: {min: [0, 0, 0.7], max: [2, 1, 0.74]}}
  - {cylinder: {radius: 20 cm, height: 2.5, sides: 8}, at: [1, 1, 0]}
  - {sphere: {radius: 12 cm}, at: [0, 0, 1.7], mount: target}
variables: [{path: "devices.c*.params.focal", lower: 4 mm, upper: 12 mm}]
constraints: [{name: apart, spacing: 10 cm, devices: [c1, u1]}]
objective: {minimize: mean, of: eigmax}
)";

const std::vector<std::string> kYaml = {
    "- ",   ": ",     "{",  "}",      "[",   "]",        "&a ", "*a",
    "null", "~",      " m", " deg",   " %",  "\n  ",     "---", "'",
    "\"",   "!!str ", "? ", "<<: *a", "|\n", "extends: "};

std::string taken(const std::string& text, const std::vector<Override>& changes = {}) {
  Diagnostics findings;
  const auto scene = parse_scene(text, "s.yaml", changes, all_plugins(), findings);
  bool error = false;
  for (const Diagnostic& d : findings) {
    error = error || d.severity == Severity::error;
    for (const char c : to_string(d))
      if (static_cast<unsigned char>(c) < ' ') return "a finding that terminals obey";
  }
  if (scene.has_value() == error) return "neither a scene nor findings, or both";
  if (!scene) return "";
  const std::string written = write_scene(*scene);
  const auto again = parse_scene(written, "s.yaml", {}, all_plugins(), findings);
  return again == scene ? "" : "another scene when it is written and read:\n" + written;
}

TEST(FuzzText, Scenes) {
  damage("scene", {kRich}, kYaml, [](const std::string& text) { return taken(text); });
}

TEST(FuzzText, Changes) {
  const std::vector<std::string> seeds = {"devices.c1.params.focal=12 mm",
                                          "devices.*.rate=20 Hz",
                                          "motion.q.0=0.5",
                                          "sample.volume.max=[1, 2, 3]",
                                          "groups.rig.at.x=1 in",
                                          "objective={minimize: mean}"};
  std::vector<std::string> words = kYaml;
  words.insert(words.end(), {"devices.", ".params.", "*", "=", ".."});
  damage("change", seeds, words, [](const std::string& text) -> std::string {
    const auto change = parse_override(text);
    return change ? taken(kRich, {*change}) : "";
  });
}

TEST(FuzzText, Quantities) {
  const std::vector<std::string> seeds = {"50 mm",    "60 deg", "1/2 s",  "3 m^2/s^3",
                                          "2e-3 m/s", "100 Hz", "5 %",    "12 px",
                                          "1 in",     "0.4 µm", "3 rad^2"};
  damage("quantity", seeds,
         {"m", "s", "deg", "^", "/", "*", "(", ")", "µ", "kilo", "-"},
         [](const std::string& text) -> std::string {
           for (const char* unit : {"m", "rad", "1/s", "m^2/s^3", "px", "1"}) {
             const auto value = parse_quantity(text, unit);
             if (const auto* number = std::get_if<double>(&value)) {
               if (!std::isfinite(*number)) return "a number that isn't finite";
             } else if (std::get<std::string>(value).empty()) {
               return "a refusal without a reason";
             }
           }
           return "";
         });
}

/// A scene whose points, or whose beacons, come from the file that is damaged.
void damage_tables(const std::string& name, const std::string& suffix,
                   const std::vector<std::string>& seeds, bool beacons) {
  const ScratchFile file(suffix);
  std::string text = R"(delos: 1
motion: {type: position_velocity, q: [0.4, 0.4, 0.1]}
sample: {)" + (beacons ? "points: [[0, 0, 0]]" : "file: " + file.path()) +
                     "}\n";
  if (beacons) text += "beacons: {top: {file: " + file.path() + "}}\n";
  text += "devices:\n  - {name: u, type: uwb_range, rate: 9, params: {sigma: 1 cm}}\n";
  damage(name, seeds, {",", ";", "#", " ", "\n", "\r\n", "\t", "x,y,z", "\xEF\xBB\xBF"},
         [&](const std::string& rows) -> std::string {
           file.write(rows);
           return taken(text);
         });
}

TEST(FuzzText, Points) {
  damage_tables("points", ".csv",
                {"x,y,z\n0,0,0\n1,2,3\n", "# a comment\n0.5, 1e-3, -2\r\n"}, false);
  damage_tables("ptl", ".ptl", {"0 0 0\n1 2 3\n", "; a comment\n0.5 1e-3 -2\n"}, false);
}

TEST(FuzzText, Beacons) {
  damage_tables("beacons", ".csv",
                {"x,y,z\n0,0,0\n1,2,3\n", "x,y,z,nx,ny,nz\n0,0,3,0,0,-1\n"}, true);
}

}  // namespace
}  // namespace delos::fuzz
