#include "simulation/reading_draws.h"

#include <cmath>
#include <utility>

#include "observe/possible_readings.h"
#include "observe/reading_rows.h"

namespace delos {
namespace {

/// One after another out of weights, with repetition.
void pick_repeatedly(const std::vector<BeaconSighting>& all, int count,
                     RunRandom& random, std::vector<std::uint32_t>& picked) {
  double total = 0;
  for (const BeaconSighting& s : all) total += s.share;
  for (int k = 0; k < count && total > 0; ++k) {
    double left = random.uniform() * total;
    std::uint32_t i = 0;
    while (i + 1 < all.size() && left >= all[i].share) left -= all[i++].share;
    picked.push_back(i);
  }
}

/// Each as often as its share in the mean, and their number as even as can be: along
/// the sum of shares, in a random order, whatever stands at u, u + 1, u + 2, …
/// Source: Madow (1949), Ann. Math. Stat. 20(3), 333–354 (systematic sampling).
void pick_evenly(const std::vector<BeaconSighting>& all, RunRandom& random,
                 std::vector<std::uint32_t>& picked) {
  std::vector<std::uint32_t>& order = picked;
  for (std::uint32_t i = 0; i < all.size(); ++i) {
    const auto j = static_cast<std::uint32_t>(random.uniform() * (i + 1));
    order.push_back(i);
    std::swap(order[i], order[j]);
  }
  double sum = 0, next = random.uniform();
  std::size_t kept = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::uint32_t s = order[i];
    sum += all[s].share;
    // A share is at most a weight, and so at most 1.
    if (sum <= next) continue;
    next += 1;
    picked[kept++] = s;
  }
  picked.resize(kept);
}

void pick(const TargetMount& mount, const std::vector<BeaconSighting>& all,
          RunRandom& random, std::vector<std::uint32_t>& picked) {
  picked.clear();
  switch (mount.select) {
    case SightingRule::all:  // each is there or not, whatever the others are
      for (std::uint32_t i = 0; i < all.size(); ++i)
        if (random.uniform() < all[i].share) picked.push_back(i);
      return;
    case SightingRule::mean:
      return pick_repeatedly(all, mount.count, random, picked);
    case SightingRule::random:
    case SightingRule::nearest:
    case SightingRule::best:
      return pick_evenly(all, random, picked);
  }
}

}  // namespace

void draw_readings(const ReadingModel& model, int device, const StateBlock& block,
                   const StateVector& x, const Eigen::Matrix3d& R, RunRandom& noise,
                   RunRandom& beacons, ReadingScratch& scratch,
                   std::vector<TrackReading>& readings, StateMatrix& information,
                   bool& perfect, DrawnErrors* errors) {
  const System& system = model.system();
  const PlacedDevice& placed = system.devices[static_cast<std::size_t>(device)];
  const TargetPose X_WT = model.pose_of(block, x, R);
  TrackReading reading{device, 0, 0, block, {}};
  const auto add = [&] {
    PredictedReading& seen = scratch.predicted;
    if (errors && !errors->read(reading, x, R, seen, reading.z)) return;
    if (!model.predict(reading, x, R, seen)) return;
    if (!errors) reading.z = seen.z;
    if (errors && reading.without_sight) reading.z.array() += placed.without_sight.bias;
    if (seen.R.isDiagonal(0)) {
      for (Eigen::Index r = 0; r < seen.z.size(); ++r)
        reading.z(r) += std::sqrt(seen.R(r, r)) * noise.normal();
    } else {
      const IndependentNoise split = independent_noise(seen.R);
      for (Eigen::Index r = 0; r < seen.z.size(); ++r)
        reading.z +=
            std::sqrt(split.variance(r)) * noise.normal() * split.directions.col(r);
    }
    // An angle is read as one.
    const decltype(reading.z) nothing = decltype(reading.z)::Zero(reading.z.size());
    reading.z = model.difference(device, reading.z, nothing);
    each_row(seen, seen.z, [&](const auto& h, double, double variance) {
      if (variance == 0)
        perfect = true;
      else
        for (Eigen::Index i = 0; i < h.size(); ++i)
          for (Eigen::Index j = 0; h(i) != 0 && j <= i; ++j)
            information(i, j) += h(i) * h(j) / variance;
    });
    readings.push_back(reading);
  };
  if (const TargetMount* carried = placed.carried();
      carried && placed.device->span() == Span::point) {
    const std::vector<BeaconSighting>& all =
        scratch.beacons.see(system, placed, X_WT).all;
    pick(*carried, all, beacons, scratch.picked);
    for (const std::uint32_t i : scratch.picked) {
      reading.view = all[i].view;
      reading.of = all[i].beacon;
      add();
    }
    return;
  }
  each_possible_reading(system, placed, X_WT, scratch.beacons,
                        [&](int, std::size_t of, double share, bool hidden) {
                          if (share < 1 && beacons.uniform() >= share) return;
                          reading.of = of;
                          reading.without_sight = hidden;
                          add();
                        });
}

}  // namespace delos
