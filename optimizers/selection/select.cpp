#include "delos/optimize/select.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include "delos/scene/io.h"
#include "selection/branch_and_bound.h"
#include "selection/question.h"
#include "selection/state_file.h"

namespace delos {

const char* to_string(SelectStop stop) {
  switch (stop) {
    case SelectStop::proven:
      return "proven";
    case SelectStop::time:
      return "time";
    case SelectStop::cancelled:
      return "cancelled";
  }
  return "";
}

SelectResult select(const Scene& scene, PluginRegistry& plugins,
                    const SelectOptions& options) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  const auto elapsed = [&] {
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  Question q = question_of(scene, plugins, options);
  const Quantity quantity = quantity_of(q);
  const std::unique_ptr<FieldCost> cost = cost_of(q, options.threads);
  const std::size_t n = cost->size();

  const auto cancelled = [&] { return options.cancel && *options.cancel; };
  BranchOptions branch;
  branch.gap = quantity.cost_gap(options.gap);
  branch.seed = options.seed;
  branch.stop = [&] { return cancelled() || elapsed() > options.seconds; };
  if (options.progress)
    branch.progress = [&](const BranchProgress& at) {
      options.progress({quantity.of(at.best), quantity.of(at.bound), at.nodes});
    };
  std::optional<SelectionFile> file;
  std::optional<BranchState> state;
  if (!options.study.empty()) {
    file.emplace(options.study,
                 SelectionKey{write_scene(scene), options.samples, options.seed});
    state = file->load();
    branch.save = [&](const BranchState& at) { file->save(at); };
  }
  const BranchResult found =
      state ? resume_branches(*cost, q.rules, std::move(*state), branch)
            : branch_and_bound(*cost, q.rules, q.decisions, branch);
  check_settled(*cost);

  SelectResult result;
  for (std::size_t i = 0; i < n; ++i)
    if (found.best.chosen[i]) result.chosen.push_back(i);
  result.quantity = quantity.text;
  result.unit = quantity.unit;
  result.value = quantity.of(found.best.cost);
  result.lower_bound = quantity.of(found.bound);
  result.gap = result.value / result.lower_bound - 1;
  result.variance_gap = found.best.cost / found.bound - 1;
  result.guess = q.guess;
  result.samples = cost->samples();
  result.fractions = found.root.w;
  result.in_every.assign(n, 0);
  result.in_none.assign(n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    const auto& linear = found.root.linear;
    result.in_every[i] = q.decisions[i] == Decision::in ||
                         found.root.bound + linear.if_out[i] > found.best.cost;
    result.in_none[i] = q.decisions[i] == Decision::out ||
                        found.root.bound + linear.if_in[i] > found.best.cost;
  }
  result.nodes = found.nodes;
  result.stop = !found.stopped ? SelectStop::proven
                : cancelled()  ? SelectStop::cancelled
                               : SelectStop::time;
  result.all = std::move(q.all);
  result.seconds = elapsed();
  return result;
}

}  // namespace delos
