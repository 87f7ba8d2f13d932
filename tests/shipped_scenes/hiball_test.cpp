// The HiBall under its ceiling: what the scenes of scenes/hiball claim, and the
// directions that must hold. Expected numbers: Allen (2007), Comparing the expected
// performance of tracking and motion capture systems, §5.1.1 and ch. 7; and an
// independent evaluation of the same model (hiball_oracle.py).
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <random>
#include <set>
#include <sstream>

#include "delos/observe/beacon_use.h"
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

// LEDs are looked for once for samples near each other, here 3 cm; the field's numbers
// must be those of each sample alone.
TEST(HiBall, AFieldIsThatOfItsPointsBitForBit) {
  const std::string turns = "orientations: {rpy: [[0, 0, 0], [20 deg, 10 deg, 0]]}";
  const Field field = field_of(
      "hiball/six-lepd", {{"sample",
                           "{plane: {origin: [3, 8, 1.9], u: [1.5, 0, 0], v: [0, 1, "
                           "0], counts: [51, 5]}, " +
                               turns + "}"}});
  ASSERT_EQ(field.value.size(), 255u);
  for (std::size_t i = 0; i < field.value.size(); i += 7) {
    const Eigen::Vector3d& p = field.samples.points[i];
    std::ostringstream point;
    point.precision(17);
    point << "{points: [[" << p.x() << ", " << p.y() << ", " << p.z() << "]], ";
    const Field alone =
        field_of("hiball/six-lepd", {{"sample", point.str() + turns + "}"}});
    EXPECT_EQ(field.value[i], alone.value.at(0));
  }
}

// ---- the pose and the beacons ----

/// Poses near head height under the ceiling, turned by up to some 40°.
std::vector<TargetPose> random_poses(int count) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<TargetPose> poses;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d rpy(0.7 * uniform(random), 0.7 * uniform(random),
                              3 * uniform(random));
    poses.push_back({rotation_from_rpy(rpy),
                     {3.15 + 3 * uniform(random), 4.5 + 4.4 * uniform(random),
                      1.5 + 0.5 * uniform(random)}});
  }
  return poses;
}

/// A beacon as its device sees it.
bool observe(const PlacedDevice& placed, const TargetPose& pose, int view,
             const Eigen::Vector3d& beacon, Observation& out) {
  Target target;
  target.p_ST = (pose * placed.carried()->X_TS).inverse() * beacon;
  target.n_ST = pose.R.transpose() * Eigen::Vector3d(0, 0, -1);
  return placed.device->observe_view(view, target, out);
}

TEST(HiBall, SeesWhatALoopOverAllLedsAndViewsSees) {
#ifdef __SANITIZE_ADDRESS__
  constexpr int kPoses = 60;  // minutes for all, which another build looks at
#else
  constexpr int kPoses = 500;
#endif
  const System system = build_system(load("hiball/six-lepd"), plugins());
  const PlacedDevice& hiball = system.devices.at(0);
  ASSERT_EQ(hiball.device->views(), 26);
  std::size_t total = 0;
  Observation out;
  for (const TargetPose& pose : random_poses(kPoses)) {
    std::multiset<std::pair<double, double>> expected, found;
    for (int view = 0; view < 26; ++view) {
      for (std::size_t b = 0; b < hiball.carried()->beacons->size(); ++b) {
        const Eigen::Vector3d& p = (*hiball.carried()->beacons)[b].p;
        if (observe(hiball, pose, view, p, out)) expected.emplace(p.x(), p.y());
      }
    }
    for (const SeenBeacon& s : seen_beacons(system, pose)) {
      found.emplace(s.at.x(), s.at.y());
    }
    ASSERT_EQ(found, expected);
    total += found.size();
  }
  EXPECT_GT(total, kPoses * 20u);
}

// Rows over position and orientation against central differences of u and v, with the
// LED fixed in the room and the sensor moved and turned.
TEST(HiBall, RowsAreDerivativesByPositionAndOrientation) {
  const System system =
      build_system(load("hiball/six-lepd", {{"devices.hiball.select", "all"},
                                            {"motion.state", "pose"},
                                            {"motion.q", "[1, 1, 1, 1, 1, 1]"}}),
                   plugins());
  const PlacedDevice& hiball = system.devices.at(0);
  std::map<std::string, int> view_of;
  for (int v = 0; v < 26; ++v) view_of[hiball.device->view_name(v)] = v;
  int compared = 0;
  for (const TargetPose& pose : random_poses(500)) {
    const std::vector<SeenBeacon> seen = seen_beacons(system, pose);
    const WhitenedRows rows = whitened_rows(system, pose);
    ASSERT_EQ(rows.rows.rows(), 2 * static_cast<Eigen::Index>(seen.size()));
    for (std::size_t i = 0; i < seen.size(); ++i) {
      const double h = 1e-6;
      for (int c = 0; c < 6; ++c) {
        TargetPose up = pose, down = pose;
        if (c < 3) {
          up.p(c) += h, down.p(c) -= h;
        } else {
          const Eigen::Vector3d axis = Eigen::Vector3d::Unit(c - 3);
          up.R = Eigen::AngleAxisd(h, axis) * pose.R;
          down.R = Eigen::AngleAxisd(-h, axis) * pose.R;
        }
        Observation plus, minus;
        const int view = view_of.at(seen[i].view);
        if (!observe(hiball, up, view, seen[i].at, plus)) continue;
        if (!observe(hiball, down, view, seen[i].at, minus)) continue;
        const Eigen::Vector2d slope = (plus.z - minus.z) / (2 * h);
        const auto row = static_cast<Eigen::Index>(2 * i);
        // Half-widths per metre or radian; r is 2.1e-5.
        const Eigen::Vector2d mine = rows.rows.block<2, 1>(row, c) * std::sqrt(2.1e-5);
        EXPECT_NEAR(mine(0), slope(0), 1e-6 * (1 + std::abs(slope(0))));
        EXPECT_NEAR(mine(1), slope(1), 1e-6 * (1 + std::abs(slope(1))));
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 500 * 20 * 6);
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
