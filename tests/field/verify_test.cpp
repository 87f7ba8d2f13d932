// The observed order of accuracy against orders that are known.
#include "delos/field/verify.h"

#include <gtest/gtest.h>

#include "support/rigs.h"

namespace delos {
namespace {

Verification verify(const SampleSet& set) {
  const System system = testing::acoustic_system();
  return verify_sampling(
      system, set, {}, std::get<Metric>(parse_metric("sigma_z", system.motion.layout)));
}

// Linear interpolation of what is smooth errs with h².
TEST(Verify, LinearInterpolationOfASmoothFieldIsOfSecondOrder) {
  const Verification v =
      verify({"", VolumeSampling{{0, 0, 0}, {0.4, 0.4, 0.8}, {0.025, 0.025, 0.05}}});
  ASSERT_EQ(v.resolutions.size(), 3u);
  EXPECT_DOUBLE_EQ(v.resolutions[0].spacing, 0.2);
  EXPECT_EQ(v.resolutions[2].evaluations, 17u * 17 * 17);
  EXPECT_NEAR(v.second_order, 2, 0.1);
  EXPECT_NEAR(v.first_order, 2, 0.25);
}

TEST(Verify, PlanesLikewise) {
  const Verification v =
      verify({"", PlaneSampling{{0, 0, 0.76}, {0.4, 0, 0}, {0, 0.4, 0}, {41, 41}}});
  ASSERT_EQ(v.resolutions.size(), 3u);
  EXPECT_NEAR(v.resolutions[2].spacing, 0.01, 1e-12);
  EXPECT_NEAR(v.second_order, 2, 0.1);
}

TEST(Verify, AnOctreeErrsLessWithMoreNodes) {
  AdaptiveSampling s;
  s.min = {0, 0, 0};
  s.max = {0.4, 0.4, 0.8};
  s.tolerance = 2e-4;
  s.depth = 6;
  const Verification v = verify({"", s});
  ASSERT_EQ(v.resolutions.size(), 3u);
  EXPECT_LT(v.resolutions[2].error, v.resolutions[1].error);
  EXPECT_LT(v.resolutions[1].error, v.resolutions[0].error);
  // Triquadratic interpolation is of third order or better.
  EXPECT_GT(v.second_order, 2.5);
}

TEST(Verify, WhatCannotBeMadeCoarserIsLeft) {
  EXPECT_TRUE(verify({"", VolumeSampling{{0, 0, 0}, {0.4, 0.4, 0.8}, {0.2, 0.2, 0.2}}})
                  .resolutions.empty());
  EXPECT_TRUE(verify({"", PointSampling{"", {{0, 0, 0}}}}).resolutions.empty());
}

}  // namespace
}  // namespace delos
