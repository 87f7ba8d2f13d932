// delos import and export, as a user types them.
#include <gtest/gtest.h>

#include "program.h"

namespace delos::test {
namespace {

const std::string kCalib = std::string(DELOS_CALIBRATIONS) + "/Calib.qca.txt";

void expect_in(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
}

TEST(Import, MakesASceneThatHasAField) {
  const Folder folder;
  const Finished done =
      run({"import", kCalib, "-o", "rig.yaml", "--picture", "rig.svg"}, folder.path());
  EXPECT_EQ(done.code, 0) << done.err;
  expect_in(done.out,
            "Calib.qca.txt: calibration of Qualisys Track Manager (.qca.txt), 4 "
            "devices\n");
  expect_in(done.out, "  places in mm, lenses in 1/64 px; z up, right-handed;");
  expect_in(done.out, "  cam01: residual 0.402000 (avg-residual)\n");
  expect_in(done.out, "Assumed, since the file doesn't say it:\n");
  expect_in(done.out, "next:    delos field rig.yaml\n");
  const std::string scene = read_file(folder.path() / "rig.yaml");
  expect_in(scene, "# Imported from Calib.qca.txt,");
  expect_in(scene,
            "# Assumed, since the file doesn't say it; change what you know "
            "better:\n");
  expect_in(read_file(folder.path() / "rig.svg"), "cam04</text>");
  const Finished field = run({"field", "rig.yaml", "--json"}, folder.path());
  EXPECT_EQ(field.code, 0) << field.err;
  const Json answer = field.json();
  // All of the box but some of its corners is seen by two cameras or more.
  EXPECT_GT(answer["observable"].get<int>(), answer["samples"].get<int>() / 2);
}

TEST(Import, OnlyLooksWithoutAScene) {
  const Folder folder;
  const Finished done = run({"import", kCalib}, folder.path());
  EXPECT_EQ(done.code, 0) << done.err;
  EXPECT_EQ(folder.files(), 0u);
}

TEST(Import, SaysWhatIsWrongAndWritesNothing) {
  const Folder folder;
  const std::string text = read_file(kCalib);
  const auto cut = folder.write("cut.qca.txt", text.substr(0, text.size() / 2));
  const Finished done = run({"import", cut.string(), "-o", "rig.yaml"}, folder.path());
  EXPECT_EQ(done.code, 1);
  expect_in(done.err, "cut.qca.txt:");
  expect_in(done.err, "is the file cut off?");
  EXPECT_EQ(folder.files(), 1u);
  EXPECT_EQ(run({"import", kCalib, "--unit", "kg"}).code, 2);
  EXPECT_EQ(run({"import", kCalib, "--resolution", "12"}).code, 2);
  EXPECT_EQ(run({"import", "none.toml"}).code, 1);
}

TEST(Export, WritesMatricesOfASceneAndReadsThemAgain) {
  const Folder folder;
  const Finished done =
      run({"export", scene("20-stereo-rig"), "--to", "opencv-yaml", "-o", "rig.yml"},
          folder.path());
  EXPECT_EQ(done.code, 0) << done.err;
  EXPECT_EQ(done.err, "4 cameras of 4 devices\n");
  const Finished again = run({"import", "rig.yml"}, folder.path());
  EXPECT_EQ(again.code, 0) << again.err;
  expect_in(again.out, "calibration of EasyMocap (intri.yml, extri.yml), 4 devices");
  const Finished json = run({"export", scene("20-stereo-rig"), "--to", "json"});
  ASSERT_EQ(json.json().size(), 4u);
  EXPECT_EQ(json.json()[0]["width"], 1280);
  EXPECT_EQ(run({"export", scene("01-acoustic")}).code, 1);
}

TEST(Devices, PresetsNameTheirSources) {
  const Finished done = run({"devices", "imu", "--presets"});
  EXPECT_EQ(done.code, 0);
  expect_in(done.out, "ADIS16448\n  type: imu, params: {rate_noise: 1.6968e-4,");
  expect_in(done.out, "  source: configuration of the EuRoC data set\n");
  EXPECT_EQ(run({"devices", "hiball", "--presets"}).code, 1);
}

}  // namespace
}  // namespace delos::test
