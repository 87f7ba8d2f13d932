// Cuts, ellipsoids, lost directions and blind regions.
#include <algorithm>
#include <cmath>

#include "designs.h"
#include "session/blind_json.h"
#include "session/ellipsoids.h"
#include "session/point_answer.h"
#include "session/sections.h"

namespace delos::session {
namespace {

/// Scene 01 with speakers above the corners of its volume: an independent script has
/// numbers of that.
Design speakers_above_corners() {
  Design design = design_of("01-acoustic");
  for (int i = 0; i < 4; ++i)
    change(design, {{"devices.s" + std::to_string(i + 1) + ".at",
                     "[" + std::string(i % 2 ? "0.4" : "0") + ", " +
                         (i / 2 ? "0.4" : "0") + ", 1.0485]"}});
  return design;
}

/// By that script the plane z = 0.6 m runs from 27.5234 to 32.9385 mm on a grid of 1
/// cm, z = 0.4 m from 41.6892 to 46.4208 mm.
TEST(Sections, AreEvaluatedWhereTheyAre) {
  const Design design = speakers_above_corners();
  for (const auto& [z, least, greatest] :
       {std::tuple{0.6, 27.5234e-3, 32.9385e-3}, {0.4, 41.6892e-3, 46.4208e-3}}) {
    const DrawnField cut = draw_sections(
        design.loaded(), {{{0, 0, z}, {0.4, 0, 0}, {0, 0.4, 0}}}, 1600, {});
    EXPECT_EQ(cut.field.value.size(), 41u * 41u);
    EXPECT_NEAR(cut.summary["min"]["value"], least, 5e-8);
    EXPECT_NEAR(cut.summary["max"]["value"], greatest, 5e-8);
  }
}

/// A slanted cut has at each place what `point` says of it.
TEST(Sections, MayBeSlanted) {
  const Design design = design_of("02-eight-cameras");
  const DrawnField cut = draw_sections(
      design.loaded(), {{{0.4, 0.4, 0.4}, {1, 1, 0}, {0.3, -0.3, 1.2}}}, 30, {});
  for (std::size_t i = 0; i < cut.field.value.size(); i += 5) {
    const PointAnswer answer =
        answer_point(design.loaded(), cut.field.samples.points[i],
                     design.loaded().scene.orientations.rpy.front(), Solver::automatic);
    for (const MetricValue& metric : answer.report.metrics)
      if (metric.metric.name == design.loaded().metric.name &&
          std::isfinite(metric.value)) {
        EXPECT_NEAR(cut.field.value[i], metric.value, 1e-9 * metric.value);
      }
  }
}

FusedState state_at(const LoadedScene& loaded, const Eigen::Vector3d& p) {
  return answer_point(loaded, p, Eigen::Vector3d::Zero(), Solver::automatic)
      .report.state;
}

/// At (0.2, 0.2, 0.4) before updates: 41.7, 41.7 and 14.9 mm along x, y and z, by
/// simulation.
TEST(Ellipsoids, AreThoseOfTheCovariance) {
  const Design design = speakers_above_corners();
  const Json ellipsoid = ellipsoid_json(design.loaded().system,
                                        state_at(design.loaded(), {0.2, 0.2, 0.4}));
  std::vector<double> sigma = ellipsoid["sigma"];
  std::sort(sigma.begin(), sigma.end());
  EXPECT_NEAR(sigma[0], 14.9e-3, 1e-4);
  EXPECT_NEAR(sigma[1], 41.7e-3, 1e-4);
  EXPECT_NEAR(sigma[2], 41.7e-3, 1e-4);
}

/// A lattice has at each place what the point has.
TEST(Ellipsoids, AreTheSameOnALattice) {
  const Design design = design_of("02-eight-cameras");
  const Json all = lattice_json(design.loaded(), 60, {});
  ASSERT_GT(all.size(), 20u);
  ASSERT_LE(all.size(), 60u);
  std::size_t blind = 0;
  for (const Json& one : all) {
    const std::vector<double> at = one["at"];
    const FusedState state = state_at(design.loaded(), {at[0], at[1], at[2]});
    const Json there = ellipsoid_json(design.loaded().system, state);
    EXPECT_EQ(one["ellipsoid"].is_null(), there.is_null());
    EXPECT_EQ(one["lost"].size(), lost_json(design.loaded().system, state).size());
    if (there.is_null()) {
      ++blind;
    } else {
      EXPECT_NEAR(one["ellipsoid"]["sigma"][2], there["sigma"][2], 1e-9);
    }
  }
  EXPECT_GT(blind, 0u);
}

/// One range tells of the way to it: what is across it is lost.
TEST(LostDirections, AreAcrossTheSightOfOneRange) {
  Design design = design_of("01-acoustic");
  for (const char* name : {"s2", "s3", "s4"}) change(design, {{"devices.-", name}});
  const Eigen::Vector3d p(0.2, 0.1, 0.4);
  const Eigen::Vector3d sight =
      (design.loaded().system.devices[0].X_WS().p - p).normalized();
  const FusedState state = state_at(design.loaded(), p);
  EXPECT_TRUE(ellipsoid_json(design.loaded().system, state).is_null());
  const Json lost = lost_json(design.loaded().system, state);
  ASSERT_EQ(lost.size(), 2u);
  for (const Json& one : lost) {
    const Eigen::Vector3d v(one[0].get<double>(), one[1].get<double>(),
                            one[2].get<double>());
    EXPECT_NEAR(v.norm(), 1, 1e-12);
    EXPECT_NEAR(v.dot(sight), 0, 1e-9);
  }
}

/// All that isn't observable is in some region, each with a reason.
TEST(BlindRegions, HoldAllThatIsBlind) {
  const Design design = design_of("02-eight-cameras");
  const Field field = evaluate_scene(design.loaded(), {}).field;
  const Json json = blind_json(design.loaded(), field, 3);
  EXPECT_EQ(json["samples"], 2541 - 2178);
  EXPECT_LE(json["regions"].size(), 3u);
  for (const Json& region : json["regions"]) {
    EXPECT_GT(region["samples"], 0);
    EXPECT_NE(region["why"], "");
  }
}

}  // namespace
}  // namespace delos::session
