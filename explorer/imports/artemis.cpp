// Input files of Artemis, the tool of the method's papers: B. D. Allen, "Hardware
// design optimization for human motion tracking systems", dissertation, University of
// North Carolina, 2007, §4.2.1–4.2.5, Fig. 4.5–4.7.
//
// left, up and look are a camera's axes in the world; r is the variance of a reading,
// of a range relative to its square, of an image at one metre; dt is a rate in Hz. A
// slave stands at its master's place plus its own, along the world's axes.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <numbers>

#include "delos/text/units.h"
#include "delos/text/words.h"
#include "imports/artemis_lines.h"
#include "imports/rig.h"

namespace delos::imports {
namespace {

/// What stands in place of an .int file that isn't there.
constexpr const char* kLens = "{focal: 4 mm, pitch: 7.4 um, resolution: [640, 480]}";

class Artemis {
 public:
  Artemis(std::string_view text, const std::filesystem::path& file,
          const std::filesystem::path& folder, Source& source)
      : lines_(artemis_lines(text)), file_(file), folder_(folder), source_(source) {}

  Rig read() {
    rig_.kind = "input file of Artemis (.ext)";
    const auto head = artemis_head(lines_, file_, folder_, source_);
    if (!head) return rig_;
    head_ = *head;
    rig_.motion = head_.motion;
    rig_.sample = head_.sample;
    rig_.facts = head_.facts;
    const auto all = artemis_measurements(lines_, head_.next, source_);
    if (all.empty()) source_.error(0, "has no measurement");
    for (const ArtemisMeasurement& m : all) add(m);
    rig_.facts.emplace_back(
        "dt is a rate in Hz; r of a range is relative to its square, "
        "r of a camera that of an image at one metre");
    return rig_;
  }

 private:
  void add(const ArtemisMeasurement& own) {
    ArtemisMeasurement m = own;
    const bool slave = m.role == "slave";
    const auto known = masters_.find(m.group);
    if (slave && known == masters_.end()) {
      source_.error(m.line, "a slave without a master before it in its group");
      return;
    }
    // "Any changes to the master's parameters also change the slave's accordingly."
    if (slave) inherit(m, known->second);
    RigDevice d;
    const std::string number = "S" + std::to_string(rig_.devices.size() + 1);
    d.name = m.group.empty()
                 ? number
                 : scene_name(m.group) + "-" + (m.role.empty() ? number : m.role);
    for (int i = 2; has_device(d.name); ++i) d.name += "-" + std::to_string(i);
    if (!m.dt || !(m.dt->value > 0)) {
      source_.error(m.line, "a measurement needs 'dt', its rate in Hz, above 0");
      return;
    }
    d.rate = shortest(m.dt->value) + " Hz";
    control(m.dt, "devices." + d.name + ".rate");
    set_type(m, d);
    set_place(m, own, d);
    set_facing(m, own, d);
    if (m.role == "master") masters_[m.group] = m;
    rig_.devices.push_back(std::move(d));
  }

  [[nodiscard]] bool has_device(const std::string& name) const {
    return std::any_of(rig_.devices.begin(), rig_.devices.end(),
                       [&](const RigDevice& d) { return d.name == name; });
  }

  static void inherit(ArtemisMeasurement& m, const ArtemisMeasurement& master) {
    const auto without_control = [](const std::optional<ArtemisNumber>& from) {
      return from ? std::optional(ArtemisNumber{from->value, false, {}}) : from;
    };
    if (!m.dt) m.dt = without_control(master.dt);
    if (!m.r) m.r = without_control(master.r);
    if (m.filename.empty()) m.filename = master.filename;
    if (!m.look) m.left = master.left, m.up = master.up, m.look = master.look;
    for (int i = 0; i < 3; ++i)
      if (!m.angle[i]) m.angle[i] = without_control(master.angle[i]);
  }

  /// A control as a variable; a slave's number that is its master's is tied to it.
  void control(const std::optional<ArtemisNumber>& number, const std::string& path,
               const std::string& unit = "") {
    if (!number || !number->control) return;
    const ArtemisControl& c = *number->control;
    if (c.lower.empty() && unit != "deg") {
      source_.warning(0, "'" + c.name + "' has no range, and is no variable for that");
      return;
    }
    const std::string suffix = c.lower.empty() || unit.empty() ? "" : " " + unit;
    rig_.variables.push_back(
        {path, c.lower + suffix, c.upper + suffix, {}, c.kind + " " + c.name});
  }

  void set_type(const ArtemisMeasurement& m, RigDevice& d) {
    const std::string r = shortest(m.r ? m.r->value : 0);
    if (!m.r) source_.error(m.line, "a measurement needs 'r', its variance");
    if (m.type == "AcousticRange") {
      d.type = "acoustic_range";
      d.params = {{"r", r}};
    } else if (m.type == "CameraVector" || m.type == "PinholeCamera") {
      d.type = "pinhole_camera";
      d.params = lens_of(m);
      d.params.emplace_back("noise", "distance");
      d.params.emplace_back("r", r);
    } else {
      source_.error(m.line, "'" + m.type +
                                "' isn't a measurement that is read: AcousticRange, "
                                "CameraVector and PinholeCamera are");
      return;
    }
    const std::string path = "devices." + d.name + ".params.r";
    control(m.r, path);
    if (m.role != "slave" || (m.r && m.r->control)) return;
    // Fig. 4.7: what changes the master's changes the slave's.
    const std::string masters = "devices." + scene_name(m.group) + "-master.params.r";
    for (RigVariable& v : rig_.variables)
      if (v.path == masters) v.tie.push_back(path);
  }

  /// The parameters that an .int file has: a name and its value, as scenes write them,
  /// a line. The source shows such a file only as a picture.
  std::vector<std::pair<std::string, std::string>> lens_of(
      const ArtemisMeasurement& m) {
    const auto file = file_.parent_path() / m.filename;
    std::ifstream in(file);
    std::error_code error;
    if (m.filename.empty() || !std::filesystem::is_regular_file(file, error) || !in) {
      const std::string missing =
          m.filename.empty() ? "a camera without 'filename'" : "'" + m.filename + "'";
      const std::string sentence =
          missing + " isn't there: lenses are " + kLens + ", which is assumed";
      if (std::find(rig_.assumed.begin(), rig_.assumed.end(), sentence) ==
          rig_.assumed.end())
        rig_.assumed.push_back(sentence);
      return {{"focal", "4 mm"}, {"pitch", "7.4 um"}, {"resolution", "[640, 480]"}};
    }
    Source lens = source_.beside(file.string());
    std::vector<std::pair<std::string, std::string>> params;
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    for (const ArtemisLine& line : artemis_lines(text)) {
      const std::string& name = line.words[0];
      const std::vector<std::string> rest(line.words.begin() + 1, line.words.end());
      if (name == "resolution" && numbers_of(line, 1, 2)) {
        params.emplace_back(name, "[" + joined(rest) + "]");
      } else if ((name == "focal" || name == "pitch" || name == "near" ||
                  name == "far") &&
                 std::holds_alternative<double>(
                     parse_quantity(joined(rest, " "), "m"))) {
        params.emplace_back(name, joined(rest, " "));
      } else {
        lens.error(line.number,
                   "an .int file has lines 'focal 6 mm', 'pitch 7.4 um', "
                   "'resolution 640 480', 'near 0.1 m' and 'far 5 m'");
      }
    }
    return params;
  }

  /// A group stands where its master does, along the world's axes, so that a slave
  /// moves with it.
  void set_place(const ArtemisMeasurement& m, const ArtemisMeasurement& own,
                 RigDevice& d) {
    Eigen::Vector3d at = Eigen::Vector3d::Zero();
    bool relative = false;
    for (int i = 0; i < 3; ++i) {
      if (!m.position[i]) continue;
      at(i) = head_.unit * m.position[i]->value;
      relative = relative || m.position[i]->relative;
    }
    if (relative && m.role != "slave") source_.error(m.line, "'relative' is of slaves");
    std::string path = "devices." + d.name + ".at";
    const std::string group = scene_name(m.group);
    if (m.role == "master") {
      if (std::any_of(rig_.groups.begin(), rig_.groups.end(),
                      [&](const Group& g) { return g.name == group; })) {
        source_.error(m.line, "group '" + group + "' has a master already");
        return;
      }
      rig_.groups.push_back({group, {at, std::monostate{}}});
      d.group = group;
      path = "groups." + group + ".at";
    } else if (m.role == "slave") {
      d.group = group;
      const Eigen::Vector3d master = master_place(m.group);
      for (int i = 0; i < 3; ++i)
        d.placement.at(i) =
            m.position[i] && !m.position[i]->relative ? at(i) - master(i) : at(i);
    } else {
      d.placement.at = at;
    }
    constexpr const char* kAxis[] = {".x", ".y", ".z"};
    for (int i = 0; i < 3; ++i)
      control(own.position[i], path + kAxis[i],
              head_.unit == 1 ? "" : lines_[1].words[1]);
  }

  [[nodiscard]] Eigen::Vector3d master_place(const std::string& group) const {
    for (const Group& g : rig_.groups)
      if (g.name == scene_name(group)) return g.placement.at;
    return Eigen::Vector3d::Zero();
  }

  /// left, up and look where they are there: x is −left, y −up, z look.
  void set_facing(const ArtemisMeasurement& m, const ArtemisMeasurement& own,
                  RigDevice& d) {
    if (m.left && m.up && m.look) {
      std::vector<double> R;
      for (std::size_t i = 0; i < 3; ++i)
        R.insert(R.end(), {-(*m.left)[i], -(*m.up)[i], (*m.look)[i]});
      Value at;
      at.line = m.line;
      const auto rotation = rotation_of(R, at, source_);
      if (!rotation) return;
      const Eigen::Quaterniond q(*rotation);
      d.placement.facing = QuaternionWxyz{{q.w(), q.x(), q.y(), q.z()}};
      for (const auto& angle : own.angle)
        if (angle && angle->control)
          source_.warning(m.line, "'" + angle->control->name +
                                      "' is no variable: left, up and look say how the "
                                      "camera is turned");
      return;
    }
    Eigen::Vector3d rpy = Eigen::Vector3d::Zero();
    constexpr const char* kAngle[] = {".rpy.roll", ".rpy.pitch", ".rpy.yaw"};
    for (int i = 0; i < 3; ++i) {
      if (m.angle[i]) rpy(i) = m.angle[i]->value * std::numbers::pi / 180;
      control(own.angle[i], "devices." + d.name + kAngle[i], "deg");
    }
    const bool controlled =
        std::any_of(std::begin(own.angle), std::end(own.angle),
                    [](const auto& angle) { return angle && angle->control; });
    if (rpy.isZero(0) && !controlled) return;
    d.placement.facing = Rpy{rpy};
    if (d.type == "pinhole_camera")
      source_.warning(m.line, "'" + d.name +
                                  "' is turned by angles alone, whose axes the "
                                  "source doesn't say: Delos's roll, pitch and yaw are "
                                  "taken; give left, up and look");
  }

  std::vector<ArtemisLine> lines_;
  std::filesystem::path file_, folder_;
  Source& source_;
  Rig rig_;
  ArtemisHead head_;
  std::map<std::string, ArtemisMeasurement> masters_;
};

}  // namespace

Rig read_artemis(std::string_view text, const std::filesystem::path& file,
                 const std::filesystem::path& folder, Source& source) {
  return Artemis(text, file, folder, source).read();
}

}  // namespace delos::imports
