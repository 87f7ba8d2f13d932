// The HiBall under its ceiling: what the scenes of scenes/hiball claim, and the
// directions that must hold. Expected numbers: Allen (2007), Comparing the expected
// performance of tracking and motion capture systems, §5.1.1 and ch. 7; and an
// independent evaluation of the same model (hiball_oracle.py).
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "delos/field/beacon_use.h"
#include "shipped.h"

namespace delos::test {
namespace {

using Changes = std::vector<Override>;

struct Range {
  double least, greatest;
};

/// Of a field's finite values, in millimetres.
Range range_of(const std::string& name, const Changes& changes = {}) {
  const FieldStatistics s = summarize(field_of("hiball/" + name, changes));
  return {1e3 * s.min.value, 1e3 * s.max.value};
}

void expect_within(double value, double expected, double part) {
  EXPECT_NEAR(value, expected, part * expected);
}

// Stated model values, at head height: 0.193, 0.200 at the centre, 0.262. Here 0.189,
// 0.197, 0.261, within 3 %; the published ones are 0.18, 0.20 to 0.22, 0.26.
TEST(HiBall, GivesTheRangeAtHeadHeight) {
  const Field field = field_of("hiball/six-lepd");
  const FieldStatistics s = summarize(field);
  EXPECT_EQ(s.observable, 169u);
  expect_within(1e3 * s.min.value, 0.193, 0.03);
  expect_within(1e3 * value_at(field, {3, 6, 1.9}), 0.200, 0.03);
  expect_within(1e3 * s.max.value, 0.262, 0.03);
}

// 0.331 at the centre; 0.42 to 0.47 towards the far corner.
TEST(HiBall, GivesTheRangeAtWaistHeight) {
  const Field field = field_of("hiball/waist");
  expect_within(1e3 * value_at(field, {3, 6, 1.0}), 0.331, 0.03);
  expect_within(1e3 * value_at(field, {6, 9, 1.0}), 0.47, 0.03);
}

// 0.329 and 0.445.
TEST(HiBall, GivesTheRangeOfTheWideField) {
  const Range wide = range_of("six-lepd-wide");
  expect_within(wide.least, 0.329, 0.03);
  expect_within(wide.greatest, 0.445, 0.03);
}

// By the published table, a turned HiBall is better at best than one that isn't,
// whatever the axis of 30°.
TEST(HiBall, TurnedIsBetterAtBest) {
  const double straight = range_of("six-lepd").least;
  for (const char* rpy : {"[-30 deg, 0, 0]", "[0, 30 deg, 0]", "[0, 0, 30 deg]"}) {
    EXPECT_LT(range_of("six-lepd",
                       {{"sample.orientations", std::string("{rpy: [") + rpy + "]}"}})
                  .least,
              straight)
        << rpy;
  }
}

// 49 poses over layouts, views, fields, patterns, heights and turns, by SciPy's general
// solver and a loop over all LEDs and views: hiball_oracle.py writes hiball.csv.
TEST(HiBall, AgreesWithTheOracleAtEveryPose) {
  std::ifstream file(DELOS_HIBALL);
  std::string line;
  std::getline(file, line);
  EXPECT_EQ(line, "layout,views,field,pattern,x,y,z,roll,pitch,yaw,eigmax");
  int rows = 0;
  for (; std::getline(file, line); ++rows) {
    std::vector<std::string> cells;
    std::istringstream text(line);
    for (std::string cell; std::getline(text, cell, ',');) cells.push_back(cell);
    ASSERT_EQ(cells.size(), 11u);
    const auto vector = [&](std::size_t i, const std::string& unit) {
      return "[" + cells[i] + unit + ", " + cells[i + 1] + unit + ", " + cells[i + 2] +
             unit + "]";
    };
    const Field field =
        field_of("hiball/six-lepd",
                 {{"devices.hiball.params.layout", cells[0]},
                  {"devices.hiball.params.views", cells[1]},
                  {"devices.hiball.params.field", cells[2] + " deg"},
                  {"beacons.ceiling.pattern", cells[3]},
                  {"sample", "{points: [" + vector(4, "") + "], orientations: {rpy: [" +
                                 vector(7, " deg") + "]}}"}});
    const double expected = std::stod(cells[10]);
    EXPECT_NEAR(field.value.at(0), expected, 1e-8 * expected) << line;
  }
  EXPECT_EQ(rows, 49);
}

// ---- directions ----

const std::string kPattern = "beacons.ceiling.pattern";

/// Sets S of both systems at the poses of a scene; true where the second's is never
/// less than the first's.
bool never_less(const Scene& few, const Scene& many) {
  const System a = build_system(few, plugins()), b = build_system(many, plugins());
  const auto poses = field_poses(make_samples(few.samples), few.orientations);
  for (const TargetPose& pose : poses) {
    const auto information = [&](const System& system) -> Eigen::MatrixXd {
      const WhitenedRows rows = whitened_rows(system, pose);
      return rows.rows.transpose() * rows.rows;
    };
    const Eigen::MatrixXd A = information(a), B = information(b);
    const double least =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(B - A).eigenvalues()(0);
    if (least < -1e-9 * B.norm()) return false;
  }
  return true;
}

TEST(HiBall, MoreBeaconsNeverHurtASumOfInformation) {
  const Changes all = {{"devices.hiball.select", "all"}};
  Changes half = all, checkerboard = all;
  half.push_back({kPattern, "half"});
  checkerboard.push_back({kPattern, "checkerboard"});
  const Scene full = load("hiball/six-lepd", all);
  EXPECT_TRUE(never_less(load("hiball/six-lepd", half), full));
  EXPECT_TRUE(never_less(load("hiball/six-lepd", checkerboard), full));
  const Field few = field_of("hiball/six-lepd", half), many = field_of(full);
  for (std::size_t i = 0; i < few.value.size(); ++i) {
    EXPECT_LE(many.value[i], few.value[i] * (1 + 1e-12));
  }
}

TEST(HiBall, MoreBeaconsNeverHurtTheBestTen) {
  const Changes best = {{"devices.hiball.select", "best"},
                        {"devices.hiball.count", "10"},
                        {"sample.plane.counts", "[5, 5]"}};
  Changes half = best;
  half.push_back({kPattern, "half"});
  const System few = build_system(load("hiball/six-lepd", half), plugins());
  const System many = build_system(load("hiball/six-lepd", best), plugins());
  const Scene scene = load("hiball/six-lepd", best);
  for (const Eigen::Vector3d& p : make_samples(scene.samples).points) {
    const auto volume = [&](const System& system) {
      const WhitenedRows rows = whitened_rows(system, {Eigen::Matrix3d::Identity(), p});
      return std::log((rows.rows.transpose() * rows.rows).determinant());
    };
    // Twice the tolerance at which the search for the best stops.
    EXPECT_GE(volume(many), volume(few) - 2e-5);
  }
}

// Allen (2007), §7.4.1: a wide field seen at random is worse than a narrow one under
// the middle, "diluting the pool of visible LEDs", and near ones should win that back.
TEST(HiBall, WideFieldIsWorseAtRandomAndBetterByTheNearest) {
  const Eigen::Vector3d middle(3, 6, 1.9);
  const auto at_middle = [&](const std::string& name, const std::string& rule) {
    return value_at(field_of("hiball/" + name, {{"devices.hiball.select", rule},
                                                {"devices.hiball.count", "10"},
                                                {"devices.hiball.params.r", "2.1e-4"}}),
                    middle);
  };
  const double narrow = at_middle("six-lepd", "random");
  const double wide = at_middle("six-lepd-wide", "random");
  const double wide_near = at_middle("six-lepd-wide", "nearest");
  EXPECT_GT(wide, 1.5 * narrow);
  EXPECT_LT(wide_near, 0.9 * wide);
}

// §7.2: "the highest penalty paid for halving the number of ceiling LED rows is … on
// the ceiling edge". An update of forty sightings starves there, where the full ceiling
// gives 44 to 60 and the half one 22 to 30; in the middle there are always enough.
TEST(HiBall, HalfTheCeilingCostsMostAtItsEdge) {
  const Changes full = {{"devices.hiball.select", "random"},
                        {"devices.hiball.count", "40"},
                        {"devices.hiball.params.r", "8.4e-4"}};
  Changes half = full;
  half.push_back({kPattern, "half"});
  const Field a = field_of("hiball/six-lepd", full),
              b = field_of("hiball/six-lepd", half);
  double middle = 0, edge = 0;
  int in_middle = 0, at_edge = 0;
  for (std::size_t i = 0; i < a.value.size(); ++i) {
    const double cost = b.value[i] - a.value[i];
    const double y = a.samples.points[i].y();
    if (y < 7.5) middle += cost, ++in_middle;
    if (y > 8.9) edge += cost, ++at_edge;
  }
  EXPECT_GT(edge / at_edge, 1.5 * middle / in_middle);
  EXPECT_GT(edge / at_edge, 0);
}

// The ends of a search for a device that sees nothing: a word, not an empty field.
TEST(HiBall, UpsideDownSeesNothingAndSaysSo) {
  const Scene scene =
      load("hiball/six-lepd", {{"devices.hiball.rpy", "[180 deg, 0, 0]"}});
  const System system = build_system(scene, plugins());
  EXPECT_EQ(summarize(field_of(scene)).observable, 0u);
  const auto why = blind_devices(
      system, field_poses(make_samples(scene.samples), scene.orientations));
  ASSERT_EQ(why.size(), 1u);
  EXPECT_NE(why[0].find("none of 5,824 is in a view's cone"), std::string::npos);
}

// A head above the sensor hides the ceiling from the photodiode that looks up; one
// below hides nothing.
TEST(HiBall, TheUsersHeadHides) {
  const auto looks_up = [](const Changes& changes) {
    const System system = build_system(load("hiball/volume", changes), plugins());
    const auto seen =
        seen_beacons(system, {Eigen::Matrix3d::Identity(), {4.5, 7.5, 1.7}});
    EXPECT_FALSE(seen.empty());
    return std::any_of(seen.begin(), seen.end(), [](const SeenBeacon& s) {
      return s.view == "photodiode 0 through lens 0";
    });
  };
  EXPECT_TRUE(looks_up({}));
  EXPECT_FALSE(looks_up({{"occluders.head.at.z", "0.16"}}));
}

}  // namespace
}  // namespace delos::test
