// A scene with everything of a real room, and mesh files for it.
#pragma once

#include <fstream>
#include <string>

#include "scene/load.h"

namespace delos::test {

/// Needs no files. Its sample set is adaptive.
inline const std::string kRoom = R"(delos: 1
motion: {type: position_velocity, q: [0.4, 0.4, 0.1]}
sample:
  volume:
    min: [0, 0, 0]
    max: [4, 3, 2 m]
    adaptive: {tolerance: 5 %, depth: 7, evaluations: 200000, seconds: 0.5 min,
               near: 1 mm, within: {min: [1, 1, 0], max: [2, 2, 1]}}
orientations: {rpy: [[0, 0, 0]], combine: information}
surfaces:
  ceiling: {patch: {origin: [0, 0, 3], u: [0, 3, 0], v: [4, 0, 0]}}
  rail1: {rail: [[0, 0, 2], [3, 0, 2], [3, 1, 2]]}
regions:
  stage: {box: {min: [1, 1, 0], max: [3, 2, 2]}}
  pit: {prism: {polygon: [[0, 0], [1, 0], [0, 1]], height: 50 cm}, at: [0, 0, -0.5]}
devices:
  - {name: c1, type: probe, rate: 50, on: ceiling, coordinates: [0.5, 25 %],
     params: {r: 5 mm}}
  - {name: c2, type: probe, rate: 50, on: rail1, coordinates: 0.875,
     aim: [0, 0, 0], params: {r: 5 mm}}
occluders:
  - {name: table, box: {min: [0, 0, 0.7], max: [2, 1, 0.74]}}
  - {cylinder: {radius: 20 cm, height: 2.5, sides: 8}, at: [1, 1, 0],
     rpy: [0 deg, 0 deg, 30 deg]}
  - {sphere: {radius: 12 cm}, at: [0, 0, 1.7], mount: target}
  - {prism: {polygon: [[0, 0], [2, 0], [2, 1]], height: 1}}
skin: 2 mm
)";

/// `text` with one part exchanged.
inline std::string with(std::string text, const std::string& from,
                        const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::logic_error("the scene has no " + from);
  return text.replace(at, from.size(), to);
}

inline std::string room_with(const std::string& from, const std::string& to) {
  return with(kRoom, from, to);
}

/// A tetrahedron over the corner of the axes, closed and facing outward.
inline const std::string kTetrahedron =
    "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
/// The same without its slanted face.
inline const std::string kOpenTetrahedron =
    "OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n";

/// Loads scene texts beside files.
class RoomFolder {
 public:
  void write(const std::string& name, const std::string& text) const {
    folder_.write(name, text);
  }

  /// Findings name files without the folder.
  [[nodiscard]] Loaded load(const std::string& text,
                            const MeshProgress& progress = {}) const {
    Diagnostics diagnostics;
    Loaded loaded;
    loaded.scene = parse_scene(text, folder_.path() / "scene.yaml", {}, plugins(),
                               diagnostics, progress);
    const std::string path = folder_.path().string() + '/';
    for (const Diagnostic& d : diagnostics) {
      std::string finding = to_string(d);
      for (std::size_t at; (at = finding.find(path)) != std::string::npos;)
        finding.erase(at, path.size());
      loaded.findings.push_back(std::move(finding));
    }
    return loaded;
  }

 private:
  Folder folder_;
};

}  // namespace delos::test
