// Writing a scene and reading it again gives the same scene, bit for bit.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

#include "scene/load.h"

namespace delos::test {
namespace {

/// Draws scenes in which every alternative of the format turns up.
class Draw {
 public:
  explicit Draw(unsigned seed) : random_(seed) {}

  int upto(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n + 1)); }
  bool coin() { return upto(1) == 1; }
  /// Numbers with full mantissas, over many magnitudes.
  double number() {
    return std::uniform_real_distribution<double>(-1, 1)(random_) *
           std::pow(10.0, upto(20) - 10);
  }
  double positive() { return std::abs(number()) + 1e-12; }
  Eigen::Vector3d vector() { return {number(), number(), number()}; }
  std::vector<Eigen::Vector3d> vectors() {
    std::vector<Eigen::Vector3d> v;
    for (int i = upto(3); i >= 0; --i) v.push_back(vector());
    return v;
  }
  /// Words that a careless writer would leave unquoted.
  std::string word() {
    const char* const words[] = {
        "plain", "null", "a: b", "- x", "#c",   "'q'",  "\"q\"", "ünïcode", "~",
        "[x",    "1e3",  "*a",   "&a",  "a\\b", "true", "%d",    "{",       "!x",
        "| x",   "@",    "a,b",  "-",   "---",  "?",    "a #b",  "Null",    "`"};
    return words[upto(static_cast<int>(std::size(words)) - 1)];
  }

  Placement placement() {
    Placement p;
    p.at = vector();
    switch (upto(3)) {
      case 0:
        p.facing = Rpy{vector()};
        break;
      case 1:
        p.facing = QuaternionWxyz{{number(), number(), number(), 1}};
        break;
      case 2:
        p.facing = Aim{vector()};
        break;
    }
    return p;
  }

  /// A symmetric positive definite matrix, diagonal half of the time.
  Eigen::MatrixXd noise(int n) {
    Eigen::MatrixXd m = Eigen::MatrixXd::Zero(n, n);
    for (int i = 0; i < n; ++i) m(i, i) = positive();
    if (coin()) return m;
    const Eigen::MatrixXd L = Eigen::MatrixXd::NullaryExpr(
        n, n, [&] { return std::uniform_real_distribution<double>(-1, 1)(random_); });
    m = L * L.transpose() + Eigen::MatrixXd::Identity(n, n);
    return m.selfadjointView<Eigen::Lower>();
  }

  MotionModel motion() {
    MotionModel m;
    m.layout.pose = static_cast<PoseState>(upto(4));
    m.layout.order = 1 + upto(2);
    if (coin()) {
      m.dynamics = ChainMotion{noise(m.layout.coordinates())};
      return m;
    }
    for (int i = upto(2); i > 0; --i) m.layout.extra.push_back("b" + std::to_string(i));
    const int n = m.layout.size();
    const Eigen::MatrixXd A =
        Eigen::MatrixXd::NullaryExpr(n, n, [&] { return number(); });
    if (coin())
      m.dynamics = ContinuousMotion{A, noise(n)};
    else
      m.dynamics = CustomMotion{A, noise(n)};
    return m;
  }

  SampleSet set(int index) {
    SampleSet s;
    if (coin()) s.name = word() == "." ? "" : "set " + std::to_string(index);
    switch (upto(2)) {
      case 0: {
        const Eigen::Vector3d min = vector();
        const Eigen::Vector3d step(positive(), positive(), positive());
        s.shape =
            VolumeSampling{min, min + 2.5 * step,
                           coin() ? step : Eigen::Vector3d::Constant(step.maxCoeff())};
        break;
      }
      case 1:
        s.shape =
            PlaneSampling{vector(), vector(), vector(), {1 + upto(9), 1 + upto(9)}};
        break;
      default:
        s.shape = PointSampling{"", vectors()};
    }
    return s;
  }

  DeviceEntry device(int index, const Scene& scene) {
    DeviceEntry d;
    d.name = word();
    if (d.name.find_first_of(".=") != std::string::npos) d.name = "d";
    d.name += std::to_string(index);
    d.type = "probe";
    d.rate = scene.motion.in_continuous_time() ? positive() : 50;
    if (coin()) d.phase = positive();
    if (scene.motion.is_chain() &&
        (scene.fusion == Fusion::periodic || scene.fusion == Fusion::sequential))
      if (coin()) d.exposure = 0.7 / d.rate;
    if (!scene.groups.empty() && coin()) d.group = scene.groups.front().name;
    d.placement = placement();
    d.params.set("r", std::uniform_real_distribution<double>(0, 2)(random_));
    d.params.set("focal", 1e-3 + positive());
    d.params.set("near", -positive());
    d.params.set("far", positive());
    d.params.set("gain", std::uniform_real_distribution<double>(0, 1)(random_));
    d.params.set("shape", std::string(coin() ? "hexagonal" : "round"));
    d.params.set("resolution", Eigen::MatrixXd(Eigen::Vector2d(1 + positive(), 77)));
    d.params.set("mix", Eigen::MatrixXd::NullaryExpr(1 + upto(2), 1 + upto(2),
                                                     [&] { return number(); }));
    return d;
  }

  Scene scene() {
    Scene s;
    if (coin()) s.name = word();
    s.motion = motion();
    if (s.motion.in_continuous_time() && coin())
      s.fusion = static_cast<Fusion>(1 + upto(3));
    for (int i = upto(2); i >= 0; --i) s.samples.push_back(set(i));
    if (coin()) s.orientations.rpy = vectors();
    if (coin()) s.orientations.combine = OrientationRule::mean;
    if (coin()) s.covariance = CovarianceKind::posterior;
    constexpr const char* kMetrics[] = {"trace", "mle", "det", "coverage", "latency"};
    if (coin()) s.metric = kMetrics[s.devices.size() % std::size(kMetrics)];
    if (coin()) s.markers = vectors();
    for (int i = upto(2); i > 0; --i)
      s.groups.push_back({"rig " + std::to_string(i), placement()});
    for (int i = upto(3); i >= 0; --i) s.devices.push_back(device(i, s));
    return s;
  }

 private:
  std::mt19937 random_;
};

TEST(RoundTrip, KeepsRandomScenes) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    const Scene scene = Draw(seed).scene();
    const std::string text = write_scene(scene);
    const Loaded loaded = load(text);
    // Boxes of two and a half steps are warned of, and turns that go round and round.
    for (const std::string& finding : loaded.findings)
      EXPECT_TRUE(finding.find("without samples: the last ones miss max") !=
                      std::string::npos ||
                  finding.find("more than a full turn") != std::string::npos)
          << finding;
    ASSERT_TRUE(loaded.scene) << "seed " << seed << '\n' << text;
    ASSERT_TRUE(*loaded.scene == scene) << "seed " << seed << '\n' << text;
    ASSERT_EQ(write_scene(*loaded.scene), text);
  }
}

TEST(RoundTrip, TellsScenesApart) {
  // The comparison above must see every part.
  const Scene scene = *load(kGood).scene;
  const auto differs = [&](auto change) {
    Scene other = scene;
    change(other);
    EXPECT_FALSE(other == scene);
    EXPECT_NE(write_scene(other), write_scene(scene));
  };
  differs([](Scene& s) { s.name = "x"; });
  differs([](Scene& s) { std::get<ChainMotion>(s.motion.dynamics).q(1, 1) += 1e-16; });
  differs([](Scene& s) { s.motion.layout.pose = PoseState::orientation; });
  differs([](Scene& s) { s.motion.layout.pose = PoseState::planar_pose; });
  differs([](Scene& s) { s.fusion = Fusion::stacked; });
  differs([](Scene& s) { s.samples[0].name = "x"; });
  differs([](Scene& s) { std::get<VolumeSampling>(s.samples[0].shape).step.z() = 1; });
  differs([](Scene& s) { s.orientations.rpy[0].z() = 1; });
  differs([](Scene& s) { s.markers.push_back({0, 0, 0}); });
  differs([](Scene& s) { s.groups[0].placement.facing = Rpy{{0, 0, 0}}; });
  differs([](Scene& s) { s.devices[0].phase = 1; });
  differs([](Scene& s) { s.devices[0].exposure = 0.01; });
  differs([](Scene& s) { s.devices[0].group = "rig1"; });
  differs([](Scene& s) { s.devices[0].params.set("gain", 0.25); });
  differs([](Scene& s) { s.devices.pop_back(); });
}

TEST(RoundTrip, ComparesMatricesOfOtherSizes) {
  const ChainMotion three{CoordinateMatrix::Identity(3, 3)};
  const ChainMotion six{CoordinateMatrix::Identity(6, 6)};
  EXPECT_FALSE(three == six);
  EXPECT_TRUE(six == six);
  const CustomMotion a{StateMatrix::Identity(3, 3), StateMatrix::Identity(3, 3)};
  const CustomMotion b{StateMatrix::Identity(4, 4), StateMatrix::Identity(4, 4)};
  EXPECT_FALSE(a == b);
}

TEST(RoundTrip, KeepsTheNameOfAPointFile) {
  const Folder folder;
  std::ofstream(folder / "z plane.ptl") << "1 2 3\n";
  const std::string text =
      good_with("volume: {min: [0, 0, 0], max: [0.4, 0.4, 0.8], step: 0.04}",
                "file: z plane.ptl");
  Diagnostics diagnostics;
  const auto scene =
      parse_scene(text, folder / "scene.yaml", {}, plugins(), diagnostics);
  ASSERT_TRUE(scene);
  const std::string written = write_scene(*scene);
  EXPECT_NE(written.find("file: z plane.ptl"), std::string::npos) << written;
  EXPECT_EQ(parse_scene(written, folder / "b.yaml", {}, plugins(), diagnostics), scene);
}

TEST(RoundTrip, KeepsTheScenesOfTheRepository) {
  PluginRegistry devices({DELOS_PLUGINS});
  if (!std::filesystem::is_directory(DELOS_SCENES)) return;
  for (const auto& entry : std::filesystem::directory_iterator(DELOS_SCENES)) {
    if (entry.path().extension() != ".yaml") continue;
    Diagnostics diagnostics;
    const auto scene = load_scene(entry.path(), {}, devices, diagnostics);
    for (const Diagnostic& d : diagnostics) ADD_FAILURE() << to_string(d);
    ASSERT_TRUE(scene) << entry.path();
    EXPECT_EQ(parse_scene(write_scene(*scene), entry.path(), {}, devices, diagnostics),
              scene)
        << entry.path();
  }
}

TEST(RoundTrip, WritesWhatPeopleWouldWrite) {
  EXPECT_EQ(write_scene(*load(kGood).scene),
            R"(delos: 1
name: Good
motion: {type: position_velocity, state: position, q: [0.4, 0.4, 0.1]}
sample: {volume: {min: [0, 0, 0], max: [0.4, 0.4, 0.8], step: 0.04}}
covariance: prior
metric: eigmax
groups: {rig1: {at: [0, 0, 2]}}
devices:
  - name: s1
    type: probe
    rate: 50
    at: [0, 0, 1]
    params:
      r: 0.005
      focal: 0.05
      near: 0.1
      far: 10
      gain: 0.5
      shape: round
      resolution: [640, 480]
      mix: [[1, 0, 0], [0, 1, 0]]
  - name: s2
    type: probe
    rate: 50
    at: [1, 0, 1]
    aim: [0, 0, 0]
    params:
      r: 0.005
      focal: 0.05
      near: 0.1
      far: 10
      gain: 0.5
      shape: round
      resolution: [640, 480]
      mix: [[1, 0, 0], [0, 1, 0]]
)");
}

}  // namespace
}  // namespace delos::test
