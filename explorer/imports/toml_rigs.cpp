// Three dialects of one TOML: a table a camera with name, size, matrix, distortions,
// rotation and translation, p_C = R p_W + t.
//
//   Caliscope   [cameras.0], or [cam_0] with rotation_count: metres
//   Pose2Sim    [cam_01] with fisheye: metres
//   aniposelib  [cam_0]: units of the board, which the file doesn't say
#include "imports/formats.h"

namespace delos::imports {
namespace {

bool is_table_of_camera(const Value& value) {
  return value.kind == Value::Kind::map && value.find("matrix") != nullptr &&
         value.find("distortions") != nullptr;
}

/// The tables of cameras and their names in the file.
std::vector<const std::pair<std::string, Value>*> tables_of(const Value& root) {
  std::vector<const std::pair<std::string, Value>*> tables;
  const Value* inner = root.find("cameras");
  for (const auto& member : (inner ? *inner : root).members)
    if (is_table_of_camera(member.second)) tables.push_back(&member);
  return tables;
}

bool any_has(const Value& root, std::string_view key) {
  for (const auto* table : tables_of(root))
    if (table->second.find(key) != nullptr) return true;
  return false;
}

void read_table(const std::string& key, const Value& table, double unit, Source& source,
                Calibration& out) {
  CalibratedCamera c;
  c.name = text_or_empty(table, "name");
  if (c.name.empty()) c.name = "cam" + key.substr(key.find('_') + 1);
  c.line = table.line;
  const auto size = numbers(table, "size", 2, source);
  const auto K = numbers(table, "matrix", 9, source);
  const auto k = numbers_in(*table.find("distortions"));
  if (!k) source.error(*table.find("distortions"), "'distortions' must be numbers");
  const bool placed = table.find("rotation") && table.find("translation");
  const auto t =
      placed ? numbers(table, "translation", 3, source) : std::vector<double>{};
  const auto R = placed ? rotation_in(table, "rotation", source)
                        : std::optional(Eigen::Matrix3d(Eigen::Matrix3d::Identity()));
  if (!size || !K || !k || !t || !R) return;
  c.size = {(*size)[0], (*size)[1]};
  set_matrix(c, *K, *table.find("matrix"), source);
  set_distortion(c, *k, text_or_empty(table, "fisheye") == "true",
                 *table.find("distortions"), source);
  if (placed)
    c.X_WC =
        from_world_to_camera(*R, unit * Eigen::Vector3d((*t)[0], (*t)[1], (*t)[2]));
  const std::string error = text_or_empty(table, "error");
  if (!error.empty()) c.residual = error + " px (error)";
  out.cameras.push_back(std::move(c));
}

void read_tables(const Value& root, double unit, Source& source, Calibration& out) {
  bool turned = false;
  for (const auto* table : tables_of(root)) {
    if (text_or_empty(table->second, "ignore") == "true") {
      out.facts.push_back("'" + table->first + "' says ignore, and is left out");
      continue;
    }
    const std::string turns = text_or_empty(table->second, "rotation_count");
    turned = turned || (!turns.empty() && turns != "0");
    read_table(table->first, table->second, unit, source, out);
  }
  if (turned)
    out.facts.emplace_back(
        "rotation_count turns what is shown, not the sensor: it isn't read");
  if (const Value* error = root.find({"metadata", "error"}))
    out.facts.push_back("error of the whole calibration: " + error->text);
}

void read_caliscope(const Value& root, const ImportOptions& options, Source& source,
                    Calibration& out) {
  out.facts.emplace_back(
      "places in m, world to camera; which way is up isn't in the file: z is taken");
  read_tables(root, options.unit.value_or(1), source, out);
}

void read_pose2sim(const Value& root, const ImportOptions& options, Source& source,
                   Calibration& out) {
  out.facts.emplace_back("places in m, world to camera; z up");
  read_tables(root, options.unit.value_or(1), source, out);
}

void read_anipose(const Value& root, const ImportOptions& options, Source& source,
                  Calibration& out) {
  const auto unit = asked_unit(options, source);
  out.facts.emplace_back(
      "places in units of the board, world to camera; which way is up isn't in the "
      "file: z is taken");
  read_tables(root, unit.value_or(1), source, out);
}

}  // namespace

const CalibrationFormat kCaliscope = {
    "calibration of Caliscope (.toml)",
    [](const Value& root) { return any_has(root, "rotation_count"); }, read_caliscope};

const CalibrationFormat kPose2Sim = {
    "calibration of Pose2Sim (.toml)",
    [](const Value& root) {
      for (const auto* table : tables_of(root))
        if (text_or_empty(table->second, "fisheye") == "false") return true;
      return false;
    },
    read_pose2sim};

const CalibrationFormat kAnipose = {
    "calibration of aniposelib (.toml)",
    [](const Value& root) { return !tables_of(root).empty(); }, read_anipose};

}  // namespace delos::imports
