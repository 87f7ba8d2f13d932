#include "delos/optimize/cover.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "cover/check_cover.h"
#include "cover/cover_annealing.h"
#include "cover/cover_core.h"
#include "cover/cover_search.h"
#include "cover/cover_tree.h"
#include "cover/lagrangian.h"
#include "delos/model/infinity.h"
#include "delos/parallel/jobs.h"

namespace delos {
namespace {

/// List entries that a walk reads in the first round, doubled from round to round, and
/// in a late one; those of the largest core that is enumerated, since nodes copy it.
/// A step of the bound reads all, which is more in the largest.
constexpr std::int64_t kFirstWork = 100'000, kMostWork = 20'000'000;
constexpr std::size_t kTreeEntries = 20'000'000;
/// The part of the time that reductions may take.
constexpr double kForReductions = 0.3;

/// Do all tasks, several at once.
void run_all(const std::vector<std::function<void()>>& tasks, int threads) {
  each_job(tasks.size(), worker_count(threads),
           [&](std::size_t k, std::size_t) { tasks[k](); });
}

std::vector<int> uncoverable(const CoverCore& core) {
  std::vector<int> samples = unmet(core);
  for (int& i : samples) i = core.sample[i];
  return samples;
}

bool whole_costs(const CoverProblem& problem) {
  return std::all_of(problem.cost.begin(), problem.cost.end(),
                     [](double c) { return c == std::floor(c) && c < 1e9; });
}

/// A core under search from both sides; costs are those of the whole problem.
class Rounds {
 public:
  Rounds(const CoverProblem& problem, const CoverOptions& options, CoverCore core,
         int threads)
      : problem_(problem),
        options_(options),
        core_(std::move(core)),
        whole_(whole_costs(problem)),
        dual_(core_),
        most_work_(std::max(kMostWork,
                            2 * static_cast<std::int64_t>(core_.seen.items.size()))) {
    const auto seed = [&](std::uint64_t k) {
      return options.seed + 0x9e3779b97f4a7c15ull * k;
    };
    // However little time there is, a cover and some bound there are.
    std::optional<CoverSelection> greedy;
    run_all({[&] { greedy.emplace(core_); }, [&] { dual_.step(kInfinity); }}, threads);
    walks_.emplace_back(core_, *greedy, seed(1));
    if (CoverAnnealing::suits(core_))
      annealing_.emplace(core_, *greedy, seed(2));
    else
      walks_.emplace_back(core_, *greedy, seed(2));
    bound_ = core_.chosen_cost;
    merge();
  }

  /// Search and bound by turns; after each round what they found is shared, so that
  /// threads make no difference.
  void round(int threads) {
    const double limit = cost_ - core_.chosen_cost;
    const double enough =
        std::max(bound_, options_.stop_at.value_or(-kInfinity)) - core_.chosen_cost;
    std::vector<std::function<void()>> tasks;
    tasks.emplace_back([&] { raise_bound(limit); });
    for (CoverSearch& walk : walks_)
      tasks.emplace_back([&] { walk.run(work_, limit, enough); });
    if (annealing_) tasks.emplace_back([&] { annealing_->run(work_, limit, enough); });
    run_all(tasks, threads);
    work_ = std::min(2 * work_, most_work_);
    merge();
  }

  [[nodiscard]] double cost() const { return cost_; }
  [[nodiscard]] double bound() const { return std::min(bound_, cost_); }
  [[nodiscard]] const std::vector<int>& chosen() const { return chosen_; }
  [[nodiscard]] bool proven() const {
    return cost_ < kInfinity && reaches(bound_, cost_, whole_);
  }
  [[nodiscard]] bool infeasible() const {
    return cost_ == kInfinity && tree_ && tree_->done();
  }
  [[nodiscard]] std::int64_t moves() const {
    std::int64_t sum = annealing_ ? annealing_->moves() : 0;
    for (const CoverSearch& walk : walks_) sum += walk.moves();
    return sum;
  }

 private:
  /// Steps of the Lagrangian until it settles, then enumeration.
  void raise_bound(double limit) {
    const auto entries = static_cast<std::int64_t>(core_.seen.items.size());
    for (std::int64_t work = 0; work < work_ && !dual_.settled(); work += 2 * entries)
      dual_.step(limit);
    if (!dual_.settled() || core_.seen.items.size() > kTreeEntries) return;
    if (!tree_)
      tree_ = std::make_unique<CoverTree>(core_, bound_, dual_.multipliers(), whole_);
    tree_->run(work_, limit + core_.chosen_cost);
  }

  void offer(double cost, std::vector<int> chosen) {
    if (!(cost < cost_)) return;
    std::sort(chosen.begin(), chosen.end());
    // Costs are summed in one order, so that equal ones are equal.
    double sum = 0;
    for (const int j : chosen) sum += problem_.cost[j];
    if (!(sum < cost_)) return;
    cost_ = sum;
    chosen_ = std::move(chosen);
  }

  void offer(const CoverSelection& selection) {
    std::vector<int> all = core_.chosen;
    for (const int j : selection.best()) all.push_back(core_.candidate[j]);
    offer(selection.best_cost() + core_.chosen_cost, std::move(all));
  }

  void merge() {
    for (const CoverSearch& walk : walks_) offer(walk.selection());
    if (annealing_) offer(annealing_->selection());
    double bound = core_.chosen_cost + dual_.bound();
    bound -= 1e-9 * std::max(1.0, std::abs(bound));  // roundings of its sum
    if (whole_) bound = std::ceil(bound - 1e-6);
    bound_ = std::max(bound_, bound);
    if (!tree_) return;
    offer(tree_->best_cost(), tree_->best());
    bound_ = std::max(bound_, tree_->bound());
  }

  const CoverProblem& problem_;
  const CoverOptions& options_;
  CoverCore core_;
  bool whole_;
  std::vector<CoverSearch> walks_;
  std::optional<CoverAnnealing> annealing_;
  Lagrangian dual_;
  std::unique_ptr<CoverTree> tree_;
  std::int64_t work_ = kFirstWork, most_work_;
  double cost_ = kInfinity, bound_ = 0;
  std::vector<int> chosen_;
};

CoverStop search(Rounds& rounds, const CoverOptions& options, int threads,
                 std::chrono::steady_clock::time_point deadline) {
  CoverProgress told;
  for (int round = 0;; ++round) {
    const CoverProgress now{rounds.cost(), rounds.bound()};
    if (options.progress && (now.cost < told.cost || now.bound > told.bound))
      options.progress(now);
    told = now;
    if (rounds.proven()) return CoverStop::proven;
    if (rounds.infeasible()) return CoverStop::infeasible;
    if (options.stop_at && rounds.cost() <= *options.stop_at) return CoverStop::target;
    if (options.cancel && options.cancel->load()) return CoverStop::cancelled;
    if (options.rounds > 0 && round >= options.rounds) return CoverStop::budget;
    if (std::chrono::steady_clock::now() >= deadline) return CoverStop::budget;
    rounds.round(threads);
  }
}

}  // namespace

const char* to_string(CoverStop stop) {
  switch (stop) {
    case CoverStop::proven:
      return "proven";
    case CoverStop::target:
      return "target";
    case CoverStop::budget:
      return "budget";
    case CoverStop::cancelled:
      return "cancelled";
    case CoverStop::infeasible:
      return "infeasible";
  }
  return "";
}

std::vector<int> uncoverable(const CoverProblem& problem) {
  check_cover(problem);
  const CoverCore core = core_of(problem);
  return uncoverable(core);
}

bool is_cover(const CoverProblem& problem, const std::vector<int>& candidates) {
  check_cover(problem);
  std::vector<int> count(problem.samples, 0), groups;
  std::vector<char> chosen(problem.candidates(), 0);
  for (const int j : candidates) {
    if (j < 0 || j >= problem.candidates() || chosen[j]) return false;
    chosen[j] = 1;
    for (std::int64_t k = problem.start[j]; k < problem.start[j + 1]; ++k)
      ++count[problem.seen[k]];
    if (!problem.group.empty() && problem.group[j] >= 0)
      groups.push_back(problem.group[j]);
  }
  std::sort(groups.begin(), groups.end());
  if (std::adjacent_find(groups.begin(), groups.end()) != groups.end()) return false;
  for (int j = 0; j < problem.candidates() && !problem.fixed.empty(); ++j)
    if (problem.fixed[j] != Membership::free &&
        (problem.fixed[j] == Membership::in) != static_cast<bool>(chosen[j]))
      return false;
  for (int i = 0; i < problem.samples; ++i)
    if (count[i] < problem.demand[i]) return false;
  return true;
}

CoverAnswer solve_cover(const CoverProblem& problem, const CoverOptions& options) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  check_cover(problem);
  const auto after = [&](double seconds) {
    return begin + std::chrono::duration_cast<Clock::duration>(
                       std::chrono::duration<double>(std::min(seconds, 1e8)));
  };
  CoverCore core = core_of(problem);
  refuse_uncoverable(uncoverable(core));
  const auto enough = after(kForReductions * options.seconds);
  core = reduced(std::move(core), [&] {
    return Clock::now() >= enough || (options.cancel && options.cancel->load());
  });

  CoverAnswer answer;
  answer.samples_left = core.samples();
  answer.candidates_left = core.candidates();
  const int threads = static_cast<int>(worker_count(options.threads));
  Rounds rounds(problem, options, std::move(core), threads);
  answer.stop = search(rounds, options, threads, after(options.seconds));
  answer.chosen = rounds.chosen();
  answer.cost = rounds.cost();
  answer.lower_bound = answer.proven() ? answer.cost : rounds.bound();
  answer.moves = rounds.moves();
  answer.seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  return answer;
}

}  // namespace delos
