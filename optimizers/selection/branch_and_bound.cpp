#include "selection/branch_and_bound.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <queue>
#include <random>

#include "delos/model/infinity.h"

namespace delos {
namespace {

using Clock = std::chrono::steady_clock;

struct Later {
  bool operator()(const BranchNode& a, const BranchNode& b) const {
    return a.bound != b.bound ? a.bound > b.bound : a.number > b.number;
  }
};

class Search {
 public:
  Search(ChoiceCost& cost, const ChoiceRules& rules, const BranchOptions& options)
      : cost_(cost), rules_(rules), options_(options) {
    result_.best.cost = kInfinity;
  }

  BranchResult begin(const std::vector<Decision>& decisions) {
    plant(decisions);
    return run();
  }

  BranchResult resume(BranchState state) {
    result_.best = std::move(state.best);
    result_.nodes = state.nodes;
    result_.root = std::move(state.root);
    closed_ = state.closed;
    for (BranchNode& node : state.open) open_.push(std::move(node));
    return run();
  }

 private:
  [[nodiscard]] bool stopped() const { return options_.stop && options_.stop(); }

  BranchResult run() {
    while (!open_.empty() && !stopped()) {
      BranchNode node = open_.top();
      open_.pop();
      if (node.bound >= cutoff()) {
        close(node.bound);
        continue;
      }
      const std::size_t at = branch_at(node);
      for (const Decision decision : {Decision::in, Decision::out}) {
        BranchNode child = node;
        child.decisions[at] = decision;
        visit(std::move(child));
      }
      tell();
      if (Clock::now() - saved_ > std::chrono::duration<double>(options_.save_every))
        save();
    }
    save();
    result_.bound = bound();
    result_.stopped = !open_.empty();
    tell();
    return std::move(result_);
  }

  void save() {
    if (!options_.save) return;
    BranchState state{result_.best, closed_, result_.nodes, {}, result_.root};
    auto open = open_;
    for (; !open.empty(); open.pop()) state.open.push_back(open.top());
    options_.save(state);
    saved_ = Clock::now();
  }

  /// Nodes whose bound reaches that needn't be looked into.
  [[nodiscard]] double cutoff() const {
    constexpr double kRounding = 1e-9;
    return result_.best.cost * (1 - kRounding) / (1 + options_.gap);
  }
  void close(double bound) { closed_ = std::min(closed_, bound); }

  [[nodiscard]] double bound() const {
    const double open = open_.empty() ? kInfinity : open_.top().bound;
    return std::min({open, closed_, result_.best.cost});
  }

  void tell() const {
    if (options_.progress)
      options_.progress({result_.best.cost, bound(), result_.nodes});
  }

  void offer(std::vector<char> chosen, const std::vector<Decision>& decisions,
             bool thoroughly) {
    Choice choice{std::move(chosen), 0};
    choice.cost = cost_of(cost_, choice.chosen);
    const bool promising = !(choice.cost > 1.1 * result_.best.cost);
    if (thoroughly || promising)
      exchange(cost_, rules_, decisions, choice, options_.stop);
    if (choice.cost < result_.best.cost || result_.best.chosen.empty())
      result_.best = std::move(choice);
  }

  /// The root, and the choices that it suggests.
  void plant(const std::vector<Decision>& decisions) {
    const std::size_t n = rules_.size();
    const ChoicePolytope polytope(rules_, decisions);
    exclude(polytope);
    RelaxationOptions options;
    options.steps = 600;
    options.tolerance = std::clamp(options_.gap / 20, 1e-6, 1e-3);
    options.stop = options_.stop;
    result_.root = relax(cost_, polytope, std::vector<double>(n, 0.0), options);
    const std::vector<double> w = result_.root.w;
    if (!options_.first.empty()) offer(options_.first, polytope.decisions(), true);
    offer(rounded(rules_, polytope.decisions(), w), polytope.decisions(), true);
    std::mt19937_64 random(options_.seed);
    std::vector<double> preference(n);
    for (int k = 0; k < options_.tries && !stopped(); ++k) {
      // Candidate i comes first with a probability that goes with w_i (Efraimidis and
      // Spirakis 2006: the largest of u^(1/w)).
      for (std::size_t i = 0; i < n; ++i) {
        const double u = (static_cast<double>(random() >> 11) + 0.5) * 0x1p-53;
        preference[i] = std::log(u) / std::max(w[i], 1e-6);
      }
      offer(rounded(rules_, polytope.decisions(), preference), polytope.decisions(),
            true);
      tell();
    }
    BranchNode root{result_.root.bound, result_.nodes++, polytope.decisions(), w};
    decide(root, result_.root);
    if (root.bound >= cutoff())
      close(root.bound);
    else
      open_.push(std::move(root));
    tell();
  }

  void exclude(const ChoicePolytope& polytope) {
    std::vector<char> out(rules_.size());
    for (std::size_t i = 0; i < rules_.size(); ++i)
      out[i] = polytope.decisions()[i] == Decision::out;
    cost_.exclude(out);
  }

  /// Decide what the bound's slopes prove: the other way costs too much.
  void decide(BranchNode& node, const Relaxation& relaxation) {
    const auto& linear = relaxation.linear;
    for (std::size_t i = 0; i < rules_.size(); ++i) {
      if (node.decisions[i] != Decision::open) continue;
      // Candidates that are in or out as a whole have no slopes.
      const auto& whole = cost_.whole_ones();
      if (std::binary_search(whole.begin(), whole.end(), i)) continue;
      const double if_in = relaxation.bound + linear.if_in[i];
      const double if_out = relaxation.bound + linear.if_out[i];
      if (if_in >= cutoff()) {
        close(if_in);
        node.decisions[i] = Decision::out;
      } else if (if_out >= cutoff()) {
        close(if_out);
        node.decisions[i] = Decision::in;
      }
    }
  }

  void visit(BranchNode node) {
    node.number = result_.nodes++;
    const ChoicePolytope polytope(rules_, node.decisions);
    if (!polytope.feasible()) return;
    node.decisions = polytope.decisions();
    if (polytope.open().empty()) return leaf(node);
    exclude(polytope);
    RelaxationOptions options;
    options.steps = 80;
    options.cutoff = cutoff();
    options.tolerance = std::clamp(options_.gap / 20, 1e-6, 1e-3);
    options.stop = options_.stop;
    Relaxation relaxation = relax(cost_, polytope, node.w, options);
    node.bound = std::max(node.bound, relaxation.bound);
    if (node.bound >= cutoff()) return close(node.bound);
    node.w = relaxation.w;
    offer(rounded(rules_, node.decisions, node.w), node.decisions, false);
    decide(node, relaxation);
    if (node.bound >= cutoff()) return close(node.bound);
    open_.push(std::move(node));
  }

  /// Everything is decided.
  void leaf(const BranchNode& node) {
    Choice choice{std::vector<char>(rules_.size()), 0};
    for (std::size_t i = 0; i < rules_.size(); ++i)
      choice.chosen[i] = node.decisions[i] == Decision::in;
    choice.cost = cost_of(cost_, choice.chosen);
    close(choice.cost);
    if (choice.cost < result_.best.cost || result_.best.chosen.empty())
      result_.best = std::move(choice);
  }

  /// The most undecided candidate; first those that can't be in by a fraction.
  [[nodiscard]] std::size_t branch_at(const BranchNode& node) const {
    for (const std::size_t i : cost_.whole_ones())
      if (node.decisions[i] == Decision::open) return i;
    std::size_t at = 0;
    double most = -1;
    for (std::size_t i = 0; i < rules_.size(); ++i) {
      if (node.decisions[i] != Decision::open) continue;
      const double undecided = std::min(node.w[i], 1 - node.w[i]);
      if (undecided > most) {
        most = undecided;
        at = i;
      }
    }
    return at;
  }

  ChoiceCost& cost_;
  const ChoiceRules& rules_;
  const BranchOptions& options_;
  BranchResult result_;
  std::priority_queue<BranchNode, std::vector<BranchNode>, Later> open_;
  double closed_ = kInfinity;
  Clock::time_point saved_ = Clock::now();
};

}  // namespace

BranchResult branch_and_bound(ChoiceCost& cost, const ChoiceRules& rules,
                              const std::vector<Decision>& decisions,
                              const BranchOptions& options) {
  return Search(cost, rules, options).begin(decisions);
}

BranchResult resume_branches(ChoiceCost& cost, const ChoiceRules& rules,
                             BranchState state, const BranchOptions& options) {
  return Search(cost, rules, options).resume(std::move(state));
}

}  // namespace delos
