// Cameras of Human3.6M as JSON: intrinsics a camera, extrinsics a subject and a camera,
// R and t from the world to the camera, mm.
#include "delos/text/words.h"
#include "imports/formats.h"

namespace delos::imports {
namespace {

constexpr double kFromMillimetres = 1e-3;

/// The subject asked for, or the first; null, with an error, where there is none.
const std::pair<std::string, Value>* subject_of(const Value& all,
                                                const std::string& asked,
                                                Source& source) {
  std::vector<std::string> known;
  for (const auto& member : all.members) {
    if (asked.empty() || member.first == asked) return &member;
    known.push_back(member.first);
  }
  source.error(all, "has no subject '" + asked + "'; it has " + listed(known));
  return nullptr;
}

void read_human36m(const Value& root, const ImportOptions& options, Source& source,
                   Calibration& out) {
  const Value& all = *root.find("extrinsics");
  const auto* subject = subject_of(all, options.subject, source);
  if (subject == nullptr) return;
  out.facts.push_back("places in mm, world to camera; z up; those of subject '" +
                      subject->first + "', one of " +
                      std::to_string(all.members.size()) + ": --subject takes another");
  for (const auto& [name, pose] : subject->second.members) {
    CalibratedCamera c;
    c.name = name;
    c.line = pose.line;
    const Value* lens = root.find({"intrinsics", name});
    if (lens == nullptr) {
      source.error(pose, "camera '" + name + "' has no intrinsics");
      continue;
    }
    const auto R = rotation_in(pose, "R", source);
    const auto t = numbers(pose, "t", 3, source);
    const auto K = numbers(*lens, "calibration_matrix", 9, source);
    const auto k = numbers(*lens, "distortion", 5, source);
    if (!R || !t || !K || !k) continue;
    set_matrix(c, *K, *lens->find("calibration_matrix"), source);
    set_distortion(c, *k, false, *lens->find("distortion"), source);
    c.X_WC = from_world_to_camera(*R, options.unit.value_or(kFromMillimetres) *
                                          Eigen::Vector3d((*t)[0], (*t)[1], (*t)[2]));
    out.cameras.push_back(std::move(c));
  }
}

}  // namespace

const CalibrationFormat kHuman36M = {
    "cameras of Human3.6M (.json)",
    [](const Value& root) {
      const Value* poses = root.find("extrinsics");
      return poses != nullptr && poses->kind == Value::Kind::map &&
             root.find("intrinsics") != nullptr &&
             root.find("intrinsics")->kind == Value::Kind::map;
    },
    read_human36m};

}  // namespace delos::imports
