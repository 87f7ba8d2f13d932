// Searches whose best design is known in closed form.
#include <complex>
#include <numbers>

#include "delos/optimize/optimize.h"
#include "optimizers/scenes.h"

namespace delos::test {
namespace {

constexpr double kDegrees = std::numbers::pi / 180;

/// Speakers one metre from the origin, each turned about it by a group's yaw; another
/// above, which pins z. The range's noise is the same for all, so that
///
///   S_xy = (1/r) Σ u uᵀ = (m/2r) I + (1/2r) Σ [cos 2θ, sin 2θ; sin 2θ, −cos 2θ]
///
/// whose least eigenvalue is greatest where Σ exp(2iθ) = 0.
std::string planar(const std::vector<double>& degrees, const std::string& device) {
  std::string groups = "groups:\n", devices = "devices:\n", variables = "variables:\n";
  for (std::size_t i = 0; i < degrees.size(); ++i) {
    const std::string name = "d" + std::to_string(i);
    groups += "  " + name + ": {rpy: [0, 0, " + std::to_string(degrees[i]) + " deg]}\n";
    devices += "  - {name: " + name + ", rate: 50, group: " + name +
               ", at: [1, 0, 0], " + device + "}\n";
    // One of them stays: only the differences of the angles matter.
    if (i > 0) variables += "  - {path: groups." + name + ".rpy.yaw}\n";
  }
  devices +=
      "  - {name: above, rate: 50, at: [0, 0, 1], type: acoustic_range, "
      "params: {r: 1.0e-6}}\n";
  return kOneTarget + groups + devices + variables;
}

/// |Σ exp(2iθ)| and the value at the optimum that optimize() finds.
double unevenness(const Scene& scene, std::size_t count) {
  std::complex<double> sum = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto& rpy = std::get<Rpy>(scene.groups[i].placement.facing);
    sum += std::polar(1.0, 2 * rpy.angles.z());
  }
  return std::abs(sum);
}

const std::string kSpeaker = "type: acoustic_range, params: {r: 0.01}";

TEST(KnownOptima, TwoRangesCrossAtARightAngle) {
  const OptimizeResult found = search(parse(planar({0, 25}, kSpeaker)));
  const Scene& scene = found.scene;
  const double between =
      std::get<Rpy>(scene.groups[1].placement.facing).angles.z() / kDegrees;
  EXPECT_NEAR(std::abs(std::remainder(between, 180)), 90, 90 * 1e-3);
}

// Lines of sight at 120 degrees are those at 60: a speaker and its mirror image inform
// alike.
TEST(KnownOptima, ThreeRangesAreEvenlySpread) {
  const OptimizeResult found = search(parse(planar({0, 25, 40}, kSpeaker)));
  EXPECT_LT(unevenness(found.scene, 3), 1e-3);
  std::vector<double> angles;
  for (int i = 1; i < 3; ++i) {
    const double yaw =
        std::get<Rpy>(found.scene.groups[static_cast<std::size_t>(i)].placement.facing)
            .angles.z() /
        kDegrees;
    angles.push_back(std::abs(std::remainder(yaw, 180)));
  }
  EXPECT_NEAR(angles[0], 60, 60 * 1e-3);
  EXPECT_NEAR(angles[1], 60, 60 * 1e-3);
}

// Cameras that look at the middle of a circle measure bearings: in the plane each
// informs by I − u uᵀ, out of it alike.
class Bearings : public testing::TestWithParam<int> {};

TEST_P(Bearings, AreEvenlySpread) {
  const auto count = static_cast<std::size_t>(GetParam());
  std::vector<double> degrees;
  for (std::size_t i = 0; i < count; ++i)
    degrees.push_back(20 + 13 * static_cast<double>(i));
  const OptimizeResult found =
      search(parse(planar(degrees,
                          "aim: [0, 0, 0], type: pinhole_camera, params: {focal: 8 "
                          "mm, pitch: 5 um, resolution: [1280, 1024]}")));
  EXPECT_LT(unevenness(found.scene, count), 1e-3 * GetParam());
  // The value in closed form: λmin = m/(2 r) in the plane, by the same field.
  std::vector<double> even;
  for (std::size_t i = 0; i < count; ++i)
    even.push_back(20 + 180.0 * static_cast<double>(i) / GetParam());
  const Scene best = parse(planar(even,
                                  "aim: [0, 0, 0], type: pinhole_camera, params: "
                                  "{focal: 8 mm, pitch: 5 um, resolution: [1280, "
                                  "1024]}"));
  Problem problem(best, plugins(), {0, 1});
  const double expected = problem.score(problem.design().start()).objective;
  EXPECT_NEAR(found.best.objective, expected, 1e-3 * expected);
}

INSTANTIATE_TEST_SUITE_P(Counts, Bearings, testing::Values(3, 4, 5));

TEST(KnownOptima, AStereoPairConvergesAtARightAngle) {
  const OptimizeResult found = search(load("11-stereo-pair"));
  const double half =
      std::get<Rpy>(found.scene.groups[0].placement.facing).angles.z() / kDegrees;
  EXPECT_NEAR(2 * half, 90, 90 * 1e-3);
}

// A camera on a rail and a fixed one: they should cross at a right angle, but a screen
// hides the place where they would. The best is at the screen's edge; brute force over
// the rail says where.
TEST(KnownOptima, ABestMountBehindAnEdge) {
  const Scene scene = parse(kOneTarget + R"(surfaces:
  rail: {rail: [[-3, 2, 0], [3, 2, 0]]}
devices:
  - {name: fixed, rate: 50, type: pinhole_camera, at: [-2, 0, 0], aim: [0, 0, 0], params: &p {focal: 8 mm, pitch: 5 um, resolution: [1280, 1024]}}
  - {name: movable, rate: 50, type: pinhole_camera, on: rail, coordinates: 0.85, aim: [0, 0, 0], params: *p}
occluders:
  - {box: {min: [-0.35, 0.9, -1], max: [0.3, 1.0, 1]}}
variables:
  - {path: devices.movable.coordinates.0}
)");
  Problem problem(scene, plugins(), {0, 1});
  double least = 1e300, at = 0;
  for (int i = 0; i <= 4000; ++i) {
    const double x = i / 4000.0;
    const double value = problem.score(std::vector<double>{x}).objective;
    if (value < least) {
      least = value;
      at = x;
    }
  }
  const OptimizeResult found = search(scene);
  EXPECT_NEAR(found.best_x[0], at, 1e-3);
  EXPECT_LT(found.best.objective, 1.001 * least);
  // Behind an edge: a little further and the camera sees nothing.
  const double inward = found.best_x[0] + (found.best_x[0] < 0.5 ? 0.01 : -0.01);
  EXPECT_GT(problem.score(std::vector<double>{inward}).objective, 5 * least);
}

}  // namespace
}  // namespace delos::test
