// Recorded readings: read, their bias and scatter, and a filter over them.
#include "measured/readings.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <fstream>
#include <random>

#include "measured/comparison.h"
#include "support/folder.h"
#include "support/rigs.h"

namespace delos::measured {
namespace {

const TargetPose kStart{Eigen::Matrix3d::Identity(), {0.2, 0.2, 0.4}};

class RecordedReadings : public ::testing::Test {
 protected:
  std::filesystem::path file(const std::string& text) {
    const auto path = folder_.path() / "readings.csv";
    std::ofstream(path) << text;
    return path;
  }
  std::string findings(const std::string& text) {
    Diagnostics found;
    const auto readings = read_readings(file(text), system_, found);
    std::string all;
    for (const Diagnostic& d : found) all += to_string(d) + "\n";
    if (readings) all += "read";
    return all;
  }

  test::Folder folder_;
  System system_ = testing::acoustic_system();
};

TEST_F(RecordedReadings, SayWhatIsWrongAllAtOnce) {
  const std::string all = findings(
      "t [s],device,z1,x,y,z\n"
      "0,s1,0.7,0,0,0\n"
      "0.1,s9,0.7,0,0,0\n"
      "0.05,s2,0.7,0,0,0\n"
      "0.2,s2,far,0,0,0\n"
      "0.3,s2\n"
      "0.4,s2,,0,0,0\n");
  EXPECT_NE(all.find("readings.csv:3:5: "), std::string::npos) << all;
  EXPECT_NE(all.find("no device 's9'; it has s1, s2, s3"), std::string::npos) << all;
  EXPECT_NE(all.find(":5:8: "), std::string::npos) << all;
  EXPECT_NE(all.find("'far' isn't a number"), std::string::npos) << all;
  EXPECT_NE(all.find("has 2 cells, the head has 6"), std::string::npos) << all;
  EXPECT_NE(all.find("has no reading"), std::string::npos) << all;
  EXPECT_NE(findings("t [s],device,z1\n1,s1,0.5\n0.5,s1,0.5\n").find("before that"),
            std::string::npos);
  EXPECT_NE(findings("t,device,z,x,y\n").find("call the reading z1"), std::string::npos)
      << findings("t,device,z,x,y\n");
  EXPECT_NE(findings("a,b\n").find("no column t"), std::string::npos);
  EXPECT_NE(findings("").find("t [s],device,z1"), std::string::npos);
  EXPECT_EQ(findings("# made by hand\nt [s],device,z\n0,s1,0.7\n"), "read");
}

TEST_F(RecordedReadings, MayLackTheTruthHereAndThere) {
  Diagnostics found;
  const auto readings =
      read_readings(file("t [s],device,z1,x,y,z\n0,s1,0.7,0.1,0.2,0.4\n0,s2,0.7,,,\n"),
                    system_, found);
  ASSERT_TRUE(readings);
  EXPECT_EQ(readings->without_truth, (std::vector<std::size_t>{1}));
  EXPECT_TRUE(std::isnan(readings->truth[1].x()));
  EXPECT_TRUE(has_readings(folder_.path() / "readings.csv"));
}

/// Drawn by the scene's own noise, a target that moves by the scene's motion, a bias on
/// one device.
Readings drawn(const System& system, double bias, double noise) {
  std::mt19937_64 random(12);
  std::normal_distribution<double> normal;
  Readings all;
  Eigen::Vector3d p = kStart.p;
  for (int i = 0; i < 600; ++i) {
    p = kStart.p + 0.05 * Eigen::Vector3d(std::sin(0.02 * i), std::cos(0.03 * i), 0);
    for (int d = 0; d < 4; ++d) {
      const double r =
          (p - system.devices[static_cast<std::size_t>(d)].X_WS().p).norm();
      TimedReading timed;
      timed.t = 0.02 * i;
      timed.reading = {d, 0, 0, {0, 6}, {}};
      timed.reading.z.setConstant(
          1, r + (d == 1 ? bias : 0) + noise * std::sqrt(0.005) * r * normal(random));
      all.all.push_back(timed);
      all.truth.push_back(p);
    }
  }
  return all;
}

ReadingsComparison compared(const System& system, const Readings& readings,
                            bool debias = false) {
  return std::get<ReadingsComparison>(
      compare_readings(system, kStart.p, Eigen::Vector3d::Zero(), readings,
                       *make_filter(FilterKind::extended), 2, debias));
}

TEST_F(RecordedReadings, TellBiasFromScatter) {
  const Readings readings = drawn(system_, 0.12, 1);
  const ReadingsComparison of = compared(system_, readings);
  ASSERT_EQ(of.devices.size(), 4u);
  for (std::size_t d = 0; d < 4; ++d) {
    const DeviceComparison& device = of.devices[d];
    EXPECT_EQ(device.readings, 600u);
    EXPECT_NEAR(device.rate, 50, 1e-6);
    const double error = device.predicted / std::sqrt(600.);
    EXPECT_NEAR(device.bias, d == 1 ? 0.12 : 0, 4.5 * error);
    EXPECT_NEAR(device.scatter / device.predicted, 1, 4.5 / std::sqrt(1200.));
    EXPECT_LT(std::abs(device.correlation), 4.5 / std::sqrt(600.));
  }
  // A biased range leads the filter astray; without its mean it doesn't.
  ASSERT_TRUE(of.track);
  const ReadingsComparison without = compared(system_, readings, true);
  EXPECT_GT(of.track->bias.norm(), 0.03);
  EXPECT_LT(without.track->bias.norm(), 0.3 * of.track->bias.norm());
  EXPECT_LT(without.track->nees, of.track->nees);
}

TEST_F(RecordedReadings, OfTheScenesNoiseHaveTheExpectedNis) {
  EXPECT_NEAR(compared(system_, drawn(system_, 0, 1)).nis, 1, 0.1);
  EXPECT_GT(compared(system_, drawn(system_, 0, 2)).nis, 3);
  const ReadingsComparison twice = compared(system_, drawn(system_, 0, 2));
  EXPECT_NEAR(twice.devices[0].scatter / twice.devices[0].predicted, 2, 0.3);
}

/// Two bearings of a target that goes to and fro across −x of both of them, and a
/// height.
ReadingsComparison of_angles(bool come_back) {
  System system;
  system.motion = testing::chain_motion(PoseState::position, 2,
                                        Eigen::Vector3d(0.1, 0.1, 0.1).asDiagonal());
  system.markers = {Eigen::Vector3d::Zero()};
  const auto bearing = std::make_shared<testing::TestBearing>(0.02, come_back);
  const Eigen::Matrix3d upright =
      Eigen::AngleAxisd(EIGEN_PI / 2, Eigen::Vector3d::UnitX()).toRotationMatrix();
  const Eigen::Matrix3d along_y =
      Eigen::AngleAxisd(EIGEN_PI / 2, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  system.devices = {
      testing::place("level", bearing, {Eigen::Matrix3d::Identity(), {2, 0, 0}}, 50),
      testing::place("across", bearing, {along_y, {0, 2, 0}}, 50),
      testing::place("upright", bearing, {upright, {2, 0, 0}}, 50)};
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  Readings all;
  for (int i = 0; i < 600; ++i) {
    const Eigen::Vector3d p =
        0.05 *
        Eigen::Vector3d(std::sin(0.02 * i), std::cos(0.03 * i), std::sin(0.025 * i));
    for (int d = 0; d < 3; ++d) {
      const Pose& X_WS = system.devices[static_cast<std::size_t>(d)].X_WS();
      const Eigen::Vector3d at = X_WS.R.transpose() * (p - X_WS.p);
      TimedReading timed;
      timed.t = 0.02 * i;
      timed.reading = {d, 0, 0, {0, 6}, {}};
      // As an instrument shows it, −π to π.
      timed.reading.z.setConstant(
          1, std::remainder(std::atan2(at.y(), at.x()) + 0.02 * normal(random),
                            2 * EIGEN_PI));
      all.all.push_back(timed);
      all.truth.push_back(p);
    }
  }
  return std::get<ReadingsComparison>(
      compare_readings(system, {0, 0, 0}, Eigen::Vector3d::Zero(), all,
                       *make_filter(FilterKind::extended), 2, false));
}

TEST_F(RecordedReadings, OfAnglesAreNeighboursAcrossTheirSeam) {
  const ReadingsComparison of = of_angles(true);
  for (const DeviceComparison& device : of.devices) {
    EXPECT_NEAR(device.bias, 0, 4.5 * 0.02 / std::sqrt(600.)) << device.name;
    EXPECT_NEAR(device.scatter, 0.02, 4.5 * 0.02 / std::sqrt(1200.)) << device.name;
  }
  EXPECT_NEAR(of.nis, 1, 0.15);
  EXPECT_GT(of_angles(false).devices[0].scatter, 1);
}

TEST_F(RecordedReadings, CoastOverGapsAndSayHowLong) {
  Readings readings = drawn(system_, 0, 1);
  std::erase_if(readings.all, [](const TimedReading& r) { return r.t > 5 && r.t < 8; });
  readings.truth.clear();
  const ReadingsComparison of = compared(system_, readings);
  EXPECT_NEAR(of.longest_gap, 3, 0.05);
  EXPECT_FALSE(of.track);
  EXPECT_TRUE(std::isnan(of.devices[0].bias));
}

}  // namespace
}  // namespace delos::measured
