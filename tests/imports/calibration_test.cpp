// Calibrations of each format: what a camera of the scene sees is what the file's own
// convention says.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <random>

#include "imports/imported.h"

namespace delos::test {
namespace {

/// Where a device sees a point of the scene, pixels.
std::optional<Eigen::Vector2d> seen(const PlacedDevice& device,
                                    const Eigen::Vector3d& p_S) {
  Observation out;
  if (!device.device->observe(
          Target{.p_ST = device.X_WS().inverse() * p_S, .state = {}}, out))
    return std::nullopt;
  return Eigen::Vector2d(out.z(0), out.z(1));
}

std::string sample_file(const std::string& name) {
  std::ifstream in(std::string(DELOS_CALIBRATIONS) + "/" + name, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

class Calibrations : public testing::TestWithParam<WrittenRig> {};

// The truth by OpenCV's formulas, which share no code with Delos.
TEST_P(Calibrations, SeeWhatTheirFilesSay) {
  const WrittenRig& given = GetParam();
  const Imported got = imported(given.files, given.options);
  ASSERT_TRUE(got.system) << got.findings << got.text;
  ASSERT_EQ(got.system->devices.size(), given.truth.size());
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> any(-0.6, 0.6);
  int seen_points = 0;
  for (int i = 0; i < 50; ++i) {
    const Eigen::Vector3d p(any(random), any(random), 1 + any(random));
    for (std::size_t c = 0; c < given.truth.size(); ++c) {
      const TrueCamera& truth = given.truth[c];
      const Eigen::Vector3d p_C = truth.R * p + truth.t;
      const PlacedDevice& device = got.system->devices[c];
      const auto at = seen(device, given.placed ? given.X_SW * p : device.X_WS() * p_C);
      if (!at) continue;
      ++seen_points;
      ASSERT_LT((*at - truth.image(p)).norm(), 1e-6)
          << device.name << " of " << p.transpose() << "\n"
          << got.text;
    }
  }
  EXPECT_GT(seen_points, 45 * static_cast<int>(given.truth.size()));
}

// 200 damaged files a format: a scene in order, or an error and why.
TEST_P(Calibrations, ThatAreDamagedAreReadOrRefused) {
  const WrittenRig& given = GetParam();
  const auto& [name, text] = given.files[0];
  const Folder folder;
  for (std::size_t i = 1; i < given.files.size(); ++i)
    folder.write(given.files[i].first, given.files[i].second);
  const std::vector<std::string> words = {"-",  "[",   "{",     "1e999", "nan", "<a>",
                                          "/>", "0",   "\n",    "=",     "\"",  "\xFF",
                                          ":",  "1e9", "*a &a", "-1",    "!!"};
  std::mt19937_64 random(11);
  const auto below = [&](std::size_t n) {
    return random() % std::max<std::size_t>(n, 1);
  };
  for (int i = 0; i < 200; ++i) {
    std::string damaged = text;
    for (std::size_t hits = 1 + below(3); hits > 0; --hits) {
      const std::size_t at = below(damaged.size()), length = below(60);
      switch (below(5)) {
        case 0:
          damaged.erase(at, length);
          break;
        case 1:
          damaged.insert(at, words[below(words.size())]);
          break;
        case 2:
          damaged.resize(at);
          break;
        case 3:
          damaged.insert(at, damaged.substr(below(damaged.size()), length));
          break;
        default:
          if (!damaged.empty()) damaged[at] = static_cast<char>(below(256));
      }
    }
    Diagnostics findings;
    folder.write(name, damaged);
    const auto rig = imports::import_file(folder / name, {}, given.options, findings);
    ASSERT_TRUE(rig || !findings.empty()) << damaged;
    if (!rig) continue;
    const std::string scene = imports::scene_text(*rig, "damaged", name);
    findings.clear();
    const auto read = parse_scene(scene, "s.yaml", {}, import_plugins(), findings);
    ASSERT_TRUE(read) << to_string(findings.at(0)) << "\n" << scene;
    EXPECT_NO_THROW((void)build_system(*read, import_plugins())) << scene;
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, Calibrations, testing::ValuesIn(written_rigs()),
                         [](const auto& rig) {
                           std::string name;
                           for (const char c : rig.param.format)
                             if (std::isalnum(static_cast<unsigned char>(c))) name += c;
                           return name;
                         });

// Motive's coefficients undistort: r_u = r_d (1 + k1 r_d² + …), by hand on the
// diagonal.
TEST(Calibration, OfMotiveTurnsItsDistortionRound) {
  std::string text;
  for (const char c : written_rigs()[2].files[0].second.substr(2))
    if (c != '\0') text += c;
  text.replace(text.find("k1=\"0\" k2=\"0\""), 13, "k1=\"0.1\" k2=\"-0.02\"");
  const Imported got = imported({{"a.mcal", text}});
  ASSERT_TRUE(got.system) << got.findings;
  const TrueCamera truth = true_rig(0)[0];
  for (const double r_d : {0.05, 0.3, 0.5, 0.65}) {
    const double r_u = r_d * (1 + 0.1 * r_d * r_d - 0.02 * std::pow(r_d, 4));
    const PlacedDevice& device = got.system->devices[0];
    const auto at =
        seen(device, device.X_WS() * (2 * Eigen::Vector3d(0.6 * r_u, 0.8 * r_u, 1)));
    ASSERT_TRUE(at) << r_d;
    EXPECT_NEAR(at->x(), truth.c.x() + truth.f.x() * 0.6 * r_d, 0.001) << r_d;
    EXPECT_NEAR(at->y(), truth.c.y() + truth.f.y() * 0.8 * r_d, 0.001) << r_d;
  }
}

// The published samples. Their numbers are in the files; places of Calib.qca.txt in mm.
TEST(Calibration, OfThePublishedSamplesIsRead) {
  const Imported qca = imported({{"c.qca.txt", sample_file("Calib.qca.txt")}});
  ASSERT_TRUE(qca.system) << qca.findings;
  ASSERT_EQ(qca.system->devices.size(), 4u);
  const PlacedDevice& first = qca.system->devices[0];
  EXPECT_LT((first.X_WS().p - Eigen::Vector3d(1.4602323709212087, -1.9091590482454608,
                                              1.8965058524092062))
                .norm(),
            1e-12);
  EXPECT_NEAR(first.params["f_x"], 107599.671875 / 64, 1e-9);
  EXPECT_NEAR(first.params["c_y"], 60680.792969 / 64, 1e-9);
  EXPECT_EQ(first.params.matrix("resolution"), Eigen::Vector2d(1088, 1920));
  // Four cameras on the corners of a capture volume look into it, and down.
  for (const PlacedDevice& device : qca.system->devices) {
    EXPECT_LT(device.X_WS().R(2, 2), -0.3) << device.name;
    EXPECT_TRUE(seen(device, {-0.7, 0, 0.9})) << device.name;
  }
  const Imported scope = imported({{"c.toml", sample_file("caliscope.toml")}});
  ASSERT_TRUE(scope.system) << scope.findings;
  // As scenes/20-stereo-rig.yaml has the same cameras, by hand.
  EXPECT_LT(
      (scope.system->devices[0].X_WS().p - Eigen::Vector3d(0.09554, 0.3174, 1.57449))
          .norm(),
      1e-5);
  const Imported mrcal =
      imported({{"c.cameramodel", sample_file("cam0.opencv8.cameramodel")}});
  ASSERT_TRUE(mrcal.system) << mrcal.findings;
  EXPECT_EQ(mrcal.system->devices[0].params.choice("distortion"), "rational");
  const Imported ros = imported({{"c.yaml", sample_file("ros-camera-info.yaml")}});
  ASSERT_TRUE(ros.system) << ros.findings;
  EXPECT_EQ(ros.system->devices[0].name, "08144361026320a0");
}

}  // namespace
}  // namespace delos::test
