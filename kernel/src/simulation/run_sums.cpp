#include "simulation/run_sums.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <stdexcept>

#include "delos/parallel/in_order.h"
#include "simulation/tally_bytes.h"

namespace delos {
namespace {

/// Runs of a chunk, which one thread makes, and chunks of a part between two exchanges.
constexpr std::size_t kRunsTogether = 16, kChunksTogether = 16;

/// Saves sums of whole chunks, in their order and none left out, every few seconds and
/// at last.
class KeptSums {
 public:
  explicit KeptSums(const SimulationOptions& options) : options_(options) {}

  void before_adding(const Tally& part, const Tally& sums) {
    if (!whole_ || !options_.save) return;
    whole_ = part.runs == kRunsTogether;
    const auto now = std::chrono::steady_clock::now();
    if (whole_ && now - saved_ < std::chrono::seconds(2)) return;
    saved_ = now;
    options_.save(bytes_of(sums));
  }
  void finish(const Tally& sums) {
    if (whole_ && options_.save) options_.save(bytes_of(sums));
  }

 private:
  const SimulationOptions& options_;
  bool whole_ = true;
  std::chrono::steady_clock::time_point saved_ = std::chrono::steady_clock::now();
};

/// The runs of a chunk, one after the other.
class ChunkOfRuns {
 public:
  ChunkOfRuns(const Tally& empty, const TrackRuns& runs, std::size_t wanted,
              std::function<bool()> stopped)
      : part_(empty),
        memory_{empty},
        runs_(runs),
        wanted_(wanted),
        stopped_(std::move(stopped)) {}

  void operator()(std::size_t chunk) {
    part_.clear();
    if (stopped_()) return;
    const std::size_t end = std::min(wanted_, (chunk + 1) * kRunsTogether);
    for (std::size_t r = chunk * kRunsTogether; r < end; ++r)
      runs_.run(r, memory_, part_);
  }
  [[nodiscard]] const Tally& part() const { return part_; }

 private:
  Tally part_;
  TrackRuns::Memory memory_;
  const TrackRuns& runs_;
  std::size_t wanted_;
  std::function<bool()> stopped_;
};

/// The k-th chunk of a part.
struct OwnChunk {
  ChunkOfRuns chunk;
  std::size_t first, step;
  void operator()(std::size_t k) { chunk(first + k * step); }
};

/// How a part begins what it says of a round: tallies follow, nothing, or a sentence.
constexpr char kTallies = 't', kStopped = 's', kFailed = 'f';

/// The tallies of the chunks first + index, first + index + of, … below `end`, as
/// bytes.
template <class Make>
std::string own_share(const SimulationOptions& options, std::size_t first,
                      std::size_t end, Make&& make) {
  const RunParts& parts = options.parts;
  const std::size_t given = end - first;
  const std::size_t own =
      given > parts.index ? (given - parts.index - 1) / parts.of + 1 : 0;
  std::string said(1, kTallies);
  try {
    each_in_order(
        0, own, options.threads,
        [&] {
          return OwnChunk{make(), first + parts.index, parts.of};
        },
        [&](std::size_t, const OwnChunk& own_one) {
          said += bytes_of(own_one.chunk.part());
        });
  } catch (const std::exception& failure) {
    return kFailed + std::string(failure.what());
  }
  if (options.cancel && *options.cancel) return {kStopped};
  return said;
}

/// @throws std::runtime_error the first failure of a part
/// @returns false where a part was asked to stop
bool all_done(const std::vector<std::string>& said) {
  for (const std::string& of : said)
    if (of[0] == kFailed) throw std::runtime_error(of.substr(1));
  return std::none_of(said.begin(), said.end(),
                      [](const std::string& of) { return of[0] == kStopped; });
}

/// The chunks from `first` on, of which each part makes some and hears of all.
template <class Make, class Add>
void add_with_others(const SimulationOptions& options, std::size_t first,
                     std::size_t chunks, const Tally& empty, Make&& make, Add&& add) {
  const std::size_t size = bytes_of(empty).size(), of = options.parts.of;
  Tally part = empty;
  while (first < chunks) {
    const std::size_t end = std::min(chunks, first + of * kChunksTogether);
    const std::vector<std::string> said =
        options.parts.exchange(own_share(options, first, end, make));
    if (!all_done(said)) return;
    for (std::size_t c = 0; c < end - first; ++c) {
      const std::string_view tallies = std::string_view(said[c % of]).substr(1);
      if (tallies.size() < (c / of + 1) * size ||
          !read_bytes(tallies.substr(c / of * size, size), part))
        throw std::runtime_error("another process has sums of other runs");
      add(part);
    }
    first = end;
  }
}

}  // namespace

void add_runs(const TrackRuns& runs, const Tally& empty,
              const SimulationOptions& options, Tally& sums) {
  const auto wanted = static_cast<std::size_t>(options.runs);
  const std::size_t chunks = (wanted + kRunsTogether - 1) / kRunsTogether;
  if (!options.resume.empty() &&
      !(read_bytes(options.resume, sums) && sums.runs <= wanted &&
        sums.runs % kRunsTogether == 0))
    throw std::invalid_argument(
        "what was saved isn't of these runs, or of more of them than are asked for");
  const std::size_t done_before = sums.runs / kRunsTogether;
  const auto stopped = [&] { return options.cancel && *options.cancel; };
  const auto make = [&] { return ChunkOfRuns(empty, runs, wanted, stopped); };
  KeptSums kept(options);
  const auto add = [&](const Tally& part) {
    kept.before_adding(part, sums);
    sums.add(part);
    if (options.progress) options.progress(sums.runs, wanted);
  };
  if (options.parts.exchange)
    add_with_others(options, done_before, chunks, empty, make, add);
  else
    each_in_order(done_before, chunks, options.threads, make,
                  [&](std::size_t, const ChunkOfRuns& chunk) { add(chunk.part()); });
  kept.finish(sums);
}

}  // namespace delos
