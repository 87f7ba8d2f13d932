#include "delos/scene/number.h"

#include <algorithm>
#include <numbers>
#include <span>

#include "delos/model/infinity.h"
#include "delos/text/words.h"
#include "document/reader.h"

namespace delos {
namespace {

/// Thrown and caught within this file: the sentence for the user.
struct NoNumber {
  std::string problem;
};

std::vector<std::string> split(std::string_view path) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0;;) {
    const std::size_t dot = std::min(path.find('.', begin), path.size());
    parts.emplace_back(path.substr(begin, dot - begin));
    if (dot == path.size()) return parts;
    begin = dot + 1;
  }
}

/// Walks down a path. What it passes is a Visitor of itself: `leaf` ends the walk,
/// `branch` says what the next part may be.
class Walk {
 public:
  Walk(std::string_view path, PluginRegistry& plugins)
      : path_(path), parts_(split(path)), plugins_(plugins) {}

  SceneNumber find(Scene& scene) {
    const std::string& room =
        next({"devices", "groups", "surfaces", "occluders", "target", "motion", "lag"});
    if (room == "devices") return of_device(member(scene.devices));
    if (room == "groups") return of_placement(member(scene.groups).placement);
    if (room == "occluders") return of_placement(member(scene.occluders).placement);
    if (room == "surfaces") return of_surface(member(scene.surfaces));
    if (room == "target") {
      if (next({"markers", "bodies"}) == "bodies") return of_body(member(scene.bodies));
      return vector(scene.markers[index(scene.markers.size())], "m");
    }
    if (room == "lag") return end(scene.lag, "s", 0);
    next({"q"});
    return of_noise(scene.motion);
  }

  /// The parts that could have stood where the walk ended too early.
  [[nodiscard]] const std::vector<std::string>& open() const { return open_; }

 private:
  [[noreturn]] void fail(const std::string& problem) const {
    throw NoNumber{"'" + path_ + "': " + problem};
  }

  /// The next part, which must be one of these words.
  const std::string& next(std::vector<std::string> words) {
    if (at_ == parts_.size()) {
      open_ = std::move(words);
      fail("isn't a number by itself; go on with " + joined(open_));
    }
    const std::string& part = parts_[at_++];
    if (std::find(words.begin(), words.end(), part) == words.end())
      fail("there is no number '" + part + "' here" + suggestion(part, words));
    return part;
  }

  std::size_t index(std::size_t size) {
    std::vector<std::string> words;
    for (std::size_t i = 0; i < size; ++i) words.push_back(std::to_string(i));
    const std::string& part = next(std::move(words));
    return static_cast<std::size_t>(std::stoul(part));
  }

  template <class Entry>
  Entry& member(std::vector<Entry>& entries) {
    std::vector<std::string> words;
    for (std::size_t i = 0; i < entries.size(); ++i)
      words.push_back(entries[i].name.empty() ? std::to_string(i) : entries[i].name);
    const std::string& part = next(words);
    return entries[static_cast<std::size_t>(
        std::find(words.begin(), words.end(), part) - words.begin())];
  }

  SceneNumber end(double& value, std::string unit, double lower = -kInfinity,
                  double upper = kInfinity) {
    if (at_ < parts_.size()) fail("there is nothing inside a single number");
    return {&value, std::move(unit), lower, upper};
  }

  SceneNumber vector(Eigen::Vector3d& v, const char* unit) {
    const std::string& part = next({"x", "y", "z"});
    return end(v(part[0] - 'x'), unit);
  }

  /// The key by which a placement says how it faces; none where it doesn't.
  static std::vector<std::string> facing_words(const Placement& placement) {
    if (std::holds_alternative<Aim>(placement.facing)) return {"aim", "roll"};
    if (std::holds_alternative<Rpy>(placement.facing)) return {"rpy"};
    if (std::holds_alternative<QuaternionWxyz>(placement.facing))
      return {"quaternion_wxyz"};
    return {};
  }

  SceneNumber of_placement(Placement& placement) {
    std::vector<std::string> words = facing_words(placement);
    words.insert(words.begin(), "at");
    return of_facing(next(std::move(words)), placement);
  }

  SceneNumber of_facing(const std::string& key, Placement& placement) {
    constexpr double kPi = std::numbers::pi;
    if (key == "at") return vector(placement.at, "m");
    if (key == "aim") return vector(std::get<Aim>(placement.facing).at, "m");
    if (key == "roll")
      return end(std::get<Aim>(placement.facing).roll, "rad", -kPi, kPi);
    if (key == "rpy") {
      const std::string& part = next({"roll", "pitch", "yaw"});
      Eigen::Vector3d& angles = std::get<Rpy>(placement.facing).angles;
      return end(angles(part == "roll"    ? 0
                        : part == "pitch" ? 1
                                          : 2),
                 "rad", -kPi, kPi);
    }
    const std::string& part = next({"w", "x", "y", "z"});
    Eigen::Vector4d& q = std::get<QuaternionWxyz>(placement.facing).wxyz;
    return end(q(part == "w" ? 0 : part[0] - 'x' + 1), "1", -1, 1);
  }

  SceneNumber of_body(MarkerBody& body) {
    std::vector<std::string> words = facing_words(body.placement);
    words.insert(words.end(), {"at", "half_angle"});
    const std::string& key = next(std::move(words));
    if (key != "half_angle") return of_facing(key, body.placement);
    return end(body.half_angle, "rad", 0, std::numbers::pi);
  }

  SceneNumber of_device(DeviceEntry& device) {
    std::vector<std::string> words = facing_words(device.placement);
    words.insert(words.begin(), device.mounting ? "coordinates" : "at");
    if (!device.timing) words.emplace_back("rate");
    words.insert(words.end(), {"phase", "exposure", "params"});
    const std::string& key = next(std::move(words));
    if (key == "rate") {
      SceneNumber rate = end(device.rate, "1/s", 0);
      rate.scale = ParamScale::log;
      return rate;
    }
    if (key == "phase") return end(device.phase, "s", 0);
    if (key == "exposure") {
      // With a timing, the period grows with it.
      const double most = device.timing ? kInfinity : 1 / device.rate;
      SceneNumber exposure = end(device.exposure, "s", 0, most);
      if (device.noise_over_time) exposure.scale = ParamScale::log;
      return exposure;
    }
    if (key == "params") return of_params(device);
    if (key != "coordinates") return of_facing(key, device.placement);
    auto& coordinates = device.mounting->coordinates;
    // The only one of a rail is a number by itself.
    const bool only = coordinates.size() == 1 && at_ == parts_.size();
    return end(coordinates[only ? 0 : index(coordinates.size())], "1", 0, 1);
  }

  SceneNumber of_params(DeviceEntry& device) {
    const PluginLoad& plugin = plugins_.find(device.type);
    if (!plugin.info) fail(plugin.error);
    std::vector<std::string> words;
    const std::span<const ParamSpec> table(plugin.info->params, plugin.info->n_params);
    for (const ParamSpec& spec : table) {
      const bool wordy = spec.kind == ParamKind::choice || spec.kind == ParamKind::text;
      if (!wordy) words.emplace_back(spec.name);
      if (at_ < parts_.size() && parts_[at_] == spec.name && wordy)
        fail(spec.kind == ParamKind::choice
                 ? "a choice of words isn't a number; compare them with 'delos compare'"
                 : "a text isn't a number; compare them with 'delos compare'");
    }
    const std::string& name = next(std::move(words));
    const ParamSpec& spec = *std::find_if(
        table.begin(), table.end(), [&](const ParamSpec& s) { return name == s.name; });
    ParamValue& value = device.params.edit(name);
    double* number = std::get_if<double>(&value);
    if (!number) {
      auto& m = std::get<Eigen::MatrixXd>(value);
      const auto i =
          static_cast<Eigen::Index>(index(static_cast<std::size_t>(m.rows())));
      const auto j =
          m.cols() == 1
              ? Eigen::Index{0}
              : static_cast<Eigen::Index>(index(static_cast<std::size_t>(m.cols())));
      number = &m(i, j);
    }
    SceneNumber found = end(*number, spec.unit, spec.lower, spec.upper);
    found.scale = spec.scale;
    return found;
  }

  SceneNumber of_surface(SurfaceEntry& surface) {
    if (auto* rail = std::get_if<RailSurface>(&surface.shape)) {
      next({"rail"});
      return vector(rail->points[index(rail->points.size())], "m");
    }
    auto* patch = std::get_if<PatchSurface>(&surface.shape);
    next({patch ? "patch" : "from"});
    if (!patch) patch = &std::get<MeshSurface>(surface.shape).from;
    const std::string& part = next({"origin", "u", "v"});
    return vector(part == "origin" ? patch->origin
                  : part == "u"    ? patch->u
                                   : patch->v,
                  "m");
  }

  SceneNumber of_noise(MotionModel& motion) {
    auto* chain = std::get_if<ChainMotion>(&motion.dynamics);
    if (!chain) fail("this type of motion has no q");
    if (!chain->q.isDiagonal(0))
      fail("q is a matrix, of which single numbers can't change by themselves");
    const auto i =
        static_cast<Eigen::Index>(index(static_cast<std::size_t>(chain->q.rows())));
    SceneNumber q = end(chain->q(i, i), "1", 0);
    q.scale = ParamScale::log;
    return q;
  }

  std::string path_;
  std::vector<std::string> parts_;
  std::vector<std::string> open_;
  std::size_t at_ = 0;
  PluginRegistry& plugins_;
};

template <class Entry>
std::vector<std::string> fitting(const std::vector<Entry>& entries,
                                 const std::string& pattern) {
  std::vector<std::string> names;
  for (const Entry& entry : entries)
    if (fits(entry.name, pattern)) names.push_back(entry.name);
  return names;
}

/// Replace a '*' in the name of a member by all members that fit.
std::vector<std::string> members(const Scene& scene, const std::string& pattern) {
  std::vector<std::string> parts = split(pattern);
  if (parts.size() < 2 || parts[1].find('*') == std::string::npos) return {pattern};
  std::vector<std::string> names;
  if (parts[0] == "devices") names = fitting(scene.devices, parts[1]);
  if (parts[0] == "groups") names = fitting(scene.groups, parts[1]);
  if (parts[0] == "occluders") names = fitting(scene.occluders, parts[1]);
  if (parts[0] == "surfaces") names = fitting(scene.surfaces, parts[1]);
  if (names.empty())
    throw NoNumber{"'" + pattern + "': no name fits '" + parts[1] + "'"};
  std::vector<std::string> paths;
  for (const std::string& name : names) {
    parts[1] = name;
    paths.push_back(joined(parts, "."));
  }
  return paths;
}

}  // namespace

std::variant<SceneNumber, std::string> find_number(Scene& scene, std::string_view path,
                                                   PluginRegistry& plugins) {
  try {
    return Walk(path, plugins).find(scene);
  } catch (const NoNumber& no) {
    return no.problem;
  }
}

std::variant<std::vector<std::string>, std::string> expand_numbers(
    Scene& scene, std::string_view pattern, PluginRegistry& plugins) {
  try {
    std::vector<std::string> paths;
    for (const std::string& path : members(scene, std::string(pattern))) {
      Walk walk(path, plugins);
      try {
        walk.find(scene);
        // A rail's only coordinate has one name, so that it is declared once.
        paths.push_back(path.ends_with(".coordinates") ? path + ".0" : path);
      } catch (const NoNumber&) {
        // A vector, where all that could follow are its components.
        const std::vector<std::string>& open = walk.open();
        const std::string& last = open.empty() ? path : open.back();
        if (last != "z" && last != "yaw" && last != "1") throw;
        for (const std::string& part : open) paths.push_back(path + '.' + part);
      }
    }
    return paths;
  } catch (const NoNumber& no) {
    return no.problem;
  }
}

std::variant<std::vector<std::string>, std::string> expand_devices(
    const Scene& scene, const std::vector<std::string>& patterns) {
  std::vector<std::string> names, known;
  for (const DeviceEntry& device : scene.devices) known.push_back(device.name);
  for (const std::string& pattern : patterns)
    if (fitting(scene.devices, pattern).empty())
      return "there is no device '" + pattern + '\'' + suggestion(pattern, known);
  for (const std::string& name : known) {
    if (std::any_of(patterns.begin(), patterns.end(),
                    [&](const std::string& pattern) { return fits(name, pattern); }))
      names.push_back(name);
  }
  return names;
}

}  // namespace delos
