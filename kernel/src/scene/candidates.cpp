#include "delos/scene/candidates.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <numbers>
#include <set>
#include <stdexcept>
#include <tuple>

#include "delos/device/beacons.h"
#include "delos/device/faults.h"
#include "delos/sampling/samples.h"
#include "delos/scene/definition.h"
#include "delos/text/words.h"
#include "scene/beacon_grid.h"

namespace delos {
namespace {

using Facing = decltype(Placement::facing);

/// Thrown and caught within this file: the sentence for the user.
struct Refused {
  std::string problem;
};

/// Pan and tilt as an orientation: R = Rz(pan) Ry(−tilt) C, where C looks along the
/// world's x with its y axis down.
QuaternionWxyz turned(double pan, double tilt) {
  Eigen::Matrix3d C;
  C << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  const Eigen::Quaterniond q((Eigen::AngleAxisd(pan, Eigen::Vector3d::UnitZ()) *
                              Eigen::AngleAxisd(-tilt, Eigen::Vector3d::UnitY()))
                                 .toRotationMatrix() *
                             C);
  return {{q.w(), q.x(), q.y(), q.z()}};
}

std::vector<Facing> facings_of(const Facings& facings, const DeviceEntry& pattern) {
  std::vector<Facing> all;
  for (const Eigen::Vector3d& at : facings.aims) all.emplace_back(Aim{at});
  for (const Eigen::Vector3d& rpy : facings.rpy) all.emplace_back(Rpy{rpy});
  for (const double pan : facings.pans)
    for (const double tilt : facings.tilts) all.emplace_back(turned(pan, tilt));
  if (all.empty()) all.push_back(pattern.placement.facing);
  return all;
}

/// Where the copies stand, without their facing.
std::vector<DeviceEntry> spots_of(const CandidateCopies& copies,
                                  const DeviceEntry& pattern) {
  std::vector<DeviceEntry> spots;
  const auto add_points = [&](const std::vector<Eigen::Vector3d>& points) {
    for (const Eigen::Vector3d& p : points) {
      spots.push_back(pattern);
      spots.back().mounting.reset();
      spots.back().placement.at = p;
    }
  };
  if (const auto* points = std::get_if<std::vector<Eigen::Vector3d>>(&copies.spots)) {
    add_points(*points);
  } else if (const auto* grid = std::get_if<VolumeSampling>(&copies.spots)) {
    add_points(make_samples({{"", *grid}}).points);
  } else {
    const auto& on = std::get<SurfaceSpots>(copies.spots);
    const auto coordinate = [](int i, int n) {
      return n == 1 ? 0.5 : static_cast<double>(i) / (n - 1);
    };
    const int rows = on.counts.size() > 1 ? on.counts[1] : 1;
    for (int j = 0; j < rows; ++j)
      for (int i = 0; i < on.counts[0]; ++i) {
        Mounting mounting{on.surface, {coordinate(i, on.counts[0])}};
        if (on.counts.size() > 1) mounting.coordinates.push_back(coordinate(j, rows));
        spots.push_back(pattern);
        spots.back().mounting = std::move(mounting);
      }
  }
  return spots;
}

/// Writes out one set after the other.
class Writer {
 public:
  explicit Writer(const Scene& scene) : from_(scene) {
    out_.scene = scene;
    out_.scene.devices.clear();
    for (const BeaconSet& set : scene.beacons)
      out_.of_beacon.emplace_back(delos::lit_beacons(set).size(), -1);
  }

  CandidateScene write() {
    for (const DeviceEntry& device : from_.devices)
      if (!is_pattern(device.name)) add_device(device, -1);
    for (const CandidateSet& set : from_.selection.candidates)
      std::visit([&](const auto& what) { add(what, set.cost); }, set.what);
    check_poses();
    mark(from_.selection.keep, &Candidate::kept);
    mark(from_.selection.leave_out, &Candidate::left_out);
    for (const Candidate& c : out_.candidates)
      if (c.kept && c.left_out) throw Refused{c.name + " is both kept and left out"};
    return std::move(out_);
  }

 private:
  [[nodiscard]] bool is_pattern(const std::string& name) const {
    return std::any_of(from_.selection.candidates.begin(),
                       from_.selection.candidates.end(), [&](const CandidateSet& set) {
                         const auto* copies = std::get_if<CandidateCopies>(&set.what);
                         return copies && copies->of == name;
                       });
  }

  int new_candidate(std::string name, double cost, int spot = -1) {
    if (!names_.insert(name).second) throw Refused{"there are two candidates " + name};
    out_.candidates.push_back({std::move(name), cost, spot});
    return static_cast<int>(out_.candidates.size()) - 1;
  }

  void add_device(DeviceEntry device, int candidate, std::string copy_of = "") {
    out_.scene.devices.push_back(std::move(device));
    out_.of_device.push_back(candidate);
    out_.copy_of.push_back(std::move(copy_of));
  }

  void add(const CandidateDevices& what, double cost) {
    for (const std::string& name : what.devices) {
      if (is_pattern(name))
        throw Refused{name + " is a pattern of copies, and no candidate itself"};
      for (std::size_t i = 0; i < out_.scene.devices.size(); ++i)
        if (out_.scene.devices[i].name == name)
          out_.of_device[i] = new_candidate(name, cost);
    }
  }

  void add(const CandidateBeacons& what, double cost) {
    std::size_t s = 0;
    while (from_.beacons[s].name != what.set) ++s;
    std::vector<int>& of_beacon = out_.of_beacon[s];
    if (!of_beacon.empty() && of_beacon.front() >= 0)
      throw Refused{"the beacons " + what.set + " are candidates twice"};
    const auto* grid = std::get_if<BeaconGrid>(&from_.beacons[s].layout);
    const std::vector<LitBeacon> lit =
        grid ? lit_beacons(*grid) : std::vector<LitBeacon>{};
    std::map<std::string, int> known;
    for (std::size_t b = 0; b < of_beacon.size(); ++b) {
      const auto part = [&](int axis) { return std::to_string(lit[b].panel(axis)); };
      std::string name = what.set + '-' + std::to_string(b);
      if (what.by == BeaconGrouping::row) name = what.set + "-row-" + part(1);
      if (what.by == BeaconGrouping::column) name = what.set + "-column-" + part(0);
      if (what.by == BeaconGrouping::panel)
        name = what.set + "-panel-" + part(0) + '-' + part(1);
      const auto [at, is_new] = known.try_emplace(name, -1);
      if (is_new) at->second = new_candidate(name, cost);
      of_beacon[b] = at->second;
    }
  }

  void add(const CandidateCopies& what, double cost) {
    const auto pattern =
        std::find_if(from_.devices.begin(), from_.devices.end(),
                     [&](const DeviceEntry& d) { return d.name == what.of; });
    const std::vector<Facing> facings = facings_of(what.facings, *pattern);
    const std::vector<DeviceEntry> spots = spots_of(what, *pattern);
    for (std::size_t i = 0; i < spots.size(); ++i) {
      const int spot = what.one_per_spot && facings.size() > 1 ? spots_++ : -1;
      for (std::size_t j = 0; j < facings.size(); ++j) {
        DeviceEntry device = spots[i];
        device.name = what.of + '-' + std::to_string(i);
        if (facings.size() > 1) device.name += '-' + std::to_string(j);
        device.placement.facing = facings[j];
        const int candidate = new_candidate(device.name, cost, spot);
        add_device(std::move(device), candidate, what.of);
      }
    }
  }

  /// Nothing is gained by choosing between devices that are the same.
  void check_poses() const {
    using Key = std::tuple<std::string, std::vector<double>>;
    std::map<Key, std::vector<std::size_t>> at;
    for (std::size_t i = 0; i < out_.scene.devices.size(); ++i) {
      const DeviceEntry& device = out_.scene.devices[i];
      if (out_.of_device[i] < 0) continue;
      const Pose X = placed(device);
      std::vector<double> numbers(X.R.data(), X.R.data() + 9);
      numbers.insert(numbers.end(), X.p.data(), X.p.data() + 3);
      for (const std::size_t other : at[{device.type, numbers}]) {
        const DeviceEntry& twin = out_.scene.devices[other];
        if (twin.params == device.params && rate_of(twin) == rate_of(device) &&
            twin.exposure == device.exposure &&
            twin.noise_over_time == device.noise_over_time &&
            twin.beacons == device.beacons)
          throw Refused{"the candidates " + twin.name + " and " + device.name +
                        " are the same device in the same place"};
      }
      at[{device.type, numbers}].push_back(i);
    }
  }

  [[nodiscard]] Pose placed(const DeviceEntry& device) const {
    try {
      return device.mount == Mount::target ? pose_of(device.placement)
                                           : device_pose(from_, device);
    } catch (const Unbuildable& problem) {
      throw Refused{device.name + ": " + problem.what()};
    }
  }

  void mark(const std::vector<std::string>& patterns, bool Candidate::*flag) {
    for (const std::string& pattern : patterns) {
      bool any = false;
      for (Candidate& c : out_.candidates) {
        if (!fits(c.name, pattern)) continue;
        c.*flag = any = true;
      }
      if (!any) throw Refused{"there is no candidate '" + pattern + '\''};
    }
  }

  const Scene& from_;
  CandidateScene out_;
  std::set<std::string> names_;
  int spots_ = 0;
};

}  // namespace

std::variant<CandidateScene, std::string> write_out_candidates(const Scene& scene) {
  try {
    return Writer(scene).write();
  } catch (const Refused& refused) {
    return refused.problem;
  }
}

}  // namespace delos
