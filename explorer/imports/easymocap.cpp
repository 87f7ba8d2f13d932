// Calibrations of EasyMocap: intri.yml with K_NAME and dist_NAME, extri.yml with R_NAME
// (Rodrigues), Rot_NAME (3×3) and T_NAME in metres, world to camera. `delos export`
// writes the same, with W_NAME, H_NAME and fisheye_NAME.
#include <fstream>
#include <iterator>

#include "imports/formats.h"

namespace delos::imports {
namespace {

std::vector<std::string> names_of(const Value& root, std::string_view prefix) {
  std::vector<std::string> names;
  for (const auto& [key, value] : root.members)
    if (key.starts_with(prefix)) names.push_back(key.substr(prefix.size()));
  return names;
}

void read_easymocap(const Value& root, const ImportOptions& options, Source& source,
                    Calibration& out) {
  const double unit = options.unit.value_or(1);
  out.facts.emplace_back("places in m, world to camera; z up");
  for (const std::string& name : names_of(root, "K_")) {
    CalibratedCamera c;
    c.name = name;
    c.line = root.find("K_" + name)->line;
    const auto K = numbers(root, "K_" + name, 9, source);
    if (K) set_matrix(c, *K, *root.find("K_" + name), source);
    const Value* bend = root.find("dist_" + name);
    if (bend == nullptr) bend = root.find("D_" + name);
    if (bend != nullptr) {
      if (const auto k = numbers_in(*bend))
        set_distortion(c, *k, text_or_empty(root, "fisheye_" + name) == "1", *bend,
                       source);
      else
        source.error(*bend, "'dist_" + name + "' must be numbers");
    }
    if (root.find("W_" + name) && root.find("H_" + name)) {
      const auto w = number(root, "W_" + name, source),
                 h = number(root, "H_" + name, source);
      if (w && h) c.size = {*w, *h};
    }
    const std::string turn = (root.find("Rot_" + name) ? "Rot_" : "R_") + name;
    const auto R = rotation_in(root, turn, source);
    const auto t = numbers(root, "T_" + name, 3, source);
    if (R && t)
      c.X_WC =
          from_world_to_camera(*R, unit * Eigen::Vector3d((*t)[0], (*t)[1], (*t)[2]));
    out.cameras.push_back(std::move(c));
  }
}

}  // namespace

std::optional<Value> easymocap_whole(const Value& root,
                                     const std::filesystem::path& file,
                                     Source& source) {
  const bool lenses = !names_of(root, "K_").empty(),
             places = !names_of(root, "T_").empty();
  if (lenses == places) return root;
  const std::filesystem::path other =
      file.parent_path() / (lenses ? "extri.yml" : "intri.yml");
  std::ifstream in(other, std::ios::binary);
  if (!in) {
    source.error(0, std::string("has no ") + (lenses ? "places" : "lenses") + ", and " +
                        other.string() + " isn't there");
    return std::nullopt;
  }
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  Source beside = source.beside(other.string());
  auto more = parse_yaml(text, beside);
  if (!more) return std::nullopt;
  Value whole = root;
  for (auto& member : more->members) whole.members.push_back(std::move(member));
  return whole;
}

const CalibrationFormat kEasyMocap = {
    "calibration of EasyMocap (intri.yml, extri.yml)",
    [](const Value& root) {
      return root.find("names") != nullptr &&
             (!names_of(root, "K_").empty() || !names_of(root, "T_").empty());
    },
    read_easymocap};

}  // namespace delos::imports
