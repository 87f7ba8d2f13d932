// Objectives that withstand failures and deviations: against brute force over scenes
// that are written down as they then are, and an optimum that is known in closed form.
#include <unistd.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <numeric>

#include "delos/optimize/select.h"
#include "delos/optimize/study.h"
#include "optimizers/scenes.h"
#include "problem/deviation.h"
#include "problem/worst_case.h"
#include "support/folder.h"
#include "tradeoff/device_count.h"

namespace delos::test {
namespace {

/// The objective of a scene as it stands.
double objective_of(const Scene& scene, std::size_t samples = 200) {
  Problem problem(scene, plugins(), {samples, 1});
  return problem.score(problem.design().start()).objective;
}

/// A scene that withstands nothing, judged as another is, without one of its devices.
Scene plain(Scene scene, double guess, const std::string& missing = "") {
  scene.objective.robust = {};
  scene.objective.guess = guess;
  scene.constraints.clear();
  std::erase_if(scene.devices, [&](const DeviceEntry& d) { return d.name == missing; });
  // Any variable will do: only the scene as it stands is scored.
  scene.variables = {{"motion.q.0", 0.1, 1, ParamScale::linear, {}}};
  return scene;
}

double guess_of(const Scene& scene) {
  return Problem(scene, plugins(), {200, 1}).guess();
}

TEST(WorstCase, IsAboveTheGreatestByLittle) {
  const std::vector<double> values = {0.3, -1.2, 2.5, 2.4};
  const double M = std::sqrt((0.09 + 1.44 + 6.25 + 5.76) / 4);
  for (const double s : {1.0, 30.0, 1000.0}) {
    std::vector<double> slopes(4);
    const double soft = soft_greatest(values, s, slopes.data());
    EXPECT_GT(soft, 2.5 - 1e-15);
    EXPECT_LE(soft, 2.5 + M / s * std::log(4));
    for (std::size_t c = 0; c < 4; ++c) {
      constexpr double kStep = 1e-6;
      std::vector<double> up = values, down = values;
      up[c] += kStep;
      down[c] -= kStep;
      EXPECT_NEAR(slopes[c],
                  (soft_greatest(up, s, nullptr) - soft_greatest(down, s, nullptr)) /
                      (2 * kStep),
                  1e-7)
          << c << " of sharpness " << s;
    }
  }
  EXPECT_EQ(soft_greatest(std::vector<double>{0, 0}, 10, nullptr), 0);
}

TEST(Robust, IsTheWorstOfScenesWithoutADevice) {
  for (const char* name : {"10-better-speakers", "04-motion-capture", "03-hybrid"}) {
    Scene scene =
        load(name, {{"objective", "{minimize: mean, robust: {failures: '*'}}"}});
    if (scene.variables.empty())
      scene.variables = {{"motion.q.0", 0.1, 1, ParamScale::linear, {}}};
    const double guess = guess_of(scene), robust = objective_of(scene);
    double worst = objective_of(plain(scene, guess));
    const double all = worst;
    for (const DeviceEntry& device : scene.devices)
      worst = std::max(worst, objective_of(plain(scene, guess, device.name)));
    // All devices have one rate but those of 03, where the guess stays what it was.
    EXPECT_NEAR(robust, worst,
                (std::string(name) == "03-hybrid" ? 1e-4 : 1e-12) * worst)
        << name;
    EXPECT_GT(robust, 1.01 * all) << name;
    Problem problem(scene, plugins(), {200, 1});
    EXPECT_NEAR(problem.plain_objective(problem.design().start()), all, 1e-12 * all);
  }
}

TEST(Robust, NamesWhatMayFail) {
  const Scene all = load("10-better-speakers");
  const double guess = guess_of(all);
  const Scene some =
      load("10-better-speakers",
           {{"objective",
             "{minimize: p_norm, p: 8, of: eigmax, robust: {failures: [s2, s4]}}"}});
  EXPECT_NEAR(objective_of(some),
              std::max(objective_of(plain(all, guess, "s2")),
                       objective_of(plain(all, guess, "s4"))),
              1e-12);
  EXPECT_EQ(some.objective.robust.failures, (std::vector<std::string>{"s2", "s4"}));
}

/// The scene of a draw, as somebody would write it: devices elsewhere, and noisier.
Scene drawn(Scene scene, const Robustness& robust, int draw) {
  for (DeviceEntry& device : scene.devices) {
    const Deviation by = deviation(robust, draw, device.name);
    const Pose X = device_pose(scene, device);
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    if (by.turn.norm() > 0)
      turn = Eigen::AngleAxisd(by.turn.norm(), by.turn.normalized()).toRotationMatrix();
    const Eigen::Quaterniond q(Eigen::Matrix3d(X.R * turn));
    device.placement = {X.p + by.place, QuaternionWxyz{{q.w(), q.x(), q.y(), q.z()}}};
    // Both noises are r times the square of the distance.
    device.params.set("r", device.params["r"] * std::exp(2 * by.noise));
  }
  return scene;
}

TEST(Robust, IsTheMeanOrTheWorstOfScenesAsTheyAreDrawn) {
  const std::string draws =
      "failures: 'west*', mounting: {at: 5 cm, angle: 2 deg}, noise: 20 %, draws: 5, "
      "seed: 7";
  for (const std::string rule : {"mean", "worst"}) {
    const Scene scene =
        load("04-motion-capture",
             {{"objective",
               "{minimize: mean, robust: {" + draws + ", combine: " + rule + "}}"},
              {"variables", "[{path: devices.west_low.at.z, lower: 0, upper: 3}]"}});
    const double guess = guess_of(scene);
    std::vector<double> each;
    for (int k = 0; k < 5; ++k) {
      const Scene of_draw = drawn(scene, scene.objective.robust, k);
      double worst = objective_of(plain(of_draw, guess));
      for (const char* device : {"west_low", "west_high"})
        worst = std::max(worst, objective_of(plain(of_draw, guess, device)));
      each.push_back(worst);
    }
    const double expected = rule == "worst"
                                ? *std::max_element(each.begin(), each.end())
                                : std::accumulate(each.begin(), each.end(), 0.0) / 5;
    EXPECT_NEAR(objective_of(scene), expected, 1e-9 * expected) << rule;
    EXPECT_GT(*std::max_element(each.begin(), each.end()),
              1.01 * *std::min_element(each.begin(), each.end()));
  }
}

// Standard deviations of 6000 numbers are known within 0.9 % each.
TEST(Deviations, HaveTheStandardDeviationsThatWereGiven) {
  Robustness robust;
  robust.place = 0.02;
  robust.angle = 0.3;
  robust.noise = 0.1;
  robust.seed = 4;
  double place = 0, turn = 0, noise = 0, both = 0;
  constexpr int kDraws = 4000;
  for (int k = 0; k < kDraws; ++k) {
    const Deviation by = deviation(robust, k, "cam");
    place += by.place.squaredNorm();
    turn += by.turn.squaredNorm();
    noise += by.noise * by.noise;
    both += by.place.x() * by.place.y();
    const Deviation opposite = deviation(robust, k ^ 1, "cam");
    EXPECT_EQ(by.place, -opposite.place);
    EXPECT_EQ(by.turn, -opposite.turn);
    EXPECT_EQ(by.noise, -opposite.noise);
    if (k > 1) {
      EXPECT_NE(by.place, deviation(robust, k - 2, "cam").place);
    }
    EXPECT_NE(by.place, deviation(robust, k, "cam2").place);
  }
  EXPECT_NEAR(std::sqrt(place / (3 * kDraws)), 0.02, 0.04 * 0.02);
  EXPECT_NEAR(std::sqrt(turn / (3 * kDraws)), 0.3, 0.04 * 0.3);
  EXPECT_NEAR(std::sqrt(noise / kDraws), 0.1, 0.06 * 0.1);
  EXPECT_LT(std::abs(both / kDraws), 0.08 * 0.02 * 0.02);
}

/// A target in a plane; a speaker of twice the information of two others, all 1 m away
/// and turned about the target; one above pins z.
std::string good_speaker(double first, double second, const std::string& robust) {
  const auto angle = [](double degrees) { return std::to_string(degrees) + " deg"; };
  return kOneTarget + "groups:\n  good: {}\n  one: {rpy: [0, 0, " + angle(first) +
         "]}\n  two: {rpy: [0, 0, " + angle(second) + "]}\n" +
         "devices:\n"
         "  - {name: good, rate: 50, group: good, at: [1, 0, 0], type: acoustic_range, "
         "params: {r: 0.005}}\n"
         "  - {name: one, rate: 50, group: one, at: [1, 0, 0], type: acoustic_range, "
         "params: {r: 0.01}}\n"
         "  - {name: two, rate: 50, group: two, at: [1, 0, 0], type: acoustic_range, "
         "params: {r: 0.01}}\n"
         "  - {name: above, rate: 50, at: [0, 0, 1], type: acoustic_range, params: {r: "
         "1.0e-6}}\n"
         "variables:\n  - {path: groups.one.rpy.yaw}\n  - {path: "
         "groups.two.rpy.yaw}\n" +
         "objective: {minimize: mean, of: eigmax, guess: 100" + robust + "}\n";
}

/// Half the angle between the lines of the two ordinary speakers.
double half_angle(const Scene& scene) {
  const auto yaw = [&](std::size_t group) {
    return std::get<Rpy>(scene.groups[group].placement.facing).angles.z();
  };
  return std::abs(std::remainder(yaw(1) - yaw(2), std::numbers::pi)) / 2;
}

// In units of 1/r the plane's information is S = Σ w u uᵀ, whose least eigenvalue is
// (Σ w − |Σ w exp(2iθ)|)/2. With all speakers it is greatest, 2, where both others
// stand across the good one: without it the target is lost along its line. At 90° ± α
// instead, c = cos 2α,
//
//   without the good one: 1 − c          without another: (3 − √(5 − 4c))/2
//
// are equal, and the lesser of them greatest, at c = √2 − 1: 2 − √2 of what two
// speakers across each other tell.
TEST(KnownOptima, ADeviceThatFailsDoesntBlind) {
  const OptimizeResult ordinary = search(parse(good_speaker(70, 120, "")));
  EXPECT_LT(half_angle(ordinary.scene), 0.02);

  const std::string robust = ", robust: {failures: [good, one, two]}";
  // From where a failure blinds, too.
  for (const double second : {140.0, 91.0}) {
    const OptimizeResult found = search(parse(good_speaker(88, second, robust)));
    EXPECT_NEAR(half_angle(found.scene), std::acos(std::numbers::sqrt2 - 1) / 2, 1e-3)
        << found.best.objective;
    // The value of the same field where only λmin = (2 − √2)/r is left: two speakers
    // across each other, r' = r/(2 − √2).
    const Scene even = parse(
        kOneTarget +
        "devices:\n"
        "  - {name: x, rate: 50, at: [1, 0, 0], type: acoustic_range, params: &p {r: " +
        std::to_string(0.01 / (2 - std::numbers::sqrt2)) +
        "}}\n"
        "  - {name: y, rate: 50, at: [0, 1, 0], type: acoustic_range, params: *p}\n"
        "  - {name: z, rate: 50, at: [0, 0, 1], type: acoustic_range, params: {r: "
        "1.0e-6}}\n"
        "variables: [{path: devices.z.at.z, lower: 0.5, upper: 2}]\n"
        "objective: {minimize: mean, of: eigmax, guess: 100}\n");
    EXPECT_NEAR(found.best.objective, objective_of(even), 1e-3 * objective_of(even));
    EXPECT_GT(found.plain_best, ordinary.best.objective);
    // The ordinary optimum, judged so, is lost.
    Scene blind = ordinary.scene;
    blind.objective.robust.failures = {"good", "one", "two"};
    EXPECT_GT(objective_of(blind), 5 * found.best.objective);
  }
}

TEST(Robust, StudiesResumeBitForBit) {
  const Folder folder;
  const Scene scene = load(
      "10-better-speakers",
      {{"objective",
        "{minimize: mean, robust: {failures: '*', mounting: {at: 2 cm}, noise: 10 %, "
        "draws: 3}}"}});
  const StudyPlan plan = {.evaluations = 60, .starts = 2, .seed = 3, .samples = 100};
  OptimizeOptions options;
  options.threads = 1;
  Study whole = Study::create(folder / "whole", scene, DELOS_SCENES, plan, plugins());
  (void)whole.run(options);
  {
    Study part = Study::create(folder / "part", scene, DELOS_SCENES, plan, plugins());
    std::atomic<bool> cancel = false;
    OptimizeOptions stopped = options;
    stopped.cancel = &cancel;
    stopped.progress = [&](const SearchProgress& at) {
      if (at.evaluations >= 17) cancel = true;  // within a stage
    };
    (void)part.run(stopped);
  }
  Study again(folder / "part", plugins());
  EXPECT_LT(again.evaluations(1).size(), whole.evaluations(1).size());
  options.threads = 2;
  (void)again.run(options);
  EXPECT_EQ(again.dump(), whole.dump());
}

TEST(Robust, DevicesComeAndGoWithTheirFailures) {
  const Scene scene =
      load("09-camera-room", {{"objective.robust", "{failures: [west, east]}"}});
  EXPECT_EQ(without_device(scene, "west").objective.robust.failures,
            std::vector<std::string>{"east"});
  EXPECT_EQ(with_copy(scene, "east").objective.robust.failures,
            (std::vector<std::string>{"west", "east", "east_2"}));
  EXPECT_EQ(with_copy(scene, "south1").objective.robust.failures,
            (std::vector<std::string>{"west", "east"}));
}

TEST(Robust, IsRefusedWhereItMeansNothing) {
  Scene one = load("10-better-speakers", {{"constraints", "[]"}});
  one.devices.resize(1);
  one.variables = {{"devices.s1.at.z", 0.9, 1.2, ParamScale::linear, {}}};
  one.objective.robust.failures = {"s1"};
  EXPECT_THROW(Problem(one, plugins(), {}), std::invalid_argument);
  EXPECT_THROW(
      (void)select(load("12-ceiling-anchors", {{"objective.robust", "{noise: 10 %}"}}),
                   plugins(), {}),
      std::invalid_argument);
}

}  // namespace
}  // namespace delos::test
