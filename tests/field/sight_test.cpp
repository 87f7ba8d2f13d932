// What hides: rooms whose shadows are known in closed form.
#include "rig/sight.h"

#include <gtest/gtest.h>

#include <numbers>

#include "delos/geometry/primitives.h"
#include "support/rigs.h"

namespace delos {
namespace {

/// One device at the world's origin that sees points anywhere.
System one_device(bool in_lanes = true) {
  System system = testing::acoustic_system();
  system.devices.resize(1);
  system.devices[0].X_WS() = {};
  if (in_lanes) {
    system.devices[0].device = std::make_shared<testing::TestFullRange>(0.01);
  }
  return system;
}

Samples random_points(double half, int count) {
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> uniform(-half, half);
  Samples samples;
  for (int i = 0; i < count; ++i) {
    const double x = uniform(random), y = uniform(random), z = uniform(random);
    samples.points.emplace_back(x, y, z);
  }
  samples.parts.push_back({"", 0, samples.points.size(), ScatteredShape{}});
  return samples;
}

Field coverage(const System& system, const Samples& samples,
               const Orientations& orientations = {}) {
  return evaluate_field(
      system, samples, orientations,
      std::get<Metric>(parse_metric("coverage", system.motion.layout)));
}

/// A wall at x = 1 that begins at z = 0: behind it the shadow's plane is z = 0.
System behind_a_wall(bool in_lanes) {
  System system = one_device(in_lanes);
  system.in_world = Occluders({make_box({1, -50, 0}, {1.01, 50, 50})});
  return system;
}

TEST(Sight, AWallHidesTheHalfVolumeBehindItsEdge) {
  for (const bool in_lanes : {true, false}) {
    const System system = behind_a_wall(in_lanes);
    const Samples samples = random_points(3, 5000);
    const Field field = coverage(system, samples);
    int hidden = 0;
    for (std::size_t i = 0; i < samples.points.size(); ++i) {
      const Eigen::Vector3d& p = samples.points[i];
      if (p.x() > 1 && p.x() < 1.02) continue;  // within the wall
      const bool expected = p.x() > 1 && p.z() > 0;
      ASSERT_EQ(field.value[i], expected ? 0 : 1) << p.transpose();
      hidden += expected;
    }
    EXPECT_GT(hidden, 500);
  }
}

// A sphere of radius 0.5 at 2 m hides a cone of half angle asin(0.5/2) behind it. Its
// mesh lies within 0.1 % of the sphere.
TEST(Sight, ASphereCastsACone) {
  System system = one_device();
  Pose at;
  at.p = {2, 0, 0};
  system.in_world = Occluders({transformed(make_sphere(0.5, 5), at)});
  const Samples samples = random_points(5, 20000);
  const Field field = coverage(system, samples);
  int hidden = 0;
  for (std::size_t i = 0; i < samples.points.size(); ++i) {
    const Eigen::Vector3d& p = samples.points[i];
    if (p.norm() < 2.6) continue;
    const double sine = std::hypot(p.y(), p.z()) / p.norm();
    if (std::abs(sine - 0.25) < 0.001) continue;
    const bool expected = p.x() > 0 && sine < 0.25;
    ASSERT_EQ(field.value[i], expected ? 0 : 1) << p.transpose();
    hidden += expected;
  }
  EXPECT_GT(hidden, 50);
}

// The wall again, but carried by the target 10 cm in front of its marker: whether it is
// between the two depends on where the target looks.
TEST(Sight, AnOccluderOnTheTargetTurnsWithIt) {
  System system = one_device();
  system.on_target = Occluders({make_box({0.1, -0.5, -0.5}, {0.12, 0.5, 0.5})});
  Samples samples;
  samples.points = {{-2, 0, 0}, {2, 0, 0}};
  samples.parts.push_back({"", 0, 2, ScatteredShape{}});
  const auto at_heading = [&](double yaw) {
    return coverage(system, samples, {.rpy = {{0, 0, yaw}}}).value;
  };
  EXPECT_EQ(at_heading(0), (std::vector<double>{0, 1}));
  EXPECT_EQ(at_heading(std::numbers::pi), (std::vector<double>{1, 0}));
}

// A pair of eyes sees what both see; boxes as well as points.
TEST(Sight, EveryLensMustSee) {
  const Eigen::Vector3d second(0.8, 0.3, -0.2);
  for (const bool in_lanes : {true, false}) {
    System left = behind_a_wall(in_lanes);
    left.markers = {{0, 0, 0.05}};
    left.on_target = Occluders({make_box({0.1, -0.5, -0.5}, {0.12, 0.5, 0.5})});
    left.devices[0].X_WS().R = rotation_from_rpy({0.1, 0.2, 0.3});
    System right = left, both = left;
    right.devices[0].X_WS().p = left.devices[0].X_WS() * second;
    both.devices[0].lenses.push_back(second);
    const Samples samples = random_points(5, 4000);
    const std::vector<double> by_left = coverage(left, samples).value,
                              by_right = coverage(right, samples).value,
                              by_both = coverage(both, samples).value;
    int differ = 0;
    for (std::size_t i = 0; i < samples.points.size(); ++i) {
      ASSERT_EQ(by_both[i], std::min(by_left[i], by_right[i])) << i;
      differ += by_left[i] != by_right[i];
    }
    EXPECT_GT(differ, 100);
    for (std::size_t i = 0; i < 300; ++i) {
      const Eigen::Vector3d p = samples.points[i];
      const Eigen::AlignedBox3d box(p, p + Eigen::Vector3d(0.3, 0.2, 0.4));
      const auto of = [&](const System& system) {
        return sight_of_box(system, system.devices[0], Eigen::Matrix3d::Identity(),
                            system.markers[0], box);
      };
      const Sight a = of(left), b = of(right);
      EXPECT_EQ(of(both), a == Sight::hidden || b == Sight::hidden ? Sight::hidden
                          : a == b                                 ? a
                                                                   : Sight::unknown);
    }
  }
}

TEST(Sight, DevicesThatNeedNoneSeeThroughWalls) {
  class Through final : public testing::TestFullRange {
   public:
    using TestFullRange::TestFullRange;
    bool needs_sight() const override { return false; }
  };
  System system = behind_a_wall(true);
  system.devices[0].device = std::make_shared<Through>(0.01);
  for (const double v : coverage(system, random_points(3, 500)).value) ASSERT_EQ(v, 1);
}

TEST(Sight, EndsOnASurfaceAreNotHiddenByIt) {
  System system = one_device();
  system.in_world = Occluders({make_box({1, -1, -1}, {2, 1, 1})});
  Samples samples;
  samples.points = {{1, 0.3, 0.2}, {2, 0.3, 0.2}};  // on the near and on the far side
  samples.parts.push_back({"", 0, 2, ScatteredShape{}});
  EXPECT_EQ(coverage(system, samples).value, (std::vector<double>{1, 0}));
}

// Seen in half of the headings, a point gets half of the information: as if every
// variance were twice as large.
TEST(Sight, MeanInformationScalesWithTheProbabilityOfBeingSeen) {
  System system = testing::acoustic_system();
  System noisier = testing::acoustic_system();
  for (std::size_t i = 0; i < system.devices.size(); ++i) {
    system.devices[i].device = std::make_shared<testing::TestFullRange>(0.005);
    noisier.devices[i].device = std::make_shared<testing::TestFullRange>(0.01);
  }
  // A lid above the marker in the first orientation, below it in the second.
  system.on_target = Occluders({make_box({-9, -9, 0.01}, {9, 9, 0.02})});
  const Orientations both{.rpy = {{0, 0, 0}, {std::numbers::pi, 0, 0}},
                          .combine = OrientationRule::information};
  const Samples samples = testing::volume({0, 0, 0}, {0.4, 0.4, 0.8}, 0.1);
  const Metric metric = std::get<Metric>(parse_metric("eigmax", system.motion.layout));
  const Field expected = evaluate_field(noisier, samples, {}, metric);
  const Field mean = evaluate_field(system, samples, both, metric);
  Orientations worst = both;
  worst.combine = OrientationRule::worst;
  const Field blind = evaluate_field(system, samples, worst, metric);
  for (std::size_t i = 0; i < samples.points.size(); ++i) {
    ASSERT_NEAR(mean.value[i], expected.value[i], 1e-10 * expected.value[i]);
    ASSERT_TRUE(std::isinf(blind.value[i]));
  }
}

TEST(Sight, PointsInsideSolidsAreCountedAndLeftOut) {
  System system = one_device();
  system.in_world = Occluders({make_box({1, -1, -1}, {2, 1, 1})});
  Samples samples;
  samples.points = {{1.5, 0, 0}, {0.5, 0, 0}, {3, 0, 0}};
  samples.parts.push_back({"", 0, 3, ScatteredShape{}});
  const FieldStatistics s = summarize(coverage(system, samples));
  EXPECT_EQ(s.inside, 1u);
  EXPECT_EQ(s.samples, 2u);
  EXPECT_DOUBLE_EQ(s.mean, 0.5);
}

// What is said of a whole box holds at every point of it, whatever hides where: bodies
// in the room, bodies on the target, and both.
TEST(Sight, OfABoxHoldsAtAllItsPoints) {
  std::mt19937_64 random(12);
  std::uniform_real_distribution<double> place(-3, 3), size(0.02, 0.6), part(0, 1);
  const Occluders wall({make_box({1, -50, 0}, {1.01, 50, 50})});
  const Occluders plate({make_box({0.1, -0.5, -0.5}, {0.12, 0.5, 0.5})});
  System system = one_device();
  for (const auto& [in_world, on_target] :
       {std::pair(wall, Occluders()), std::pair(Occluders(), plate),
        std::pair(wall, plate)}) {
    system.in_world = in_world;
    system.on_target = on_target;
    int said[3] = {};
    for (int i = 0; i < 3000; ++i) {
      const Eigen::Matrix3d R =
          rotation_from_rpy({3 * part(random), 3 * part(random), 3 * part(random)});
      const PlacedMarker marker(0, 0, 0.05);
      const Eigen::Vector3d min(place(random), place(random), place(random));
      const Eigen::Vector3d sizes(size(random), size(random), size(random));
      const Eigen::AlignedBox3d box(min, min + sizes);
      const Sight sight = sight_of_box(system, system.devices[0], R, marker, box);
      ++said[static_cast<int>(sight)];
      if (sight == Sight::unknown) continue;
      for (int k = 0; k < 40; ++k) {
        // Corners first, then anywhere.
        const Eigen::Vector3d t =
            k < 8 ? Eigen::Vector3d(k & 1, k >> 1 & 1, k >> 2)
                  : Eigen::Vector3d(part(random), part(random), part(random));
        const TargetPose X_WT{R, min + t.cwiseProduct(sizes)};
        ASSERT_EQ(in_sight(system, system.devices[0], X_WT, marker),
                  sight == Sight::clear)
            << "box " << i << ", point " << k;
      }
    }
    for (const Sight sight : {Sight::clear, Sight::hidden, Sight::unknown})
      EXPECT_GT(said[static_cast<int>(sight)], 20) << static_cast<int>(sight);
  }
}

// A chosen point on a surface is a marker there; a grid's is in the solid.
TEST(Sight, AMarkerOnASurfaceIsNotInside) {
  System system = one_device();
  system.in_world = Occluders({make_box({1, -1, -1}, {2, 1, 1})});
  const Samples grid = testing::volume({1, 0, 0}, {1.5, 0, 0}, 0.5);
  EXPECT_EQ(summarize(coverage(system, grid)).inside, 2u);
  Samples chosen = grid;
  chosen.parts[0].shape = ScatteredShape{};
  EXPECT_EQ(summarize(coverage(system, chosen)).inside, 1u);
  // On the surface is within the skin of it, 1 mm.
  chosen.points[0].x() = 1.0009;
  EXPECT_EQ(summarize(coverage(system, chosen)).inside, 1u);
  chosen.points[0].x() = 1.0011;
  EXPECT_EQ(summarize(coverage(system, chosen)).inside, 2u);
}

}  // namespace
}  // namespace delos
