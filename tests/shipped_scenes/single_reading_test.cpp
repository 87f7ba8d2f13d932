// Accuracy of one reading of every device, without motion: dilutions of precision.
#include <Eigen/LU>

#include "delos/field/point.h"
#include "delos/layers/layers.h"
#include "delos/scene/definition.h"
#include "shipped_scenes/shipped.h"

namespace delos::test {
namespace {

/// Ranges of 1 m standard deviation to the corners of a regular tetrahedron around the
/// origin: Σ u uᵀ = 4/3 of the identity.
std::string tetrahedron(const std::string& rest = "") {
  return R"(delos: 1
motion: {type: position_velocity, q: [0.4, 0.4, 0.1]}
covariance: single
sample: {points: [[0, 0, 0]]}
devices:
  - {name: a, type: uwb_range, rate: 10 Hz, at: [3, 3, 3], params: &u {sigma: 1 m}}
  - {name: b, type: uwb_range, rate: 10 Hz, at: [3, -3, -3], params: *u}
  - {name: c, type: uwb_range, rate: 10 Hz, at: [-3, 3, -3], params: *u}
  - {name: d, type: uwb_range, rate: 10 Hz, at: [-3, -3, 3], params: *u}
)" + rest;
}

/// P = 3/4 of the identity: VDOP = √(3/4), HDOP = √(3/2), PDOP = 3/2.
TEST(SingleReading, IsTheDilutionOfPrecisionWhereRangesAreOfOneMetre) {
  const Scene scene = scene_of(tetrahedron());
  EXPECT_NEAR(value_of(scene, "sigma_z"), std::sqrt(0.75), 1e-12);
  EXPECT_NEAR(value_of(scene, "sigma_horizontal"), std::sqrt(1.5), 1e-12);
  EXPECT_NEAR(value_of(scene, "sigma_position"), 1.5, 1e-12);
  EXPECT_NEAR(value_of(scene, "eigmax"), std::sqrt(0.75), 1e-12);
  EXPECT_NEAR(value_of(scene, "det"), 0.75 * 0.75 * 0.75, 1e-12);
}

/// What moves, and how often it is read, is nothing to a single reading.
TEST(SingleReading, HasNeitherMotionNorRates) {
  const double one = value_of(scene_of(tetrahedron()), "trace");
  for (const std::vector<Override>& changes : std::vector<std::vector<Override>>{
           {{"motion.type", "position_velocity_acceleration"}},
           {{"motion.q", "[1e-6, 5, 1]"}},
           {{"devices.a.rate", "0.1 Hz"}},
           {{"fusion", "continuous"}},
           {{"fusion", "sequential"}},
           {{"devices.b.rate", "1 kHz"}}})
    EXPECT_EQ(value_of(scene_of(tetrahedron(), changes), "trace"), one)
        << changes[0].path;
}

/// (Hᵀ R⁻¹ H)⁻¹ of cameras and speakers at many points, and of a pose of six
/// coordinates, by Eigen's inverse of the summed information.
TEST(SingleReading, IsTheInverseOfOneUpdatesInformation) {
  for (const char* name : {"02-eight-cameras", "03-hybrid", "04-motion-capture"}) {
    std::vector<Override> changes = {{"covariance", "single"}, {"metric", "trace"}};
    if (std::string(name) == "04-motion-capture") {
      changes.push_back({"motion",
                         "{type: position_velocity, state: pose, q: [0.4, 0.4, 0.1, 1, "
                         "1, 2]}"});
      changes.push_back(
          {"target", "{markers: [[0.1, 0, 0], [0, 0.2, 0], [0, 0, 0.15]]}"});
      changes.push_back({"sample.volume.step", "[2.5 ft, 2.5 ft, 2 ft]"});
    }
    const Scene scene = load(name, changes);
    const Field field = field_of(scene);
    const System system = build_system(scene, plugins());
    const int d = information_size(system);
    std::size_t finite = 0;
    for (std::size_t i = 0; i < field.value.size(); i += 7) {
      if (!std::isfinite(field.value[i])) continue;
      ++finite;
      const InformationLayers layers(
          system, {{Eigen::Matrix3d::Identity(), field.samples.points[i]}}, {});
      LayerBlock scratch;
      const LayerBlock& block = layers.block(0, scratch);
      Eigen::MatrixXd S(d, d);
      for (int r = 0; r < d; ++r)
        for (int c = 0; c <= r; ++c)
          S(r, c) = S(c, r) =
              block.total[static_cast<std::size_t>(packed_index(r, c) * kLanes)];
      const double trace = S.inverse().topLeftCorner<3, 3>().trace();
      EXPECT_NEAR(field.value[i], trace, 1e-6 * trace) << name << " " << i;
    }
    EXPECT_GT(finite, 20u) << name;
  }
}

/// Two spheres meet in a circle: the direction along it is lost, the others aren't.
TEST(SingleReading, LosesWhatNoDeviceReads) {
  Scene scene = scene_of(tetrahedron());
  scene.devices.resize(2);
  const System system = build_system(scene, plugins());
  const auto metric =
      std::get<Metric>(parse_metric("eigmax", covariance_layout(scene)));
  const PointReport report = evaluate_point(system, {}, metric);
  EXPECT_EQ(report.state.unobservable.cols(), 1);
  // Orthogonal to (1, 1, 1) and (1, −1, −1).
  EXPECT_NEAR(std::abs(report.state.unobservable(1, 0)), std::sqrt(0.5), 1e-9);
  EXPECT_NEAR(report.state.unobservable(0, 0), 0, 1e-9);
  EXPECT_TRUE(std::isinf(value_of(scene, "eigmax")));
  EXPECT_TRUE(std::isfinite(value_of(scene, "sigma_x")));
}

TEST(SingleReading, KnowsNoVelocities) {
  const auto refusal = [](const std::string& text) {
    Diagnostics findings;
    EXPECT_FALSE(parse_scene(text, "scene.yaml", {}, plugins(), findings));
    return findings.empty() ? std::string() : to_string(findings[0]);
  };
  EXPECT_NE(
      refusal(tetrahedron("metric: sigma_vx\n")).find("unknown metric 'sigma_vx'"),
      std::string::npos);
  EXPECT_NE(refusal(tetrahedron(
                        "  - {name: whole, type: linear, rate: 10, params: {H: [[1, 0, "
                        "0, 0, 0, 0]], R: [[1]]}}\n"))
                .find("measures more than the pose"),
            std::string::npos);
}

TEST(SingleReading, IsWrittenAndReadAgain) {
  const Scene scene = scene_of(tetrahedron());
  EXPECT_EQ(scene_of(write_scene(scene)), scene);
  EXPECT_EQ(to_string(definition_of(scene)), "covariance of a single reading");
  // It has no fusion to write down.
  EXPECT_EQ(with_definition(scene).fusion, std::nullopt);
}

}  // namespace
}  // namespace delos::test
