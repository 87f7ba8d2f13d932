#include "delos/layers/candidate_information.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "delos/model/lanes.h"
#include "delos/parallel/each.h"
#include "layers/beacon_owners.h"
#include "observe/measure.h"

namespace delos {
namespace {

/// For each device that looks at beacons, the candidate of each beacon of its index.
std::vector<std::vector<int>> checked_owners(const System& system,
                                             const CandidateScene& all) {
  std::vector<std::vector<int>> owners(system.devices.size());
  for (std::size_t i = 0; i < system.devices.size(); ++i) {
    const PlacedDevice& placed = system.devices[i];
    if (!placed.sees_beacons()) continue;
    owners[i] = beacon_owners(system, placed, all);
    const bool chosen =
        std::any_of(owners[i].begin(), owners[i].end(), [](int c) { return c >= 0; });
    if (chosen && all.of_device[i] >= 0)
      throw std::invalid_argument(placed.name +
                                  " is a candidate, and so are beacons that it sees: "
                                  "choose one kind, then the other");
    if (chosen && placed.carried()->select != SightingRule::all)
      throw std::invalid_argument(
          placed.name +
          " shares its updates among the beacons in view, so that another beacon may "
          "make it worse, and no bound is known; use 'select: all'");
  }
  return owners;
}

/// All that the candidates know at one pose.
class PoseEntries {
 public:
  PoseEntries(const System& system, std::size_t candidates, bool keep_readings)
      : system_(system),
        keep_readings_(keep_readings),
        columns_(information_size(system)),
        packed_(static_cast<std::size_t>(packed_index(columns_, 0))),
        slot_(candidates, -1) {}

  void clear() {
    for (const std::int32_t c : seen) slot_[static_cast<std::size_t>(c)] = -1;
    seen.clear();
    information.clear();
    always.assign(packed_, 0.0);
    for (int k = 0; k < system_.motion.layout.coordinates(); ++k)
      always[static_cast<std::size_t>(packed_index(k, k))] = system_.prior;
    exact.clear();
    reader.clear();
    readings.clear();
  }

  /// Take over a row of a candidate.
  void add(int candidate, const StateRow& row, double weight) {
    if (row.perfect()) {
      exact.push_back({candidate, row.h});
      return;
    }
    double* S = of(candidate);
    const double all = weight * row.weight();
    for (int i = 0; i < columns_; ++i)
      for (int j = 0; j <= i; ++j) S[packed_index(i, j)] += all * row.h(i) * row.h(j);
    if (!keep_readings_) return;
    reader.push_back(candidate);
    for (int i = 0; i < columns_; ++i) readings.push_back(std::sqrt(all) * row.h(i));
  }

  /// In the order of the candidates; nothing can be added any more.
  void sort() {
    std::vector<std::size_t> order(seen.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return seen[a] < seen[b]; });
    std::vector<std::int32_t> sorted;
    std::vector<double> numbers;
    for (const std::size_t i : order) {
      sorted.push_back(seen[i]);
      const auto begin = information.begin() + static_cast<std::ptrdiff_t>(i * packed_);
      numbers.insert(numbers.end(), begin,
                     begin + static_cast<std::ptrdiff_t>(packed_));
    }
    seen = std::move(sorted);
    information = std::move(numbers);
  }

  std::vector<std::int32_t> seen;
  std::vector<double> information, always;
  std::vector<ExactRow> exact;
  std::vector<std::int32_t> reader;
  std::vector<double> readings;

 private:
  double* of(int candidate) {
    if (candidate < 0) return always.data();
    std::int32_t& slot = slot_[static_cast<std::size_t>(candidate)];
    if (slot < 0) {
      slot = static_cast<std::int32_t>(seen.size());
      seen.push_back(candidate);
      information.resize(information.size() + packed_, 0.0);
    }
    return &information[static_cast<std::size_t>(slot) * packed_];
  }

  const System& system_;
  bool keep_readings_;
  int columns_;
  std::size_t packed_;
  std::vector<std::int32_t> slot_;
};

void observe(const System& system, const CandidateScene& all,
             const std::vector<std::vector<int>>& owners, const TargetPose& pose,
             MeasureScratch& scratch, PoseEntries& out) {
  const int columns = information_size(system);
  for (std::size_t i = 0; i < system.devices.size(); ++i) {
    const PlacedDevice& placed = system.devices[i];
    const double weight = information_weight(system, placed);
    measure(system, placed, pose, columns, scratch, [&](const StateRow& row) {
      const int owner = placed.sees_beacons() ? owners[i][row.beacon] : -1;
      out.add(owner >= 0 ? owner : all.of_device[i], row, weight);
    });
  }
}

}  // namespace

CandidateInformation candidate_information(const System& system,
                                           const CandidateScene& all,
                                           std::span<const TargetPose> poses,
                                           int threads, bool readings) {
  const auto owners = checked_owners(system, all);
  constexpr std::size_t kChunk = 16;
  const std::size_t chunks = (poses.size() + kChunk - 1) / kChunk;
  std::vector<CandidateInformation> parts(chunks);
  each_with(chunks, {.threads = threads}, [&] {
    return [&, scratch = MeasureScratch(),
            entries = PoseEntries(system, all.candidates.size(), readings)](
               std::size_t c) mutable {
      CandidateInformation& part = parts[c];
      const std::size_t end = std::min(poses.size(), (c + 1) * kChunk);
      for (std::size_t p = c * kChunk; p < end; ++p) {
        entries.clear();
        observe(system, all, owners, poses[p], scratch, entries);
        entries.sort();
        part.always.insert(part.always.end(), entries.always.begin(),
                           entries.always.end());
        part.first.push_back(entries.seen.size());
        part.candidate.insert(part.candidate.end(), entries.seen.begin(),
                              entries.seen.end());
        part.information.insert(part.information.end(), entries.information.begin(),
                                entries.information.end());
        part.first_exact.push_back(entries.exact.size());
        part.exact.insert(part.exact.end(), entries.exact.begin(), entries.exact.end());
        part.first_reading.push_back(entries.reader.size());
        part.reader.insert(part.reader.end(), entries.reader.begin(),
                           entries.reader.end());
        part.readings.insert(part.readings.end(), entries.readings.begin(),
                             entries.readings.end());
      }
    };
  });

  CandidateInformation whole;
  whole.columns = information_size(system);
  whole.first = whole.first_exact = {0};
  if (readings) whole.first_reading = {0};
  const auto append = [](auto& to, const auto& from) {
    to.insert(to.end(), from.begin(), from.end());
  };
  for (CandidateInformation& part : parts) {
    append(whole.always, part.always);
    append(whole.candidate, part.candidate);
    append(whole.information, part.information);
    append(whole.exact, part.exact);
    append(whole.reader, part.reader);
    append(whole.readings, part.readings);
    for (std::size_t i = 0; i < part.first.size(); ++i) {
      whole.first.push_back(whole.first.back() + part.first[i]);
      whole.first_exact.push_back(whole.first_exact.back() + part.first_exact[i]);
      if (readings)
        whole.first_reading.push_back(whole.first_reading.back() +
                                      part.first_reading[i]);
    }
    part = {};
  }
  if (system.fusion == Fusion::continuous && !whole.exact.empty())
    throw std::invalid_argument(
        "rows measured without noise have no information rate; use stacked fusion");
  return whole;
}

}  // namespace delos
