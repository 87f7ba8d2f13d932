// Bodies of markers that face somewhere: who sees them, what is known of their pose,
// and how they are read.
#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>
#include <random>

#include "delos/field/point.h"
#include "delos/field/soft_field.h"
#include "rig/sight.h"
#include "shipped_scenes/shipped.h"

namespace delos::test {
namespace {

const char* const kCameras = R"(
devices:
  - {name: a, type: camera, rate: 60 Hz, at: [2, 0, 1.5], aim: [0, 0, 1], params: &c {resolution: [1280, 1024], f_x: 1000, sigma: 0.2}}
  - {name: b, type: camera, rate: 60 Hz, at: [0, 2, 1.5], aim: [0, 0, 1], params: *c}
  - {name: c, type: camera, rate: 60 Hz, at: [-2, 0.2, 2], aim: [0, 0, 1], params: *c}
  - {name: d, type: camera, rate: 60 Hz, at: [0.1, -2, 1], aim: [0, 0, 1], params: *c}
)";

/// Markers at the corners of a square, outwards and upwards, raised and turned; one
/// that is seen from all around, one with a cone of its own, and one beside the body.
std::string scene_text(const std::string& sample, const std::string& target) {
  return "delos: 1\nmotion: {type: position, state: pose, q: [1, 1, 1, 1, 1, 1]}\n"
         "covariance: single\nmetric: sigma_position\nsample: " +
         sample + "\norientations: {rpy: [[0, 0, 20 deg], [10 deg, 0, 130 deg]]}\n" +
         target + kCameras;
}

const char* const kHelmet = R"(
target:
  markers: [[0, 0, -0.1]]
  bodies:
    helmet:
      at: [0, 0, 5 cm]
      rpy: [0, 0, 45 deg]
      half_angle: 60 deg
      markers:
        - {at: [8 cm, 0, 0], normal: [3, 0, 1]}
        - {at: [0, 8 cm, 0], normal: [0, 1, 0.2]}
        - {at: [-8 cm, 0, 0], normal: [-1, 0, 0]}
        - {at: [0, -8 cm, 0], normal: [0, -2, 0], half_angle: 25 deg}
        - [0, 0, 10 cm]
)";

const char* const kPlaces =
    "{volume: {min: [-0.4, -0.4, 0.8], max: [0.4, 0.4, 1.2], step: 0.2}}";

struct ByHand {
  Eigen::Vector3d at, normal;
  double half_angle;  // 0: all around
};

/// The same markers, in the target's frame.
std::vector<ByHand> markers_by_hand() {
  const double degree = std::numbers::pi / 180;
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(45 * degree, Eigen::Vector3d::UnitZ()).matrix();
  const auto on_body = [&](const Eigen::Vector3d& at, const Eigen::Vector3d& normal,
                           double angle) {
    return ByHand{turn * at + Eigen::Vector3d(0, 0, 0.05), turn * normal,
                  angle * degree};
  };
  return {
      {{0, 0, -0.1}, {0, 0, 0}, 0},           on_body({0.08, 0, 0}, {3, 0, 1}, 60),
      on_body({0, 0.08, 0}, {0, 1, 0.2}, 60), on_body({-0.08, 0, 0}, {-1, 0, 0}, 60),
      on_body({0, -0.08, 0}, {0, -2, 0}, 25), on_body({0, 0, 0.1}, {0, 0, 0}, 0)};
}

/// The angle between two directions.
double between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Σ HᵀR⁻¹H over what every camera sees, from the pinhole's formula, and how many see.
Eigen::MatrixXd information_by_hand(const System& system, const Pose& X_WT,
                                    const std::vector<ByHand>& markers, int* sees) {
  Eigen::MatrixXd S = Eigen::MatrixXd::Zero(6, 6);
  *sees = 0;
  for (const PlacedDevice& device : system.devices) {
    const Pose& X_WS = device.X_WS();
    bool any = false;
    for (const ByHand& marker : markers) {
      const Eigen::Vector3d arm = X_WT.R * marker.at;
      const Eigen::Vector3d p = X_WS.R.transpose() * (X_WT.p + arm - X_WS.p);
      if (std::abs(p.x() / p.z()) > 0.64 || std::abs(p.y() / p.z()) > 0.512) continue;
      if (marker.half_angle > 0 &&
          between(X_WT.R * marker.normal, X_WS.p - X_WT.p - arm) > marker.half_angle)
        continue;
      any = true;
      Eigen::MatrixXd h(2, 3), lever(3, 6);
      h << 1 / p.z(), 0, -p.x() / (p.z() * p.z()),  //
          0, 1 / p.z(), -p.y() / (p.z() * p.z());
      Eigen::Matrix3d cross;
      cross << 0, -arm.z(), arm.y(), arm.z(), 0, -arm.x(), -arm.y(), arm.x(), 0;
      lever << Eigen::Matrix3d::Identity(), -cross;
      const Eigen::MatrixXd H = 1000 * h * X_WS.R.transpose() * lever;
      S += H.transpose() * H / 0.04;
    }
    *sees += any;
  }
  return S;
}

TEST(MarkerBodies, AreSeenFromTheirConesAndSayThePose) {
  Scene scene = scene_of(scene_text(kPlaces, kHelmet));
  const System system = build_system(scene, plugins());
  const std::vector<ByHand> markers = markers_by_hand();
  int cut = 0;
  for (const Eigen::Vector3d& rpy : std::vector(scene.orientations.rpy)) {
    scene.orientations.rpy = {rpy};
    scene.metric = "sigma_position";
    const Field sigma = field_of(scene);
    scene.metric = "coverage";
    const Field coverage = field_of(scene);
    ASSERT_GT(sigma.value.size(), 40u);
    for (std::size_t i = 0; i < sigma.value.size(); ++i) {
      const Pose X_WT{rotation_from_rpy(rpy), sigma.samples.points[i]};
      int sees = 0;
      const Eigen::MatrixXd S = information_by_hand(system, X_WT, markers, &sees);
      ASSERT_EQ(coverage.value[i], sees);
      const double expected = std::sqrt(S.inverse().topLeftCorner<3, 3>().trace());
      ASSERT_NEAR(sigma.value[i], expected, 1e-9 * expected) << i;
      std::vector<ByHand> all_around = markers;
      for (ByHand& marker : all_around) marker.half_angle = 0;
      cut += (information_by_hand(system, X_WT, all_around, &sees) - S).norm() > 1;
    }
  }
  EXPECT_GT(cut, 50);  // it matters
}

// One marker that faces up with 30 degrees: a camera 2 m above it sees it in a circle
// of the radius 2 tan 30° = 1.1547 m.
TEST(MarkerBodies, AreSeenInACircleFromAbove) {
  const std::string text = R"(delos: 1
motion: {type: position, q: [1, 1, 1]}
metric: coverage
sample: {points: [[1.1546, 0, 0], [1.1548, 0, 0], [0, -1.1546, 0], [0, -1.1548, 0], [0, 0, 0]]}
target: {bodies: {hat: {half_angle: 30 deg, markers: [{at: [0, 0, 0], normal: [0, 0, 1]}]}}}
devices: [{name: up, type: camera, rate: 50, at: [0, 0, 2], aim: [0, 0, 0], params: {resolution: [1000, 1000], f_x: 200}}]
)";
  EXPECT_EQ(field_of(scene_of(text)).value, (std::vector<double>{1, 0, 1, 0, 1}));
}

// Whatever is said of a box of places holds at each of them.
TEST(MarkerBodies, BoxesOfPlacesFaceAsTheirPointsDo) {
  const System system = build_system(scene_of(scene_text(kPlaces, kHelmet)), plugins());
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> place(-2, 2), size(0.01, 0.6), part(0, 1);
  int said[3] = {};
  for (int i = 0; i < 3000; ++i) {
    const Eigen::Matrix3d R =
        rotation_from_rpy({place(random), place(random), place(random)});
    const PlacedMarker& marker = system.markers[static_cast<std::size_t>(i) % 6];
    const Eigen::Vector3d min(place(random), place(random), place(random));
    const Eigen::Vector3d sizes(size(random), size(random), size(random));
    const Sight sight =
        sight_of_box(system, system.devices[0], R, marker, {min, min + sizes});
    ++said[static_cast<int>(sight)];
    for (int k = 0; k < 20 && sight != Sight::unknown; ++k) {
      const Eigen::Vector3d t(part(random), part(random), part(random));
      ASSERT_EQ(
          in_sight(system, system.devices[0], {R, min + t.cwiseProduct(sizes)}, marker),
          sight == Sight::clear);
    }
  }
  for (const int count : said) EXPECT_GT(count, 100);
}

// The slopes that searches follow, by central differences of the soft field.
// In the middle of an image two of its edges are equally near, and the nearest has no
// slope: places beside it.
TEST(MarkerBodies, HaveSlopesAtTheirSoftEdges) {
  const Scene scene =
      scene_of(scene_text("{volume: {min: [-0.3713, -0.4127, 0.8331], max: [0.4287, "
                          "0.3873, 1.2331], step: 0.2}}",
                          kHelmet));
  System system = build_system(scene, plugins());
  system.prior = 1;
  const Samples samples = make_samples(scene.samples);
  const auto metric =
      std::get<Metric>(parse_metric("sigma_position", covariance_layout(scene)));
  constexpr double kWidth = 0.3;
  SoftField soft(samples, scene.orientations, {metric});
  soft.evaluate(system, kWidth);
  soft.adjoin({std::vector<double>(samples.points.size(), 1.0)});
  const std::vector<PoseSlope> slopes = soft.pose_slopes();
  const auto sum = [&](const System& at) {
    SoftField other(samples, scene.orientations, {metric});
    double total = 0;
    for (const double value : other.evaluate(at, kWidth)[0]) total += value;
    return total;
  };
  for (std::size_t i = 0; i < system.devices.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      constexpr double kStep = 1e-5;
      System up = system, down = system;
      up.devices[i].X_WS().p(k) += kStep;
      down.devices[i].X_WS().p(k) -= kStep;
      EXPECT_NEAR(slopes[i](k), (sum(up) - sum(down)) / (2 * kStep),
                  1e-5 * slopes[i].norm())
          << i << ' ' << k;
    }
}

TEST(MarkerBodies, AreWrittenAsTheyWereRead) {
  const Scene scene = scene_of(scene_text(kPlaces, kHelmet));
  ASSERT_EQ(scene.bodies.size(), 1u);
  EXPECT_EQ(scene.bodies[0].markers.size(), 5u);
  EXPECT_TRUE(scene_of(write_scene(scene)) == scene);
  const Scene alone =
      scene_of(scene_text(kPlaces, "target: {bodies: {b: {markers: [[1, 0, 0]]}}}"));
  EXPECT_TRUE(alone.markers.empty());  // the usual one isn't there
  EXPECT_TRUE(scene_of(write_scene(alone)) == alone);
}

// What is wrong is told with its line, all at once.
TEST(MarkerBodies, AreRefusedWhereTheyMakeNoSense) {
  Diagnostics findings;
  const auto scene = parse_scene(scene_text(kPlaces, R"(target:
  bodies:
    a:
      markers: []
    b:
      half_angle: 200 deg
      roll: 1
      markers:
        - {at: [0, 0, 0], normal: [0, 0, 0]}
        - {at: [0, 0, 0], half_angle: 10 deg}
        - {normal: [0, 0, 1]}
        - [0, 1]
    c: {markers: [[0, 0, 0]], colour: red}
)"),
                                 "s.yaml", {}, plugins(), findings);
  EXPECT_FALSE(scene);
  std::vector<std::string> said;
  for (const Diagnostic& finding : findings) said.push_back(to_string(finding));
  const std::vector<std::string> expected = {
      "s.yaml:10:16: error: target.bodies.a.markers: the list is empty; give at least "
      "one "
      "marker",
      "s.yaml:12:19: error: target.bodies.b.half_angle: must be above 0 and at most "
      "180 "
      "deg: the half-angle of the cone from where it is seen",
      "s.yaml:15:35: error: target.bodies.b.markers.0.normal: has length zero; leave "
      "it "
      "out where it is seen from all around",
      "s.yaml:16:39: error: target.bodies.b.markers.1.half_angle: is about a normal; "
      "say "
      "which way the marker faces",
      "s.yaml:17:11: error: target.bodies.b.markers.2.at: missing: its place in the "
      "body's frame, [x, y, z], metres",
      "s.yaml:18:11: error: target.bodies.b.markers.3: expected three numbers [x, y, "
      "z], "
      "not 2 members",
      "s.yaml:13:13: error: target.bodies.b.roll: goes with 'aim'; the roll of 'rpy' "
      "is "
      "its first angle",
      "s.yaml:19:31: error: target.bodies.c.colour: unknown key; known: markers, "
      "half_angle, at, aim, roll, rpy, quaternion_wxyz"};
  for (const std::string& one : expected)
    EXPECT_NE(std::find(said.begin(), said.end(), one), said.end())
        << one << "\nsaid:\n"
        << testing::PrintToString(said);
  EXPECT_EQ(said.size(), expected.size()) << testing::PrintToString(said);
}

}  // namespace
}  // namespace delos::test
