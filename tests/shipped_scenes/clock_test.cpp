// Devices that share a clock: satellites, pseudoranges and time differences.
#include <Eigen/LU>
#include <numbers>
#include <sstream>

#include "delos/field/point.h"
#include "delos/scene/definition.h"
#include "shipped_scenes/shipped.h"

namespace delos::test {
namespace {

/// Pseudoranges of 1 m from one anchor overhead and `around` at an elevation, far away.
std::string sky(double elevation, int around, const std::string& overhead = "rx") {
  constexpr double kFar = 1000;
  std::ostringstream text;
  text.precision(17);
  text << "delos: 1\n"
          "motion: {type: position, q: [1, 1, 1]}\n"
          "covariance: single\n"
          "sample: {points: [[0, 0, 0]]}\n"
          "devices:\n"
          "  - {name: up, type: uwb_range, rate: 1, at: [0, 0, "
       << kFar << "], clock: " << overhead << ", params: {sigma: 1 m, reach: 1 Gm}}\n";
  for (int k = 0; k < around; ++k) {
    const double azimuth = 2 * std::numbers::pi * k / around;
    text << "  - {name: s" << k << ", type: uwb_range, rate: 1, at: ["
         << kFar * std::cos(elevation) * std::cos(azimuth) << ", "
         << kFar * std::cos(elevation) * std::sin(azimuth) << ", "
         << kFar * std::sin(elevation)
         << "], clock: rx, params: {sigma: 1 m, reach: 1 Gm}}\n";
  }
  return text.str();
}

/// With n anchors around at an elevation whose sine is s, HᵀH is diagonal but for z and
/// the clock: VDOP² = (n + 1)/D, TDOP² = (n s² + 1)/D with D = n (1 − s)², and
/// HDOP² = 4/(n cos²).
TEST(Clock, IsSolvedForBesideThePosition) {
  for (const int n : {3, 4, 7})
    for (const double elevation : {0.1, 0.6, 1.2}) {
      const Scene scene = scene_of(sky(elevation, n));
      const double s = std::sin(elevation), c = std::cos(elevation);
      const double D = n * (1 - s) * (1 - s);
      const auto near = [&](const char* metric, double expected) {
        EXPECT_NEAR(value_of(scene, metric), expected, 1e-9 * expected)
            << metric << " " << n << " " << elevation;
      };
      near("sigma_z", std::sqrt((n + 1) / D));
      near("sigma_clock_rx", std::sqrt((n * s * s + 1) / D));
      near("sigma_horizontal", std::sqrt(4 / (n * c * c)));
      near("sigma_position", std::sqrt(4 / (n * c * c) + (n + 1) / D));
    }
}

/// What is left of pseudoranges where the clock is eliminated: the differences to one
/// of them, z_i − z_0, with R = I + 1 1ᵀ of their shared noise. By Eigen's inverse.
TEST(Clock, LeavesWhatTimeDifferencesKnow) {
  const Scene scene = scene_of(R"(delos: 1
motion: {type: position_velocity, q: [0.4, 0.4, 0.1]}
covariance: single
sample: {volume: {min: [0.5, 0.5, 0.3], max: [6, 4, 2.1], step: [1.1, 0.875, 0.6]}}
metric: trace
devices:
  - {name: a, type: uwb_range, rate: 10, at: [0, 0, 2.9], clock: tag, params: &u {sigma: 0.2 m}}
  - {name: b, type: uwb_range, rate: 10, at: [7, 0, 0.2], clock: tag, params: *u}
  - {name: c, type: uwb_range, rate: 10, at: [7, 5, 2.7], clock: tag, params: *u}
  - {name: d, type: uwb_range, rate: 10, at: [0, 5, 0.4], clock: tag, params: *u}
  - {name: e, type: uwb_range, rate: 10, at: [3, 2, 3.0], clock: tag, params: *u}
)");
  const Field field = field_of(scene);
  ASSERT_GT(field.value.size(), 60u);
  for (std::size_t i = 0; i < field.value.size(); ++i) {
    const auto direction = [&](std::size_t k) -> Eigen::RowVector3d {
      return (field.samples.points[i] - scene.devices[k].placement.at)
          .normalized()
          .transpose();
    };
    Eigen::Matrix<double, 4, 3> H;
    for (int k = 0; k < 4; ++k)
      H.row(k) = direction(static_cast<std::size_t>(k) + 1) - direction(0);
    const Eigen::Matrix4d R =
        0.04 * (Eigen::Matrix4d::Identity() + Eigen::Matrix4d::Ones());
    const double trace = (H.transpose() * R.inverse() * H).inverse().trace();
    EXPECT_NEAR(field.value[i], trace, 1e-8 * trace) << i;
  }
}

/// An offset of one's own says nothing; two clocks want a reading more than one.
TEST(Clock, TakesAReadingOfEachClock) {
  EXPECT_TRUE(std::isfinite(value_of(scene_of(sky(0.5, 3)), "sigma_position")));
  EXPECT_TRUE(std::isinf(value_of(scene_of(sky(0.5, 3, "own")), "sigma_position")));
  EXPECT_TRUE(std::isfinite(value_of(scene_of(sky(0.5, 4)), "sigma_position")));
  // Around at one elevation, z and their clock are one direction.
  EXPECT_TRUE(std::isinf(value_of(scene_of(sky(0.5, 4, "own")), "sigma_z")));
  EXPECT_NEAR(value_of(scene_of(sky(0.5, 4, "own")), "sigma_horizontal"),
              value_of(scene_of(sky(0.5, 4)), "sigma_horizontal"), 1e-9);
}

/// A state has 30 numbers at most: three of the position and 27 clocks.
TEST(Clock, IsRefusedWhereTheyAreTooMany) {
  const auto findings_of = [](int clocks) {
    std::string text = sky(0.5, clocks - 1, "own");
    for (int k = 0; k < clocks - 1; ++k) {
      const std::size_t at = text.find("clock: rx");
      text.replace(at, 9, "clock: c" + std::to_string(k));
    }
    Diagnostics findings;
    (void)parse_scene(text, "scene.yaml", {}, plugins(), findings);
    return findings;
  };
  EXPECT_TRUE(findings_of(27).empty());
  const Diagnostics findings = findings_of(28);
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_NE(to_string(findings[0]).find("31 numbers are unknown; at most 30"),
            std::string::npos)
      << to_string(findings[0]);
}

TEST(Clock, IsAStateOfSingleReadings) {
  const Scene scene = scene_of(sky(0.5, 3));
  EXPECT_EQ(covariance_layout(scene).names(),
            (std::vector<std::string>{"x", "y", "z", "clock_rx"}));
  EXPECT_EQ(scene_of(write_scene(scene)), scene);
}

// ---- six anchors of ranges of 10 cm, one blink ----

constexpr double kSixAnchors[6][3] = {{0, 0, 0}, {6, 0, 3}, {6, 6, 0},
                                      {0, 6, 3}, {3, 0, 3}, {3, 6, 0}};

std::string six_anchors(const std::string& header, const std::string& at,
                        const std::string& clock) {
  std::ostringstream text;
  text << "delos: 1\nmotion: {type: position_velocity, q: [0.4, 0.4, 0.1]}\n"
       << header << "sample: {points: [" << at << "]}\ndevices:\n";
  for (const auto& a : kSixAnchors)
    text << "  - {name: a" << &a - kSixAnchors << ", type: range, rate: 10 Hz, at: ["
         << a[0] << ", " << a[1] << ", " << a[2] << "]" << clock
         << ", params: {sigma: 10 cm}}\n";
  return text.str();
}

// By a script of its own, to a millimetre: ranges, and all their differences.
TEST(TimeDifferences, AreWorseThanRangesOutsideTheirAnchors) {
  const auto sigmas = [](const char* at, const char* clock) {
    const Scene scene = scene_of(six_anchors("covariance: single\n", at, clock));
    return Eigen::Vector3d(value_of(scene, "sigma_x"), value_of(scene, "sigma_y"),
                           value_of(scene, "sigma_z"));
  };
  const auto expect = [](const Eigen::Vector3d& metres, double x, double y, double z) {
    EXPECT_LT((1000 * metres - Eigen::Vector3d(x, y, z)).cwiseAbs().maxCoeff(), 0.51)
        << metres.transpose();
  };
  const char *inside = "[3, 3, 1]", *outside = "[9, 3, 1]", *shared = ", clock: tag";
  expect(sigmas(inside, ""), 75, 61, 119);
  expect(sigmas(inside, shared), 75, 62, 126);
  expect(sigmas(outside, ""), 53, 120, 239);
  expect(sigmas(outside, shared), 359, 121, 249);
}

/// P∞ before an update, at the first sample.
StateMatrix tracked(const std::string& text) {
  const Scene scene = scene_of(text);
  const System system = build_system(scene, plugins());
  const auto trace = std::get<Metric>(parse_metric("trace", scene.motion.layout));
  Pose pose;
  pose.p = make_samples(scene.samples).points.front();
  return evaluate_point(system, pose, trace).state.prior;
}

/// Rows of a matrix as a scene has them.
std::string rows_text(const Eigen::MatrixXd& m) {
  std::ostringstream text;
  text.precision(17);
  for (Eigen::Index i = 0; i < m.rows(); ++i) {
    text << (i == 0 ? "[[" : ", [");
    for (Eigen::Index j = 0; j < m.cols(); ++j) text << (j == 0 ? "" : ", ") << m(i, j);
    text << "]";
  }
  text << "]";
  return text.str();
}

Eigen::Matrix<double, 6, 3> directions(const Eigen::Vector3d& p) {
  Eigen::Matrix<double, 6, 3> H;
  for (int i = 0; i < 6; ++i)
    H.row(i) =
        (p - Eigen::Vector3d(kSixAnchors[i][0], kSixAnchors[i][1], kSixAnchors[i][2]))
            .normalized()
            .transpose();
  return H;
}

// A clock that is unknown anew at each update leaves a filter the differences to one
// anchor, whose noise they share: R = σ² (I + 1 1ᵀ), by `linear` and without a clock.
TEST(TimeDifferences, AreWhatAFilterHasOfAFreeClock) {
  for (const Eigen::Vector3d& p : {Eigen::Vector3d(3, 3, 1), {9, 3, 1}, {1, 5, 2}}) {
    const Eigen::Matrix<double, 6, 3> h = directions(p);
    Eigen::Matrix<double, 5, 6> H = Eigen::Matrix<double, 5, 6>::Zero();
    for (int i = 0; i < 5; ++i) H.row(i).head<3>() = h.row(i + 1) - h.row(0);
    const Eigen::MatrixXd R =
        0.01 * (Eigen::MatrixXd::Identity(5, 5) + Eigen::MatrixXd::Ones(5, 5));
    std::ostringstream at;
    at << "[" << p.x() << ", " << p.y() << ", " << p.z() << "]";
    const StateMatrix differences = tracked(
        "delos: 1\nmotion: {type: position_velocity, q: [0.4, 0.4, 0.1]}\n"
        "sample: {points: [" +
        at.str() +
        "]}\ndevices:\n"
        "  - {name: d, type: linear, rate: 10 Hz, params: {H: " +
        rows_text(H) + ", R: " + rows_text(R) + "}}\n");
    for (const char* fusion : {"stacked", "periodic"}) {
      std::string header = std::string("fusion: ") + fusion + "\n";
      const StateMatrix clock = tracked(six_anchors(header, at.str(), ", clock: tag"));
      ASSERT_EQ(clock.rows(), 7);
      // Periodic fusion's is the mean over time.
      if (std::string(fusion) == "stacked") {
        EXPECT_LT((clock.topLeftCorner(6, 6) - differences).norm(),
                  1e-9 * differences.norm())
            << at.str();
      } else {
        EXPECT_GT(clock(0, 0), 0);
      }
    }
  }
}

// A clock that walks is a state as any: the same by matrices, over a range of
// densities. One that hardly walks leaves the ranges, one that runs the differences.
TEST(Pseudoranges, AreRangesOrTimeDifferencesAsTheirClockDrifts) {
  const Eigen::Vector3d p(9, 3, 1);
  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(6, 7);
  H.leftCols(3) = directions(p);
  H.col(6).setOnes();
  const double dt = 0.1;
  Eigen::MatrixXd A = Eigen::MatrixXd::Identity(7, 7), Q = Eigen::MatrixXd::Zero(7, 7);
  A.block<3, 3>(0, 3).diagonal().setConstant(dt);
  const Eigen::Vector3d q(0.4, 0.4, 0.1);
  for (int i = 0; i < 3; ++i) {
    Q(i, i) = q(i) * dt * dt * dt / 3;
    Q(i, i + 3) = Q(i + 3, i) = q(i) * dt * dt / 2;
    Q(i + 3, i + 3) = q(i) * dt;
  }
  double last = 0;
  for (const double density : {1e-4, 1e-2, 1.0, 1e2}) {
    Q(6, 6) = density * dt;
    std::ostringstream number;
    number << density;
    const StateMatrix by_matrices =
        tracked("delos: 1\nmotion: {type: custom, order: 2, names: [clock], A: " +
                rows_text(A) + ", Q: " + rows_text(Q) +
                "}\nsample: {points: [[9, 3, 1]]}\ndevices:\n"
                "  - {name: all, type: linear, rate: 10 Hz, params: {H: " +
                rows_text(H) +
                ", R: " + rows_text(0.01 * Eigen::MatrixXd::Identity(6, 6)) + "}}\n");
    const StateMatrix clock =
        tracked(six_anchors("clocks: {tag: {density: " + number.str() + "}}\n",
                            "[9, 3, 1]", ", clock: tag"));
    EXPECT_LT((clock - by_matrices).norm(), 1e-9 * by_matrices.norm()) << density;
    EXPECT_GT(clock(0, 0), last);
    last = clock(0, 0);
  }
  const auto sigma_x = [](const char* header, const char* clock) {
    return std::sqrt(tracked(six_anchors(header, "[9, 3, 1]", clock))(0, 0));
  };
  const double ranges = sigma_x("", ""), differences = sigma_x("", ", clock: tag");
  EXPECT_NEAR(sigma_x("clocks: {tag: {density: 1e-9}}\n", ", clock: tag"), ranges,
              0.01 * ranges);
  EXPECT_NEAR(sigma_x("clocks: {tag: {density: 1e6}}\n", ", clock: tag"), differences,
              1e-4 * differences);
  EXPECT_GT(differences, 2 * ranges);
}

// Three differences fix a point: three anchors have two, which is blind and not bad.
TEST(TimeDifferences, WantOneAnchorMoreThanRanges) {
  const auto anchors = [](const char* clock, int count) {
    Scene scene = scene_of(six_anchors("", "[3, 3, 1]", clock));
    scene.devices.resize(static_cast<std::size_t>(count));
    return value_of(scene, "sigma_position");
  };
  EXPECT_TRUE(std::isfinite(anchors("", 3)));
  EXPECT_TRUE(std::isinf(anchors(", clock: tag", 3)));
  EXPECT_TRUE(std::isfinite(anchors(", clock: tag", 4)));
  EXPECT_TRUE(std::isinf(anchors(", clock: tag", 1)));
}

// Whom something hides is no part of the differences: the anchors that are left.
TEST(TimeDifferences, LeaveOutWhatIsHidden) {
  const std::string post =
      "occluders: [{box: {min: [4.4, 1.4, 0], max: [4.6, 1.6, 3]}}]\n";
  std::string text = six_anchors(post, "[3, 3, 1]", ", clock: tag");
  const double with_post = value_of(scene_of(text), "sigma_position");
  // The post stands between (3, 3, 1) and the anchor at (6, 0, 3), which is a1.
  const std::size_t from = text.find("  - {name: a1"), to = text.find("  - {name: a2");
  text.erase(from, to - from);
  EXPECT_DOUBLE_EQ(value_of(scene_of(text), "sigma_position"), with_post);
}

std::vector<std::string> findings_of(const std::string& text) {
  Diagnostics findings;
  (void)parse_scene(text, "s.yaml", {}, plugins(), findings);
  std::vector<std::string> all;
  for (const Diagnostic& finding : findings) all.push_back(to_string(finding));
  return all;
}

TEST(Clock, SaysWhatItGoesWith) {
  const auto first = [](const std::string& header) {
    const auto all = findings_of(six_anchors(header, "[3, 3, 1]", ", clock: tag"));
    return all.empty() ? std::string() : all.front();
  };
  EXPECT_EQ(first(""), "");
  EXPECT_EQ(first("fusion: continuous\nclocks: {tag: {density: 1}}\n"), "");
  EXPECT_EQ(first("fusion: continuous\n"),
            "s.yaml:6:64: error: devices.a0.clock: is unknown anew at each update, but "
            "continuous fusion has no updates; use fusion: stacked or periodic, or say "
            "in 'clocks' how it drifts");
  EXPECT_EQ(first("clocks: {tag: {density: -1}}\n"),
            "s.yaml:3:25: error: clocks.tag.density: must not be below 0");
  EXPECT_EQ(first("clocks: {tag: {density: 1, time_constant: 0}}\n"),
            "s.yaml:3:43: error: clocks.tag.time_constant: must be above 0");
  EXPECT_EQ(first("clocks: {tag: {density: 1}, top: {density: 1}}\n"),
            "s.yaml:3:29: error: clocks.top: no device has this clock");
  EXPECT_EQ(first("clocks: {tag: {}}\n"),
            "s.yaml:3:15: error: clocks.tag.density: missing: spectral density of the "
            "noise that drives it, squared readings per second");
  const Scene scene =
      scene_of(six_anchors("clocks: {tag: {density: 2, time_constant: 30 s}}\n",
                           "[3, 3, 1]", ", clock: tag"));
  EXPECT_EQ(scene.clocks.at(0), (ClockEntry{"tag", 30, 2}));
  EXPECT_EQ(scene_of(write_scene(scene)), scene);
}

}  // namespace
}  // namespace delos::test
