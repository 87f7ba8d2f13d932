// Files that aren't read, and what is said of them.
#include <gtest/gtest.h>

#include "imports/imported.h"

namespace delos::test {
namespace {

std::string said(const std::string& name, const std::string& text,
                 const imports::ImportOptions& options = {}) {
  const Imported got = imported({{name, text}}, options);
  return (got.rig ? "read: " : "refused: ") + got.findings;
}

/// The rig as a format writes it, with one part of its text in place of another.
std::string with(std::size_t rig, const std::string& from, const std::string& to) {
  WrittenRig written = written_rigs()[rig];
  std::string text = written.files[0].second;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  if (at != std::string::npos) text.replace(at, from.size(), to);
  return said(written.files[0].first, text, written.options);
}

void expect_part(const std::string& found, const std::string& part) {
  EXPECT_NE(found.find(part), std::string::npos) << found;
}

TEST(Refusal, SaysWhatAFileIs) {
  expect_part(said("a.toml", ""), "refused: a.toml: error: is empty");
  expect_part(said("a.yaml", "delos: 1\n"), "isn't of a format that is known");
  expect_part(said("a.pickle", "\x80\x04\x95 abc"), "is a Python pickle");
  expect_part(said("a.cal", std::string("\x01\x00\x00\x00 abc", 8)),
              "calibrations of Motive before 3.2 (.cal)");
  expect_part(said("a.xml", "<calibration><cameras>"), "is the file cut off?");
  expect_part(said("a.toml", "[cam_0]\nmatrix = [[1,"),
              "a.toml:2: error: isn't whole TOML");
  std::string deep(100'000, '[');
  expect_part(said("a.json", deep), "refused:");
  std::string elements;
  for (int i = 0; i < 100'000; ++i) elements += "<a>";
  expect_part(said("a.xml", elements), "refused:");
}

TEST(Refusal, SaysWhichUnitsAreConfused) {
  WrittenRig anipose = written_rigs()[5];
  expect_part(said("a.toml", anipose.files[0].second), "say which by --unit mm");
  // Places in metres where they should be in mm: a room of 4 mm.
  imports::ImportOptions micro;
  micro.unit = 1e-6;
  expect_part(said("a.qca.txt", written_rigs()[0].files[0].second, micro),
              "read: a.qca.txt: warning: cameras are only 7.");
  imports::ImportOptions metres;
  metres.unit = 1;
  expect_part(said("a.qca.txt", written_rigs()[0].files[0].second, metres),
              "are lengths in millimetres? --unit mm says so");
  // A lens in pixels where 1/64 px are meant, as Theia writes it.
  expect_part(with(0, "sensorMaxU=\"81856\"", "sensorMaxU=\"1279\""),
              "its lens is in pixels, as Theia writes it");
  expect_part(with(3, "901.5", "57696"), "a focal length of 57696 px doesn't go with");
}

TEST(Refusal, SaysWhatCanNotBe) {
  // An axis the wrong way round.
  WrittenRig h36m = written_rigs()[9];
  std::string& text = h36m.files[0].second;
  const std::size_t R = text.find("\"R\": [[");
  const std::size_t end = text.find("],", R);
  std::string row = text.substr(R + 7, end - R - 7), mirrored;
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (i == 0 || row[i - 1] == ' ') mirrored += row[i] == '-' ? "" : "-";
    if (row[i] != '-' || (i > 0 && row[i - 1] == 'e')) mirrored += row[i];
  }
  text.replace(R + 7, end - R - 7, mirrored);
  expect_part(said("a.json", text, h36m.options), "it mirrors, which no camera does");
  imports::ImportOptions s7;
  s7.subject = "S7";
  expect_part(said("a.json", written_rigs()[9].files[0].second, s7),
              "has no subject 'S7'; it has S1 and S5");
  expect_part(with(15, "names", "names"), "intri.yml:");
  expect_part(with(7, "pinhole", "omni"), "is of the model 'omni'");
  expect_part(with(10, "OPENCV8", "CAHVOR"), "isn't a lens that Delos has");
  expect_part(with(13, "plumb_bob", "thin"), "is distorted as 'thin'");
}

// World to camera taken for camera to world: all look away from where they should.
TEST(Refusal, SaysThatAllLookAway) {
  std::vector<TrueCamera> rig = true_rig(0);
  std::string text;
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Matrix3d R = Eigen::Vector3d(-1, 1, -1).asDiagonal() * rig[i].R;
    text += "[c" + std::to_string(i) +
            "]\nfisheye = false\nsize = [1280, 1024]\nmatrix = "
            "[[900, 0, 640], [0, 900, 512], [0, 0, 1]]\ndistortions = [0, 0, 0, 0]\n"
            "rotation = [";
    for (int k = 0; k < 9; ++k)
      text += (k > 0 ? ", " : "") + std::to_string(R(k / 3, k % 3));
    const Eigen::Vector3d t = Eigen::Vector3d(-1, 1, -1).asDiagonal() * rig[i].t;
    text += "]\ntranslation = [" + std::to_string(t.x()) + ", " +
            std::to_string(t.y()) + ", " + std::to_string(t.z()) + "]\n";
  }
  expect_part(said("a.toml", text), "refused: a.toml: error: all devices look away");
}

// Crazyflie's frame: x out of the glass, y left, z up; here z forward, x right, y down.
TEST(Lighthouse, StandsAndLooksAsItsFileSays) {
  const std::string text =
      "type: lighthouse_system_configuration\nversion: '1'\nsystemType: 2\ngeos:\n"
      "  0:\n    origin: [-2.0, 0.5, 2.0]\n    rotation:\n"
      "    - [0.8, 0.0, 0.6]\n    - [0.0, 1.0, 0.0]\n    - [-0.6, 0.0, 0.8]\n"
      "  1:\n    origin: [2.0, -0.5, 2.0]\n    rotation:\n"
      "    - [-0.8, 0.0, -0.6]\n    - [0.0, -1.0, 0.0]\n    - [-0.6, 0.0, 0.8]\n"
      "calibs: {}\n";
  const Imported got = imported({{"geo.yaml", text}});
  ASSERT_TRUE(got.system) << got.findings;
  ASSERT_EQ(got.system->devices.size(), 2u);
  const PlacedDevice& station = got.system->devices[0];
  EXPECT_EQ(station.params.choice("generation"), "v2");
  EXPECT_LT((station.X_WS().R.col(2) - Eigen::Vector3d(0.8, 0, -0.6)).norm(), 1e-12);
  EXPECT_LT((station.X_WS().R.col(0) - Eigen::Vector3d(0, -1, 0)).norm(), 1e-12);
  // V2 of formats: atan2(y, x) ± asin(z tan(30°)/√(x² + y²)) of p = Rᵀ(p_W − origin).
  const Eigen::Vector3d p_W(0.3, 0.2, 0.4);
  Eigen::Matrix3d R;
  R << 0.8, 0, 0.6, 0, 1, 0, -0.6, 0, 0.8;
  const Eigen::Vector3d p = R.transpose() * (p_W - Eigen::Vector3d(-2, 0.5, 2));
  Observation out;
  ASSERT_TRUE(station.device->observe(
      Target{.p_ST = station.X_WS().inverse() * p_W, .state = {}}, out));
  const double azimuth = std::atan2(p.y(), p.x());
  const double tilt = std::asin(p.z() * std::tan(M_PI / 6) / std::hypot(p.x(), p.y()));
  // Delos's angles grow to the right and downwards: the other way round.
  EXPECT_NEAR(out.z(0), -azimuth - tilt, 1e-12);
  EXPECT_NEAR(out.z(1), -azimuth + tilt, 1e-12);
}

}  // namespace
}  // namespace delos::test
