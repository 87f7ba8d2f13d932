// Recordings as C3D, BVH and Motive's CSV.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>

#include "recordings/recording.h"
#include "support/folder.h"

namespace delos::recordings {
namespace {

class Formats : public ::testing::Test {
 protected:
  std::optional<Recording> read(const std::string& name, const std::string& text,
                                double unit = 0) {
    findings_.clear();
    const std::filesystem::path file = folder_.path() / name;
    std::ofstream(file, std::ios::binary) << text;
    return read_recording(file, {0, unit}, findings_);
  }
  void refused(const std::string& name, const std::string& text,
               const std::string& part, double unit = 0) {
    EXPECT_FALSE(read(name, text, unit).has_value()) << part;
    ASSERT_FALSE(findings_.empty()) << part;
    EXPECT_NE(to_string(findings_.back()).find(part), std::string::npos)
        << to_string(findings_.back());
  }

  test::Folder folder_;
  Diagnostics findings_;
};

std::string bytes_of(const std::string& name) {
  std::ifstream in(std::string(DELOS_TEST_DATA "/c3d/") + name, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// All six say the same, to a step of the integers. The point's place was read from the
/// bytes by other means.
TEST_F(Formats, C3dOfThreeProcessorsAndTwoKindsOfNumbers) {
  const auto first = read("a.c3d", bytes_of("pc_real.c3d"));
  ASSERT_TRUE(first) << to_string(findings_.at(0));
  EXPECT_NEAR(first->period, 0.02, 1e-15);
  ASSERT_EQ(first->tracks.size(), 36u);
  EXPECT_EQ(first->tracks[0].name, "RFT1");
  ASSERT_EQ(first->tracks[5].at.rows(), 4);
  EXPECT_TRUE(std::isnan(first->tracks[5].at(0, 0))) << "its residual is below 0";
  EXPECT_NEAR(first->tracks[5].at(1, 0), 0.3855003, 1e-7);
  EXPECT_NEAR(first->tracks[5].at(1, 1), -0.3042388, 1e-7);
  EXPECT_NEAR(first->tracks[5].at(1, 2), 0.3556951, 1e-7);
  int gaps = 0;
  for (const char* name : {"pc_int", "dec_real", "dec_int", "sgi_real", "sgi_int"}) {
    const auto other = read("a.c3d", bytes_of(std::string(name) + ".c3d"));
    ASSERT_TRUE(other) << name;
    EXPECT_EQ(other->period, first->period);
    ASSERT_EQ(other->tracks.size(), 36u) << name;
    const double step = std::string(name).ends_with("int") ? 0.2812e-3 : 0;
    for (std::size_t t = 0; t < 36; ++t) {
      EXPECT_EQ(other->tracks[t].name, first->tracks[t].name);
      for (Eigen::Index i = 0; i < 12; ++i) {
        const double a = first->tracks[t].at(i / 3, i % 3),
                     b = other->tracks[t].at(i / 3, i % 3);
        ASSERT_EQ(std::isnan(a), std::isnan(b)) << name;
        gaps += std::isnan(a);
        if (!std::isnan(a)) {
          ASSERT_NEAR(a, b, step) << name;
        }
      }
    }
  }
  EXPECT_EQ(gaps, 5 * 3 * 56);
}

TEST_F(Formats, C3dIsRefusedWithASentence) {
  const std::string good = bytes_of("pc_int.c3d");
  const auto with = [&](std::size_t at, const std::string& bytes) {
    std::string text = good;
    return text.replace(at, bytes.size(), bytes);
  };
  refused("a.c3d", "x", "doesn't begin as a C3D file does");
  refused("a.c3d", good.substr(0, 1024), "ends before its 4 frames of 36 points");
  refused("a.c3d", good.substr(0, good.size() - 1), "was it copied whole?");
  refused("a.c3d", with(515, "\x10"), "processor 16; known: 84 (PC)");
  refused("a.c3d", with(2, std::string(2, '\0')), "has no points");
  const std::size_t units = good.find("UNITS");
  ASSERT_NE(units, std::string::npos);
  const std::size_t rate = good.find("RATE", good.find("POINT"));
  EXPECT_TRUE(read("a.c3d", good));
  refused("a.c3d", with(rate + 8, std::string(4, '\0')), "POINT:RATE isn't above 0");
}

const std::string kBvh =
    "HIERARCHY\nROOT Hips\n{\n  OFFSET 0 0 0\n  CHANNELS 6 Xposition Yposition "
    "Zposition Zrotation Xrotation Yrotation\n  JOINT Left Arm\n  {\n    OFFSET 10 0 "
    "0\n"
    "    CHANNELS 3 Zrotation Yrotation Xrotation\n    JOINT Hand {\n      OFFSET 0 5 "
    "0\n      CHANNELS 0\n      End Site\n      {\n        OFFSET 0 0 1\n      }\n    "
    "}\n  }\n}\nMOTION\nFrames: 3\nFrame Time: 0.04\n"
    "1 2 3 0 0 0 0 0 0\n1 2 3 90 0 0 0 0 0\n1 2 3 0 0 0 0 90 0\n";

/// Turns by 90 degrees, by hand: Rz takes x to y and y to −x, Ry leaves y.
TEST_F(Formats, BvhPlacesEveryJoint) {
  const auto got = read("a.bvh", kBvh, 0.01);
  ASSERT_TRUE(got) << to_string(findings_.at(0));
  EXPECT_EQ(got->period, 0.04);
  ASSERT_EQ(got->tracks.size(), 3u);
  EXPECT_EQ(got->tracks[1].name, "Left Arm");
  const auto at = [&](std::size_t joint, Eigen::Index frame) -> Eigen::Vector3d {
    return 100 * got->tracks[joint].at.row(frame).transpose();
  };
  const auto expect = [](const Eigen::Vector3d& p, double x, double y, double z) {
    EXPECT_LT((p - Eigen::Vector3d(x, y, z)).norm(), 1e-12) << p.transpose();
  };
  expect(at(0, 0), 1, 2, 3);
  expect(at(1, 0), 11, 2, 3);
  expect(at(2, 0), 11, 7, 3);
  expect(at(1, 1), 1, 12, 3);
  expect(at(2, 1), -4, 12, 3);
  expect(at(2, 2), 11, 7, 3);
}

/// The order of the channels is that of the turns: Rz(90°) Rx(90°) takes y to z, and
/// Rx(90°) Rz(90°) takes it to −x.
TEST_F(Formats, BvhTurnsInTheOrderOfItsChannels) {
  const auto hand = [&](const std::string& order) -> Eigen::Vector3d {
    const auto got = read("a.bvh",
                          "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 2 " + order +
                              "\nJOINT b\n{\nOFFSET 0 1 0\nCHANNELS 0\nEnd Site\n{\n"
                              "OFFSET 0 0 0\n}\n}\n}\nMOTION\nFrames: 2\nFrame Time: "
                              "0.1\n90 90\n90 90\n",
                          1);
    return got ? Eigen::Vector3d(got->tracks[1].at.row(0).transpose())
               : Eigen::Vector3d(9, 9, 9);
  };
  EXPECT_LT((hand("Zrotation Xrotation") - Eigen::Vector3d(0, 0, 1)).norm(), 1e-12);
  EXPECT_LT((hand("Xrotation Zrotation") - Eigen::Vector3d(-1, 0, 0)).norm(), 1e-12);
}

TEST_F(Formats, BvhIsRefusedWithASentence) {
  const auto with = [](const std::string& from, const std::string& to) {
    std::string text = kBvh;
    return text.replace(text.find(from), from.size(), to);
  };
  refused("a.bvh", kBvh, "doesn't say the unit of its lengths; give --unit");
  refused("a.bvh", with("OFFSET 10 0 0", "OFFSET 10 0"), "the three numbers", 1);
  refused("a.bvh", with("Zrotation", "Wrotation"), "'Wrotation' is no channel", 1);
  refused("a.bvh", with("CHANNELS 0", "CHANNELS 7"), "up to 6 channels", 1);
  refused("a.bvh", with("Frames: 3", "Frames: 4"), "has 3 frames; its head says 4", 1);
  refused("a.bvh", with("Frame Time: 0.04", "Frame Time: 0"), "expected 'Frames: N'",
          1);
  refused("a.bvh", with("1 2 3 90 0 0 0 0 0", "1 2 3 90 0 0 0 0"),
          "has 8 numbers; the joints have 9 channels", 1);
  refused("a.bvh", with("1 2 3 90", "1 2 q 90"), "'q' isn't a number", 1);
  refused("a.bvh", kBvh.substr(0, kBvh.find("MOTION")), "ends before MOTION", 1);
}

const std::string kMotive =
    "Format Version,1.23,Take Name,walk,Capture Frame Rate,240.000000,Export Frame "
    "Rate,120.000000,Rotation Type,Quaternion,Length Units,Centimeters,Coordinate "
    "Space,Global\n\n"
    ",Type,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid "
    "Body,Marker,Marker,Marker\n"
    ",Name,Head,Head,Head,Head,Head,Head,Head,Head:1,Head:1,Head:1\n"
    ",ID,1,1,1,1,1,1,1,2,2,2\n"
    ",,Rotation,Rotation,Rotation,Rotation,Position,Position,Position,Position,"
    "Position,"
    "Position\n"
    "Frame,Time (Seconds),X,Y,Z,W,X,Y,Z,X,Y,Z\n"
    "0,0.000000,0,0,0,1,100,170,5,101,170,5\n"
    "1,0.008333,0,0,0,1,101,170,5,,,\n"
    "2,0.016667,0,0,0,1,102,170,5,103,171,5\n";

TEST_F(Formats, MotiveIsReadByItsHead) {
  const auto got = read("a.csv", kMotive);
  ASSERT_TRUE(got) << to_string(findings_.at(0));
  EXPECT_NEAR(got->period, 1 / 120.0, 1e-15) << "of the export, not of the capture";
  ASSERT_EQ(got->tracks.size(), 2u);
  EXPECT_EQ(got->tracks[0].name, "Head");
  EXPECT_EQ(got->tracks[1].name, "Head:1");
  EXPECT_NEAR(got->tracks[0].at(2, 0), 1.02, 1e-12) << "positions, not quaternions";
  EXPECT_NEAR(got->tracks[1].at(2, 1), 1.71, 1e-12);
  EXPECT_TRUE(std::isnan(got->tracks[1].at(1, 0)));
}

TEST_F(Formats, MotiveIsRefusedWithASentence) {
  const auto with = [](const std::string& from, const std::string& to) {
    std::string text = kMotive;
    return text.replace(text.find(from), from.size(), to);
  };
  refused("a.csv", with("Length Units", "Units"), "'' is no unit of length");
  refused("a.csv", with("Centimeters", "Cubits"), "'Cubits' is no unit of length");
  refused("a.csv", with("120.000000", "240"), "frames are 119.9976 a second");
  refused("a.csv", with("Frame,Time", "Frames,Time"), "no lines of names and axes");
  refused("a.csv", with("101,170,5,,,", "101,170,x,,,"), "'x' isn't a number");
}

/// What is missing is kept in memory: not without bounds.
TEST_F(Formats, GapsAreBounded) {
  std::string text = "t,x,y,z\n";
  for (int i = 0; i < 10; ++i) text += std::to_string(i) + ",1,2,3\n";
  EXPECT_TRUE(read("a.csv", text + "500,1,2,3\n"));
  refused("a.csv", text + "900000,1,2,3\n", "more than nine of ten frames are missing");
}

}  // namespace
}  // namespace delos::recordings
