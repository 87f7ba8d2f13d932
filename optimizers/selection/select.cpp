#include "delos/optimize/select.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include "delos/field/evaluate.h"
#include "delos/model/metric_table.h"
#include "delos/scene/io.h"
#include "delos/text/format.h"
#include "selection/branch_and_bound.h"
#include "selection/question.h"
#include "selection/seeing.h"
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

namespace {

/// What the field of a choice says that it costs.
double cost_by_field(const Question& q, const Scene& chosen, PluginRegistry& plugins,
                     int threads) {
  const System system = build_system(chosen, plugins);
  double cost = 0;
  for (const VarianceTerm& term : q.terms) {
    FieldOptions options;
    options.threads = threads;
    const Field field = evaluate_field(system, q.samples.samples, chosen.orientations,
                                       term.metric, options);
    double of_term = 0;
    for (std::size_t s = 0; s < field.value.size(); ++s) {
      if (term.samples[s] == 0) continue;
      const double root = field.value[s];
      const double phi = row_of(term.metric.kind).root ? root * root : root;
      of_term = term.maximum ? std::max(of_term, phi) : of_term + term.samples[s] * phi;
    }
    cost += term.weight * of_term;
  }
  return cost;
}

/// @throws std::invalid_argument the field of a choice doesn't say what was certified
void check_by_field(const Question& q, const SelectResult& result, double cost,
                    PluginRegistry& plugins, int threads) {
  const Scene chosen = chosen_scene(q.all, result.chosen);
  if (result.blind > 0 || chosen.devices.empty()) return;
  constexpr double kSame = 1e-6;
  const double by_field = cost_by_field(q, chosen, plugins, threads);
  if (std::abs(by_field - cost) <= kSame * cost) return;
  const Quantity quantity = quantity_of(q);
  throw std::invalid_argument(
      "nothing is proven: of the best choice found the field says " +
      format_quantity(quantity.of(by_field), quantity.unit, 4) + ", not " +
      format_quantity(quantity.of(cost), quantity.unit, 4) +
      ", for a double hasn't the digits: readings that are nearly perfect stand "
      "beside poor ones");
}

}  // namespace

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
  branch.first = judge_blind_samples(*cost, q.rules, q.decisions, branch.stop);
  std::optional<SelectionFile> file;
  std::optional<BranchState> state;
  if (!options.study.empty()) {
    file.emplace(options.study,
                 SelectionKey{write_scene(scene), options.samples, options.seed});
    state = file->load(*cost, q.rules, q.decisions);
    branch.save = [&](const BranchState& at) { file->save(at); };
  }
  const BranchResult found =
      state ? resume_branches(*cost, q.rules, std::move(*state), branch)
            : branch_and_bound(*cost, q.rules, q.decisions, branch);
  check_settled(*cost);
  check_judged(found.best);

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
  result.blind = cost->blind_samples(found.best.chosen).size();
  std::vector<char> available;
  for (const Decision decision : q.decisions)
    available.push_back(decision != Decision::out);
  result.always_blind = cost->blind_samples(available).size();
  check_by_field(q, result, found.best.cost, plugins, options.threads);
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
