// Certified choices, against all choices there are.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <random>

#include "delos/field/evaluate.h"
#include "delos/model/metric_table.h"
#include "selection/branch_and_bound.h"
#include "selection/exchange.h"
#include "selection/field_cost.h"

namespace delos::test {
namespace {

using Random = std::mt19937_64;

double uniform(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}
int whole(Random& random, int low, int high) {
  return std::uniform_int_distribution<int>(low, high)(random);
}

/// A device that a test makes up.
class MadeUp final : public Device {
 public:
  using Observe = std::function<bool(const Target&, Observation&)>;
  MadeUp(Span span, int states, Observe observe)
      : span_(span), states_(states), observe_(std::move(observe)) {}
  [[nodiscard]] Span span() const override { return span_; }
  [[nodiscard]] int state_size() const override { return states_; }
  [[nodiscard]] bool observe(const Target& target, Observation& out) const override {
    return observe_(target, out);
  }

 private:
  Span span_;
  int states_;
  Observe observe_;
};

PlacedDevice placed(const std::string& name, std::shared_ptr<const Device> device,
                    const Eigen::Vector3d& p) {
  PlacedDevice out;
  out.name = out.type = name;
  out.device = std::move(device);
  out.X_WS().p = p;
  out.period = 0.02;
  return out;
}

std::shared_ptr<const Device> range_device(double r) {
  return std::make_shared<MadeUp>(Span::point, 0,
                                  [r](const Target& target, Observation& out) {
                                    const double d = target.p_ST.norm();
                                    out.z.setConstant(1, d);
                                    out.H = target.p_ST.transpose() / d;
                                    out.R.setConstant(1, 1, r * d * d);
                                    return true;
                                  });
}

/// Two angles; seen within `half_angle` of `axis`.
std::shared_ptr<const Device> bearing_device(double sigma, const Eigen::Vector3d& axis,
                                             double half_angle) {
  return std::make_shared<MadeUp>(Span::point, 0,
                                  [=](const Target& target, Observation& out) {
                                    const double d = target.p_ST.norm();
                                    const Eigen::Vector3d u = target.p_ST / d;
                                    if (u.dot(axis.normalized()) < std::cos(half_angle))
                                      return false;
                                    const Eigen::Vector3d a = u.unitOrthogonal();
                                    out.z.setZero(2);
                                    out.H.resize(2, 3);
                                    out.H.row(0) = a.transpose() / d;
                                    out.H.row(1) = u.cross(a).transpose() / d;
                                    out.R = sigma * sigma * Eigen::Matrix2d::Identity();
                                    return true;
                                  });
}

std::shared_ptr<const Device> state_device(const Eigen::MatrixXd& H,
                                           const Eigen::MatrixXd& R) {
  return std::make_shared<MadeUp>(Span::state, static_cast<int>(H.cols()),
                                  [=](const Target&, Observation& out) {
                                    out.z.setZero(H.rows());
                                    out.H = H;
                                    out.R = R;
                                    return true;
                                  });
}

constexpr double kZero = 1e-12;

enum class Kind { range, bearing, camera, general };

/// Something to choose from: devices first the one that is always there, then one a
/// candidate.
struct Instance {
  System system;
  CandidateScene all;
  Samples samples;
  Orientations orientations;
  std::vector<VarianceTerm> terms;
  ChoiceRules rules;
  std::vector<Decision> decisions;
};

void add_samples(Random& random, int count, Instance& out) {
  for (int i = 0; i < count; ++i)
    out.samples.points.emplace_back(uniform(random, -1, 1), uniform(random, -1, 1),
                                    uniform(random, 0, 1));
  out.samples.parts = {{"", 0, out.samples.points.size(), ScatteredShape{}}};
}

void add_device(PlacedDevice device, int candidate, Instance& out) {
  out.system.devices.push_back(std::move(device));
  out.all.of_device.push_back(candidate);
}

void add_pose_devices(Random& random, Kind kind, int n, Instance& out) {
  add_device(placed("always",
                    std::make_shared<MadeUp>(Span::pose, 0,
                                             [](const Target&, Observation& o) {
                                               o.z.setZero(3);
                                               o.H.setIdentity(3, 6);
                                               o.R = 25 * Eigen::Matrix3d::Identity();
                                               return true;
                                             }),
                    {0, 0, 0}),
             -1, out);
  for (int i = 0; i < n; ++i) {
    const Eigen::Vector3d p(uniform(random, -3, 3), uniform(random, -3, 3),
                            uniform(random, 1.5, 3));
    const double noise = std::pow(10, uniform(random, -2.5, -1));
    std::shared_ptr<const Device> device;
    if (kind == Kind::range)
      device = range_device(noise * noise);
    else if (kind == Kind::bearing)
      device = bearing_device(noise, Eigen::Vector3d::UnitZ(), std::numbers::pi);
    else
      device = bearing_device(
          noise,
          Eigen::Vector3d(uniform(random, -1, 1), uniform(random, -1, 1), 0.5) - p,
          uniform(random, 0.15, 0.5));
    add_device(placed("c" + std::to_string(i), std::move(device), p), i, out);
  }
}

/// A random stable or drifting system; some devices measure without noise.
void add_general(Random& random, int n, Instance& out) {
  const int states = whole(random, 3, 6);
  const auto matrix = [&](int rows, int columns) -> Eigen::MatrixXd {
    Eigen::MatrixXd m(rows, columns);
    for (double& x : m.reshaped()) x = uniform(random, -1, 1);
    return m;
  };
  CustomMotion motion;
  Eigen::MatrixXd A = matrix(states, states);
  A *= uniform(random, 0.4, 1.05) / A.eigenvalues().cwiseAbs().maxCoeff();
  // Noise may enter through fewer channels than there are states; but a perfect row
  // about what no noise drives has no steady state.
  const bool perfect = whole(random, 0, 1) == 0;
  const Eigen::MatrixXd B =
      matrix(states, perfect ? 2 * states : whole(random, 2, states));
  motion.A = A;
  motion.Q = B * B.transpose();
  out.system.motion.dynamics = motion;
  out.system.motion.layout = {PoseState::position, 1, {}};
  for (int i = 3; i < states; ++i)
    out.system.motion.layout.extra.push_back("b" + std::to_string(i));
  add_device(placed("always",
                    state_device(Eigen::MatrixXd::Identity(states, states),
                                 100 * Eigen::MatrixXd::Identity(states, states)),
                    {0, 0, 0}),
             -1, out);
  for (int i = 0; i < n; ++i) {
    const int rows = whole(random, 1, 2);
    Eigen::MatrixXd root = matrix(rows, rows);
    // Few without noise, so that something is left to be found out.
    if (i < 2 && perfect) {
      root.row(0).setZero();
      out.system.covariance = CovarianceKind::prior;
    }
    add_device(
        placed("c" + std::to_string(i),
               state_device(matrix(rows, states), root * root.transpose()), {0, 0, 0}),
        i, out);
  }
}

Instance instance_of(Kind kind, std::uint64_t seed) {
  Random random(1000 * static_cast<std::uint64_t>(kind) + seed);
  Instance out;
  // Now and then as many as are asked for; small ones are tried all the sooner.
  const int n = seed % 25 == 0 ? 16 : whole(random, 3, 8);
  out.system.covariance =
      whole(random, 0, 1) ? CovarianceKind::prior : CovarianceKind::posterior;
  out.system.markers = {Eigen::Vector3d::Zero()};
  if (kind == Kind::general) {
    add_samples(random, 1, out);
    add_general(random, n, out);
  } else {
    const int order = whole(random, 1, 3);
    const CoordinateMatrix q =
        CoordinateMatrix::Identity(3, 3) * uniform(random, .1, 2);
    out.system.motion = {{PoseState::position, order, {}}, ChainMotion{q}};
    out.system.fusion = whole(random, 0, 3) ? Fusion::stacked : Fusion::continuous;
    add_samples(random, whole(random, 1, 5), out);
    add_pose_devices(random, kind, n, out);
  }
  static const char* kMetrics[] = {"sigma_position", "eigmax", "sigma_x", "trace",
                                   "eiglen"};
  const auto metric = std::get<Metric>(
      parse_metric(kMetrics[whole(random, 0, 4)], out.system.motion.layout));
  const double each = 1 / static_cast<double>(out.samples.points.size());
  out.terms = {{metric, 1, whole(random, 0, 2) == 0,
                std::vector<double>(out.samples.points.size(), each)}};
  const bool by_count = whole(random, 0, 1) == 0;
  for (int i = 0; i < n; ++i) {
    out.all.candidates.push_back({"c" + std::to_string(i)});
    out.rules.cost.push_back(by_count ? 1 : uniform(random, 0.5, 3));
    out.rules.spot.push_back(whole(random, 0, 1) ? i / 2 : -1);
    const int decided = whole(random, 0, 11);
    out.decisions.push_back(decided == 0 && i % 4 == 0 ? Decision::in
                            : decided == 1             ? Decision::out
                                                       : Decision::open);
  }
  out.rules.budget = by_count ? whole(random, 2, n > 8 ? 4 : 5) : uniform(random, 3, 6);
  double kept = 0;
  for (int i = 0; i < n; ++i) {
    const auto c = static_cast<std::size_t>(i);
    if (out.decisions[c] == Decision::in) kept += out.rules.cost[c];
  }
  if (kept > out.rules.budget) out.rules.budget = kept;
  return out;
}

/// The same number by the program's ordinary way: a field of the chosen devices.
double ordinary_cost(const Instance& instance, std::uint32_t chosen) {
  System system = instance.system;
  system.devices.clear();
  for (std::size_t i = 0; i < instance.system.devices.size(); ++i) {
    const int c = instance.all.of_device[i];
    if (c < 0 || (chosen >> c & 1))
      system.devices.push_back(instance.system.devices[i]);
  }
  double total = 0;
  for (const VarianceTerm& term : instance.terms) {
    const Field field = evaluate_field(system, instance.samples, instance.orientations,
                                       term.metric, {.threads = 1});
    double of_term = 0;
    for (std::size_t s = 0; s < field.value.size(); ++s) {
      const double v = row_of(term.metric.kind).root ? field.value[s] * field.value[s]
                                                     : field.value[s];
      of_term = term.maximum ? std::max(of_term, v) : of_term + term.samples[s] * v;
    }
    total += term.weight * of_term;
  }
  return total;
}

/// The least over all choices that the rules and decisions allow.
double least_of_all(const Instance& instance) {
  const std::size_t n = instance.rules.size();
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t set = 0; set < (1U << n); ++set) {
    double cost = 0;
    std::uint64_t spots = 0;
    bool allowed = true;
    for (std::size_t i = 0; i < n; ++i) {
      const bool in = set >> i & 1;
      if (instance.decisions[i] != Decision::open &&
          in != (instance.decisions[i] == Decision::in))
        allowed = false;
      if (!in) continue;
      cost += instance.rules.cost[i];
      if (instance.rules.spot[i] < 0) continue;
      const std::uint64_t bit = std::uint64_t{1} << instance.rules.spot[i];
      if (spots & bit) allowed = false;
      spots |= bit;
    }
    if (!allowed || cost > instance.rules.budget * (1 + 1e-12)) continue;
    least = std::min(least, ordinary_cost(instance, set));
  }
  return least;
}

FieldCost cost_of(const Instance& i) {
  return {i.system, i.all, i.samples, i.orientations, i.terms, 0, 1};
}

class Choices : public testing::TestWithParam<Kind> {};

// 4 × 125 instances of up to 16 candidates, each against every choice there is.
TEST_P(Choices, AreTheBestThereAreAndBoundsStayBelow) {
  int whole_ones = 0, split = 0;
  for (std::uint64_t seed = 0; seed < 125; ++seed) {
    const Instance instance = instance_of(GetParam(), seed);
    const ChoicePolytope polytope(instance.rules, instance.decisions);
    if (!polytope.feasible()) continue;
    const double least = least_of_all(instance);
    FieldCost cost = cost_of(instance);
    whole_ones += !cost.whole_ones().empty();
    const BranchResult found =
        branch_and_bound(cost, instance.rules, instance.decisions, {});
    SCOPED_TRACE(seed);
    ASSERT_FALSE(found.stopped);
    // Without noise the least may be zero but for rounding.
    EXPECT_NEAR(found.best.cost, least, 1e-7 * least + kZero);
    EXPECT_LE(found.bound, least * (1 + 1e-9) + kZero);
    EXPECT_GE(found.bound, least * (1 - 1e-7) - kZero);
    EXPECT_LE(found.root.bound, least * (1 + 1e-9) + kZero);
    EXPECT_TRUE(instance.rules.allow(found.best.chosen));
    EXPECT_FALSE(cost.unsettled());
    split += found.nodes > 1;

    // Stopped early, what it says holds all the same.
    int asked = 0;
    BranchOptions options;
    options.tries = 0;
    options.stop = [&] { return ++asked > 12; };
    const BranchResult early =
        branch_and_bound(cost, instance.rules, instance.decisions, options);
    EXPECT_LE(early.bound, least * (1 + 1e-9) + kZero);
    EXPECT_GE(early.best.cost, least * (1 - 1e-9) - kZero);
    // What it proves of single candidates doesn't rule out the best choice.
    for (std::size_t i = 0; i < instance.rules.size(); ++i) {
      const auto& linear = early.root.linear;
      const double other = found.best.chosen[i] ? linear.if_in[i] : linear.if_out[i];
      EXPECT_LE(early.root.bound + other, least * (1 + 1e-7) + kZero);
    }
  }
  EXPECT_GT(split, 20);
  if (GetParam() == Kind::general) {
    EXPECT_GT(whole_ones, 50);
  }
}

std::string name_of_kind(const testing::TestParamInfo<Kind>& info) {
  static const char* kNames[] = {"range", "bearing", "camera", "general"};
  return kNames[static_cast<int>(info.param)];
}

INSTANTIATE_TEST_SUITE_P(Kinds, Choices,
                         testing::Values(Kind::range, Kind::bearing, Kind::camera,
                                         Kind::general),
                         name_of_kind);

std::vector<double> random_fractions(Random& random, std::size_t n) {
  std::vector<double> w(n);
  for (double& x : w) x = uniform(random, 0.05, 1);
  return w;
}

// Slopes are those of differences, and the tangent stays below the cost everywhere.
TEST(FieldCost, HasTheSlopesOfDifferencesAndATangentBelow) {
  Random random(7);
  for (const Kind kind : {Kind::range, Kind::bearing, Kind::camera, Kind::general}) {
    for (std::uint64_t seed = 200; seed < 230; ++seed) {
      Instance instance = instance_of(kind, seed);
      if (kind != Kind::general)
        instance.orientations.rpy = {{0, 0, 0}, {0, 0, 1}, {0.4, 0, 2}};
      instance.orientations.combine = static_cast<OrientationRule>(seed % 3);
      instance.system.markers = {{0.1, 0, 0}, {0, 0.2, 0.1}};
      SCOPED_TRACE(std::to_string(static_cast<int>(kind)) + ' ' + std::to_string(seed));
      FieldCost cost = cost_of(instance);
      const std::size_t n = cost.size();
      // Candidates without noise are in, and stay so.
      std::vector<double> w = random_fractions(random, n),
                          v = random_fractions(random, n);
      for (const std::size_t i : cost.whole_ones()) w[i] = v[i] = 1;
      Tangent tangent, other;
      ASSERT_TRUE(cost.tangent(w, 50, tangent));
      EXPECT_GE(tangent.smooth, cost.value(w) * (1 - 1e-12));
      EXPECT_LE(tangent.level, cost.value(w) * (1 + 1e-12));
      double below = tangent.level;
      for (std::size_t i = 0; i < n; ++i) below += tangent.slope[i] * (v[i] - w[i]);
      EXPECT_LE(below, cost.value(v) * (1 + 1e-9) + kZero);
      for (std::size_t i = 0; i < n; ++i) {
        const double h = 1e-4;
        std::vector<double> up = w, down = w;
        up[i] += h;
        down[i] -= h;
        ASSERT_TRUE(cost.tangent(up, 50, other));
        const double above = other.smooth;
        ASSERT_TRUE(cost.tangent(down, 50, other));
        EXPECT_NEAR(tangent.slope[i], (above - other.smooth) / (2 * h),
                    1e-4 * tangent.smooth + 1e-4 * std::abs(tangent.slope[i]) + 1e-9);
      }
    }
  }
}

TEST(FieldCost, IsTheOrdinaryFieldsAndSoAreItsChanges) {
  for (const Kind kind : {Kind::range, Kind::camera, Kind::general}) {
    for (std::uint64_t seed = 300; seed < 320; ++seed) {
      Instance instance = instance_of(kind, seed);
      if (kind != Kind::general) instance.orientations.rpy = {{0, 0, 0}, {0, 0, 1}};
      instance.orientations.combine = static_cast<OrientationRule>(seed % 3);
      instance.system.prior = seed % 2 == 0 ? 0 : 10;
      FieldCost cost = cost_of(instance);
      const std::size_t n = cost.size();
      const std::uint32_t set = 0b101;
      std::vector<char> chosen(n, 0);
      chosen[0] = chosen[2] = 1;
      const double least = ordinary_cost(instance, set);
      EXPECT_NEAR(cost.value(std::vector<double>(chosen.begin(), chosen.end())), least,
                  1e-8 * least);
      const auto costs =
          cost.changed(chosen, std::vector<Change>{{1, 0}, {1}, {Change::kNobody, 2}});
      EXPECT_NEAR(costs[0], ordinary_cost(instance, 0b110), 1e-8 * costs[0]);
      EXPECT_NEAR(costs[1], ordinary_cost(instance, 0b111), 1e-8 * costs[1]);
      EXPECT_NEAR(costs[2], ordinary_cost(instance, 0b001), 1e-8 * costs[2]);
    }
  }
}

// Greedy choice isn't the answer. Ye, Roy, Sundaram (2017), On the complexity and
// approximability of optimal sensor selection for Kalman filtering: with these three
// sensors, no noise and two to choose, greedy's share of the optimum tends to
// 2/3 + 1/(3 (1 − λ²)) as h grows, here 4.09.
TEST(Selections, FindWhatGreedyMissesByAFactorOfFour) {
  const double lambda = 0.95, h = 1000;
  Instance instance;
  CustomMotion motion;
  motion.A = Eigen::Vector3d(lambda, 0, 0).asDiagonal();
  motion.Q = Eigen::Matrix3d::Identity();
  instance.system.motion = {{PoseState::position, 1, {}}, motion};
  instance.system.markers = {Eigen::Vector3d::Zero()};
  instance.samples = {{Eigen::Vector3d::Zero()}, {{"", 0, 1, ScatteredShape{}}}};
  const Eigen::RowVector3d rows[] = {{1, h, h}, {1, 0, h}, {0, 1, 1}};
  for (int i = 0; i < 3; ++i) {
    add_device(placed("c" + std::to_string(i),
                      state_device(rows[i], Eigen::MatrixXd::Zero(1, 1)), {0, 0, 0}),
               i, instance);
    instance.all.candidates.push_back({"c" + std::to_string(i)});
  }
  instance.rules = {{1, 1, 1}, {-1, -1, -1}, 2};
  instance.decisions.assign(3, Decision::open);
  instance.terms = {
      {std::get<Metric>(parse_metric("trace", instance.system.motion.layout)),
       1,
       false,
       {1}}};

  std::uint32_t greedy = 0;
  for (int step = 0; step < 2; ++step) {
    std::uint32_t best = 0;
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t with = greedy | 1U << i;
      if (with == greedy) continue;
      if (best == 0 || ordinary_cost(instance, with) < ordinary_cost(instance, best))
        best = with;
    }
    greedy = best;
  }
  FieldCost cost = cost_of(instance);
  const BranchResult found =
      branch_and_bound(cost, instance.rules, instance.decisions, {});
  EXPECT_NEAR(found.best.cost, 3, 1e-6);  // x₁ is known, the others are new each time
  EXPECT_NEAR(found.bound, 3, 1e-6);
  EXPECT_EQ(found.best.chosen, (std::vector<char>{1, 0, 1}));
  EXPECT_NEAR(ordinary_cost(instance, greedy) / found.best.cost,
              2.0 / 3 + 1 / (3 * (1 - lambda * lambda)), 0.01);
}

// ---- exchanges ----

/// What each candidate is worth, off a cost that all of them would bring to nothing.
class Worths final : public ChoiceCost {
 public:
  explicit Worths(std::vector<double> worth) : worth_(std::move(worth)) {}
  [[nodiscard]] std::size_t size() const override { return worth_.size(); }
  [[nodiscard]] double value(std::span<const double> w) override {
    double left = std::accumulate(worth_.begin(), worth_.end(), 0.0);
    for (std::size_t i = 0; i < w.size(); ++i) left -= w[i] * worth_[i];
    return left;
  }
  [[nodiscard]] std::vector<double> changed(std::span<const char> chosen,
                                            std::span<const Change> changes) override {
    std::vector<double> costs;
    for (const Change& change : changes) {
      std::vector<double> w(chosen.begin(), chosen.end());
      if (change.in != Change::kNobody) w[change.in] = 1;
      if (change.out != Change::kNobody) w[change.out] = 0;
      costs.push_back(value(w));
    }
    return costs;
  }
  bool tangent(std::span<const double>, double, Tangent&) override { return false; }
  [[nodiscard]] const std::vector<std::size_t>& whole_ones() const override {
    return none_;
  }
  void exclude(std::span<const char>) override {}

 private:
  std::vector<double> worth_;
  std::vector<std::size_t> none_;
};

// Of a budget of 6, 4 are spent: the best candidate fits in the place of the chosen one
// alone, and then one of 2 beside it.
TEST(Exchanges, SpendWhatTheyFree) {
  Worths cost({1, 5, 2});
  const ChoiceRules rules{{4, 4, 2}, {-1, -1, -1}, 6};
  Choice choice{{1, 0, 0}, 7};
  exchange(cost, rules, std::vector<Decision>(3, Decision::open), choice, {});
  EXPECT_EQ(choice.chosen, (std::vector<char>{0, 1, 1}));
  EXPECT_EQ(choice.cost, 1);
}

// ---- the polytope ----

// One of a spot, worth 3, 2 and −1: the minimum is −3. With the second it is −2, with
// the third 1; without the first −2.
TEST(ChoicePolytope, TellsWhatDecidingOtherwiseCosts) {
  const ChoiceRules rules{{1, 1, 1}, {7, 7, 7}, 3};
  const ChoicePolytope polytope(rules, std::vector<Decision>(3, Decision::open));
  const auto bound = polytope.linear_bound(std::vector<double>{-3, -2, 1});
  EXPECT_EQ(bound.value, -3);
  EXPECT_EQ(bound.if_in, (std::vector<double>{0, 1, 4}));
  EXPECT_EQ(bound.if_out, (std::vector<double>{1, 0, 0}));
}

/// min g·w by trying every vertex of a small polytope with unit costs: whole choices.
TEST(ChoicePolytope, BoundsLinearCostsFromBelowAndExactlyWhereAllCostTheSame) {
  Random random(3);
  for (int trial = 0; trial < 300; ++trial) {
    const int n = whole(random, 1, 9);
    const bool equal = trial % 2 == 0;
    ChoiceRules rules;
    std::vector<double> g;
    std::vector<Decision> decisions;
    for (int i = 0; i < n; ++i) {
      rules.cost.push_back(equal ? 1 : uniform(random, 0.3, 2));
      rules.spot.push_back(whole(random, -1, 3));
      g.push_back(-uniform(random, 0, 1));
      decisions.push_back(whole(random, 0, 6) ? Decision::open : Decision::out);
    }
    rules.budget = equal ? whole(random, 1, 4) : uniform(random, 0.5, 4);
    const ChoicePolytope polytope(rules, decisions);
    const auto bound = polytope.linear_bound(g);
    double least = 0;
    std::vector<double> if_in(static_cast<std::size_t>(n), 1e9), if_out = if_in;
    for (std::uint32_t set = 0; set < (1U << n); ++set) {
      std::vector<char> chosen;
      double value = 0;
      bool allowed = true;
      for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) {
        chosen.push_back(static_cast<char>(set >> i & 1));
        if (!chosen[i]) continue;
        value += g[i];
        if (decisions[i] == Decision::out) allowed = false;
      }
      if (!allowed || !rules.allow(chosen)) continue;
      least = std::min(least, value);
      for (std::size_t i = 0; i < chosen.size(); ++i) {
        auto& least_with = chosen[i] ? if_in[i] : if_out[i];
        least_with = std::min(least_with, value);
      }
    }
    EXPECT_LE(bound.value, least + 1e-12);
    if (equal) {
      EXPECT_NEAR(bound.value, least, 1e-9);
    }
    for (const std::size_t i : polytope.open()) {
      EXPECT_LE(bound.value + bound.if_in[i], if_in[i] + 1e-9);
      EXPECT_LE(bound.value + bound.if_out[i], if_out[i] + 1e-9);
    }
  }
}

// The nearest point: (z − w)·(v − w) ≤ 0 for every v of the polytope.
TEST(ChoicePolytope, ProjectsToTheNearestPoint) {
  Random random(4);
  for (int trial = 0; trial < 300; ++trial) {
    const auto n = static_cast<std::size_t>(whole(random, 1, 9));
    ChoiceRules rules;
    std::vector<Decision> decisions;
    std::vector<double> z;
    for (std::size_t i = 0; i < n; ++i) {
      rules.cost.push_back(uniform(random, 0.3, 2));
      rules.spot.push_back(whole(random, -1, 3));
      decisions.push_back(whole(random, 0, 6) ? Decision::open : Decision::out);
      z.push_back(uniform(random, -1, 2));
    }
    rules.budget = uniform(random, 0.5, 4);
    const ChoicePolytope polytope(rules, decisions);
    std::vector<double> w = z;
    polytope.project(w);
    const auto inside = [&](const std::vector<double>& v, double slack) {
      double cost = 0, spots[5] = {};
      for (std::size_t i = 0; i < n; ++i) {
        if (v[i] < -slack || v[i] > 1 + slack) return false;
        if (polytope.decisions()[i] == Decision::out && v[i] != 0) return false;
        cost += rules.cost[i] * v[i];
        if (rules.spot[i] >= 0) spots[rules.spot[i]] += v[i];
      }
      return cost <= rules.budget + slack &&
             *std::max_element(spots, spots + 5) <= 1 + slack;
    };
    EXPECT_TRUE(inside(w, 1e-9));
    for (int other = 0; other < 200; ++other) {
      std::vector<double> v(n, 0.0);
      for (const std::size_t i : polytope.open()) v[i] = uniform(random, 0, 1);
      if (!inside(v, 0)) continue;
      double angle = 0;
      for (std::size_t i = 0; i < n; ++i) angle += (z[i] - w[i]) * (v[i] - w[i]);
      EXPECT_LE(angle, 1e-8);
    }
  }
}

}  // namespace
}  // namespace delos::test
