// Cameras written as matrices, and read again.
#include <gtest/gtest.h>

#include "imports/camera_export.h"
#include "imports/imported.h"

namespace delos::test {
namespace {

// P takes a point to the pixel that OpenCV's formulas have without distortion.
TEST(Export, OfMatricesProjectsAsTheCamerasDo) {
  const auto rig = true_rig(0);
  WrittenRig written = written_rigs()[2];
  const Imported got = imported(written.files, written.options);
  ASSERT_TRUE(got.system) << got.findings;
  const auto cameras = imports::cameras_of(*got.system);
  ASSERT_EQ(cameras.size(), rig.size());
  for (std::size_t i = 0; i < rig.size(); ++i) {
    const Eigen::Vector3d p(0.3, -0.2, 1.1);
    const Eigen::Vector3d image = imports::projection(cameras[i]) * p.homogeneous();
    EXPECT_LT((image.hnormalized() - rig[i].image(p)).norm(), 1e-9);
  }
}

// Out as cv::FileStorage and in again: the same lenses, and the same places to
// rounding.
TEST(Export, IsReadAgain) {
  for (const std::size_t each : {0, 6, 10}) {
    const WrittenRig written = written_rigs()[each];
    const Imported first = imported(written.files, written.options);
    ASSERT_TRUE(first.system) << first.findings;
    const std::string text = imports::matrices_text(imports::cameras_of(*first.system),
                                                    imports::MatrixFormat::opencv_yaml);
    const Imported again = imported({{"rig.yml", text}});
    ASSERT_TRUE(again.system) << again.findings << text;
    ASSERT_EQ(again.system->devices.size(), first.system->devices.size());
    for (std::size_t i = 0; i < first.system->devices.size(); ++i) {
      const PlacedDevice &a = first.system->devices[i], &b = again.system->devices[i];
      EXPECT_EQ(a.params, b.params) << written.format;
      EXPECT_LT((a.X_WS().p - b.X_WS().p).norm(), 1e-12) << written.format;
      EXPECT_LT((a.X_WS().R - b.X_WS().R).norm(), 1e-12) << written.format;
    }
  }
}

// A lens and a pitch: 6 mm of 7.4 µm are 810.81 px.
TEST(Export, KnowsPinholes) {
  Diagnostics findings;
  const auto scene = parse_scene(
      "delos: 1\nmotion: {type: position, q: [1, 1, 1]}\nsample: {points: [[0, 0, "
      "0]]}\n"
      "devices:\n"
      "  - {name: a, type: pinhole_camera, rate: 9, at: [0, -2, 0], aim: [0, 0, 0],\n"
      "     params: {focal: 6 mm, pitch: 7.4 um, resolution: [640, 480]}}\n"
      "  - {name: b, type: uwb_range, rate: 9}\n",
      "s.yaml", {}, import_plugins(), findings);
  ASSERT_TRUE(scene);
  const auto cameras = imports::cameras_of(build_system(*scene, import_plugins()));
  ASSERT_EQ(cameras.size(), 1u);
  // Looking along y, x stays and z of the world is up: −y of the image.
  Eigen::Matrix<double, 3, 4> P;
  const double f = 6e-3 / 7.4e-6;
  P << f, 320, 0, 640, 0, 240, -f, 480, 0, 1, 0, 2;
  EXPECT_LT((imports::projection(cameras[0]) - P).norm(), 1e-9);
  EXPECT_EQ(
      imports::matrices_text(cameras, imports::MatrixFormat::csv).find("\"a\",640,480"),
      imports::matrices_text(cameras, imports::MatrixFormat::csv).find('\n') + 1);
}

}  // namespace
}  // namespace delos::test
