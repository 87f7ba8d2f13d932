// Input files of Artemis, as B. D. Allen's dissertation (2007) prints them.
#include <gtest/gtest.h>

#include <variant>

#include "delos/field/evaluate.h"
#include "delos/scene/definition.h"
#include "imports/imported.h"

namespace delos::test {
namespace {

const std::string kQ =
    "0.3951529079 ; Q diagonals\n0.3951529079\n0.10745377401\n"
    "0.3951529079\n0.3951529079\n0.10745377401\n";

std::string speaker(double x, double y, const std::string& control = "") {
  return "measurement AcousticRange 1\ndt 50.0\nicon sphere\nposition " +
         std::to_string(x) + " " + std::to_string(y) +
         " 3.5\norientation 0.0 0.0 0.0\nr 0.005" + control + "\n";
}

/// Fig. 4.5: what a file says of its samples, and the controls of S1, S2 and S3.
std::string fig45(const std::string& samples, const std::array<std::string, 3>& gui) {
  return "P_PV\n" + samples + kQ + speaker(0.5, 0.5, gui[0]) +
         speaker(3.5, 0.5, gui[1]) + speaker(0.5, 3.5, gui[2]) + speaker(3.5, 3.5);
}

Field field_of(const Scene& scene, const Samples& samples) {
  const System system = build_system(scene, import_plugins());
  const auto metric = parse_metric(scene.metric, covariance_layout(scene));
  return evaluate_field(system, samples, scene.orientations, std::get<Metric>(metric),
                        {.threads = 1});
}

// Fig. 4.5, left. SciPy's solution of the same equation: least 0.0596795 at (2,
// 2, 2.4), greatest 0.1662362 at (0, 0, 0).
TEST(Artemis, ReadsTheVolumeOfFigure45) {
  const Imported got = imported(
      {{"a.ext", fig45("volume meters\n0.0 0.0 0.0 ; Volume min\n4.0 4.0 3.0\n0.2 0.2 "
                       "0.2 ; Volume delta\n",
                       {})}});
  ASSERT_TRUE(got.scene) << got.findings;
  const Samples all = make_samples(got.scene->samples);
  EXPECT_EQ(all.points.size(), 7056u);
  Samples few;
  few.points = {{2, 2, 2.4}, {0, 0, 0}};
  few.parts = {SamplePart{.count = 2, .shape = ScatteredShape{}}};
  const Field field = field_of(*got.scene, few);
  EXPECT_NEAR(field.value[0], 0.0596795, 5e-8);
  EXPECT_NEAR(field.value[1], 0.1662362, 5e-8);
}

// Fig. 4.5, right, with the rows of Zplane_2m.ptl that §4.2.1 prints; numbers by SciPy.
// Its three controls are variables, in the order of the file.
TEST(Artemis, ReadsThePointsAndControlsOfFigure45) {
  std::string points;
  for (int i = 0; i < 6; ++i)
    points += "3.0      6." + std::to_string(i) + "      1.9\n";
  const Imported got = imported(
      {{"a.ext",
        fig45("PointList meters\nZplane_2m.ptl ; file of sample points\n;\n;\n",
              {" GUI slider S1_Noise 0.001 0.006", " GUI text R2 0.001 0.007",
               " GUI slider S3_Noise 0.001 0.008"})},
       {"Zplane_2m.ptl", points}});
  // The folder is gone by now; what the scene names is beside it.
  EXPECT_NE(got.text.find("file: 'Zplane_2m.ptl'"), std::string::npos) << got.text;
  ASSERT_TRUE(got.scene) << got.findings;
  const Field field = field_of(*got.scene, make_samples(got.scene->samples));
  const double expected[] = {0.2578785, 0.2694397, 0.2813745,
                             0.2936826, 0.3063637, 0.3194178};
  ASSERT_EQ(field.value.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(field.value[i], expected[i], 5e-8);
  ASSERT_EQ(got.rig->variables.size(), 3u);
  const char* paths[] = {"devices.S1.params.r", "devices.S2.params.r",
                         "devices.S3.params.r"};
  const char* upper[] = {"0.006", "0.007", "0.008"};
  const char* names[] = {"slider S1_Noise", "text R2", "slider S3_Noise"};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(got.rig->variables[i].path, paths[i]);
    EXPECT_EQ(got.rig->variables[i].lower, "0.001");
    EXPECT_EQ(got.rig->variables[i].upper, upper[i]);
    EXPECT_EQ(got.rig->variables[i].remark, names[i]);
    EXPECT_EQ(got.scene->variables[i].path, paths[i]);
  }
}

/// A pair of Fig. 4.7, whose first is printed; the figure says that there are four.
std::string pair(const std::string& group, const std::string& x) {
  const std::string axes =
      "left      0.616610      0.365474      0.697295\n"
      "up        0.741467      0.0281039     -0.670401\n"
      "look     -0.264611      0.930397     -0.253658\n";
  return "group " + group +
         "\nmeasurement CameraVector 1 master\ndt 50.0\nicon sphere\n" + axes +
         "positionX " + x +
         " GUI slider positionX -2.0 2.0\n"
         "positionY  1.78062 GUI slider positionY -1.0 3.0\n"
         "positionZ -0.474881 GUI slider positionZ -2.0 2.0\n"
         "orientationR 51.9\norientationP 88.4\norientationY 104.7\n"
         "r 0.0005 GUI slider noise 0.0001 0.001\nfilename BumbleBee.int\n"
         "measurement CameraVector 1 slave\ndt 50.0\nicon sphere\n"
         "positionX 0.0739932 relative ; 12cm baseline\n"
         "positionY 0.0438570 relative\npositionZ 0.0836754 relative\n" +
         axes;
}

const std::string kPairs =
    "P_P\nvolume meters\n-0.6 -0.1 -1.3\n 0.6 1.5 1.7\n 0.1 0.1 0.1\n"
    "0.003\n0.003\n0.003\n" +
    pair("BumbleBee1", "-0.289502") + pair("BumbleBee2", "0.3") +
    pair("BumbleBee3", "0.6") + pair("BumbleBee4", "0.9");

TEST(Artemis, ReadsTheGroupsOfFigure47) {
  const Imported got = imported({{"a.ext", kPairs}});
  ASSERT_TRUE(got.system) << got.findings;
  EXPECT_EQ(make_samples(got.scene->samples).points.size(), 6851u);
  ASSERT_EQ(got.system->devices.size(), 8u);
  EXPECT_EQ(got.scene->groups.size(), 4u);
  const Pose &master = got.system->devices[0].X_WS(),
             &slave = got.system->devices[1].X_WS();
  EXPECT_LT((slave.p - Eigen::Vector3d(-0.2155088, 1.8244770, -0.3912056)).norm(),
            1e-12);
  const Eigen::Vector3d baseline = slave.p - master.p;
  EXPECT_NEAR(baseline.norm(), 0.12, 5e-7);
  // 0.12 of `left`, which is −x of a camera; `look` is its z.
  EXPECT_LT((baseline + 0.12 * master.R.col(0)).norm(), 1e-6);
  EXPECT_LT((slave.R.col(2) - Eigen::Vector3d(-0.264611, 0.930397, -0.253658)).norm(),
            1e-5);
  EXPECT_NE(got.text.find("'BumbleBee.int' isn't there"), std::string::npos);
  // A master's r is its slave's.
  ASSERT_EQ(got.rig->variables.size(), 16u);
  const auto& noise = got.rig->variables[0];
  EXPECT_EQ(noise.path, "devices.BumbleBee1-master.params.r");
  ASSERT_EQ(noise.tie.size(), 1u);
  EXPECT_EQ(noise.tie[0], "devices.BumbleBee1-slave.params.r");
  EXPECT_EQ(got.rig->variables[1].path, "groups.BumbleBee1.at.x");
}

// Moving the slider positionX of the master moves the slave by the same.
TEST(Artemis, MovesASlaveWithItsMaster) {
  const Imported got = imported({{"a.ext", kPairs}});
  ASSERT_TRUE(got.scene) << got.findings;
  Diagnostics findings;
  const auto moved =
      parse_scene(got.text, "s.yaml", {{"groups.BumbleBee1.at.x", "1.5"}},
                  import_plugins(), findings);
  ASSERT_TRUE(moved);
  const System system = build_system(*moved, import_plugins());
  for (std::size_t i : {0, 1}) {
    const Eigen::Vector3d by =
        system.devices[i].X_WS().p - got.system->devices[i].X_WS().p;
    EXPECT_LT((by - Eigen::Vector3d(1.5 + 0.289502, 0, 0)).norm(), 1e-12);
  }
}

// "measurement AcousticRange 4" and four sets of flags are four measurements.
TEST(Artemis, ReadsSeveralMeasurementsUnderOneLine) {
  std::string text = "P_PV\nvolume meters\n0 0 0\n4 4 3\n1 1 1\n" + kQ +
                     "measurement AcousticRange 2\n";
  for (const char* x : {"0.5", "3.5"})
    text += std::string("dt 50\nposition ") + x + " 0.5 3.5\nr 0.005\n";
  const Imported got = imported({{"a.ext", text}});
  ASSERT_TRUE(got.system) << got.findings;
  ASSERT_EQ(got.system->devices.size(), 2u);
  EXPECT_EQ(got.system->devices[1].X_WS().p, Eigen::Vector3d(3.5, 0.5, 3.5));
}

// §4.2.3: a camera's intrinsic parameters stand in a file of their own.
TEST(Artemis, ReadsALensFromItsFile) {
  const Imported got = imported(
      {{"a.ext", kPairs},
       {"BumbleBee.int", "focal 6 mm ; lens\npitch 7.4 um\nresolution 640 480\n"}});
  ASSERT_TRUE(got.system) << got.findings;
  EXPECT_NEAR(got.system->devices[1].params["focal"], 0.006, 1e-15);
}

TEST(Artemis, SaysWhatIsWrong) {
  const auto says = [](const std::string& text, const std::string& part) {
    const Imported got = imported({{"a.ext", text}});
    EXPECT_FALSE(got.rig) << text;
    EXPECT_NE(got.findings.find(part), std::string::npos) << got.findings;
  };
  const std::string head = "P_PV\nvolume meters\n0 0 0\n4 4 3\n1 1 1\n";
  says("P_PV\nvolume kilograms\n",
       "a.ext:2: error: the second line is 'volume meters'");
  says("P_PV\nvolume meters\n0 0 0\n", "three lines of three numbers");
  says("P_PV\nPointList meters\nnone.ptl\n", "none.ptl' isn't there");
  says(head + "1\n2\n", "this state has 3 lines of q, and 2 are there");
  says(head + kQ, "has no measurement");
  says(head + kQ + "measurement Sonar 1\ndt 50\nr 1\n", "'Sonar' isn't a measurement");
  says(head + kQ + "measurement AcousticRange 1\nr 1\n", "needs 'dt'");
  says(head + kQ + "measurement AcousticRange 1\ndt 5\nr 1 GUI wheel R 0 1\n",
       "'wheel' is no control");
  says(head + kQ + "measurement AcousticRange 1\ndt 5\nr 1 GUI slider R 2 1\n",
       "two numbers, the lesser first");
  says(head + kQ + "measurement CameraVector 1 slave\ndt 5\nr 1\n",
       "a slave without a master");
}

// 200 damaged files: a scene in order, or what is wrong with the file or the scene.
TEST(Artemis, ReadsOrRefusesDamagedFiles) {
  const std::vector<std::string> words = {"GUI",   "slave",      "relative", "-1",
                                          "1e999", "\n",         ";",        "group",
                                          "0",     "measurement"};
  std::uint64_t state = 5;
  const auto below = [&](std::size_t n) {
    state = state * 6364136223846793005ull + 1442695040888963407ull;
    return static_cast<std::size_t>(state >> 33) % std::max<std::size_t>(n, 1);
  };
  for (int i = 0; i < 200; ++i) {
    std::string text = kPairs;
    for (int hit = 0; hit < 3; ++hit) {
      const std::size_t at = below(text.size());
      if (below(2) == 0)
        text.erase(at, below(50));
      else
        text.insert(at, " " + words[below(words.size())] + " ");
    }
    const Imported got = imported({{"a.ext", text}});
    ASSERT_TRUE(got.rig || !got.findings.empty()) << text;
    if (got.rig) {
      ASSERT_TRUE(got.scene || !got.findings.empty()) << got.text;
    }
  }
}

}  // namespace
}  // namespace delos::test
