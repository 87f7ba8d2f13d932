// Recordings of three formats, and what is wrong with bad ones.
#include "recordings/recording.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "support/folder.h"

namespace delos::recordings {
namespace {

class Recordings : public ::testing::Test {
 protected:
  std::optional<Recording> read(const std::string& name, const std::string& text,
                                double rate = 0) {
    findings_.clear();
    const std::filesystem::path file = folder_.path() / name;
    std::ofstream(file, std::ios::binary) << text;
    return read_recording(file, {rate}, findings_);
  }
  /// The first finding, after the name of the file's folder.
  std::string refused(const std::string& name, const std::string& text,
                      double rate = 0) {
    EXPECT_FALSE(read(name, text, rate).has_value()) << text;
    if (findings_.empty()) return "";
    const std::string all = to_string(findings_.front());
    return all.substr(all.find(name));
  }

  test::Folder folder_;
  Diagnostics findings_;
};

TEST_F(Recordings, AreReadFromCsv) {
  const auto got = read("a.csv",
                        "\xEF\xBB\xBFt [ms], hand.x [mm], hand.y [mm], hand.z [mm], "
                        "foot_x, foot_y, foot_z\r\n"
                        "0, 1000, 0, 2, 1, 2, 3\r\n10,1001,,nan,1,2,3\r\n"
                        "30,1003,0,2,1,2,4\r\n40,1004,0,2,1,2,4\r\n");
  ASSERT_TRUE(got) << to_string(findings_.at(0));
  EXPECT_NEAR(got->period, 0.01, 1e-15);
  ASSERT_EQ(got->tracks.size(), 2u);
  EXPECT_EQ(got->tracks[0].name, "hand");
  EXPECT_EQ(got->tracks[1].name, "foot");
  const auto& hand = got->tracks[0].at;
  ASSERT_EQ(hand.rows(), 5);
  EXPECT_EQ(hand(0, 0), 1);
  EXPECT_TRUE(std::isnan(hand(1, 1)) && std::isnan(hand(1, 2)));
  EXPECT_TRUE(std::isnan(hand(2, 0))) << "a frame is missing";
  EXPECT_NEAR(hand(4, 0), 1.004, 1e-12);
  EXPECT_EQ(got->tracks[1].at(4, 2), 4);
}

TEST_F(Recordings, AreReadFromCsvWithoutTimes) {
  const auto got = read("a.csv", "x;y;z\n1;2;3\n2;2;3\n", 50);
  ASSERT_TRUE(got);
  EXPECT_NEAR(got->period, 0.02, 1e-15);
  EXPECT_EQ(got->tracks[0].at(1, 0), 2);
}

TEST_F(Recordings, AreReadFromTum) {
  const auto got = read("a.tum",
                        "# t x y z qx qy qz qw\n10.00 1 2 3 0 0 0 1\n"
                        "10.05 1.5 2 3 0 0 0 1\n10.10  2 2 3 0 0 0 1\n");
  ASSERT_TRUE(got);
  EXPECT_NEAR(got->period, 0.05, 1e-12);
  EXPECT_EQ(got->tracks[0].at(2, 0), 2);
}

/// With tabs and with commas, with a blank line after the head, a marker named twice, a
/// gap, and a line that is cut off.
TEST_F(Recordings, AreReadFromTrc) {
  const std::string text =
      "PathFileType\t4\t(X/Y/Z)\ta.trc\n"
      "DataRate\tCameraRate\tNumFrames\tNumMarkers\tUnits\n"
      "100\t100\t3\t2\tmm\n"
      "Frame#\tTime\thead\t\t\thead\t\t\n"
      "\t\tX1\tY1\tZ1\tX2\tY2\tZ2\n"
      "\n"
      "1\t0.00\t1000\t2\t3\t1\t2\t3\n"
      "2\t0.01\t1001\t2\t3\t\t\t\n"
      "3\t0.02\t1002\t2\t3\n";
  std::string commas = text;
  for (char& c : commas)
    if (c == '\t') c = ',';
  for (const std::string& each : {text, commas}) {
    const auto got = read("a.trc", each);
    ASSERT_TRUE(got) << to_string(findings_.at(0));
    EXPECT_NEAR(got->period, 0.01, 1e-15);
    ASSERT_EQ(got->tracks.size(), 2u);
    EXPECT_EQ(got->tracks[1].name, "head#2");
    EXPECT_NEAR(got->tracks[0].at(2, 0), 1.002, 1e-12);
    EXPECT_NEAR(got->tracks[1].at(0, 2), 0.003, 1e-15);
    EXPECT_TRUE(std::isnan(got->tracks[1].at(1, 0)));
    EXPECT_TRUE(std::isnan(got->tracks[1].at(2, 0)));
    EXPECT_TRUE(findings_.empty());
    ASSERT_TRUE(read("a.trc", each.substr(0, each.find("3\t0.02"))));
    if (each == text) {
      EXPECT_EQ(findings_.at(0).message,
                "has 2 frames, but its NumFrames says 3; was it copied whole?");
    }
  }
}

TEST_F(Recordings, AreRefusedWithASentence) {
  const auto says = [](const std::string& found, const std::string& part) {
    EXPECT_NE(found.find(part), std::string::npos) << found;
  };
  says(refused("a.csv", ""), "a.csv:1: error: is empty");
  says(refused("a.csv", "t,x,y\n"),
       "a.csv:1:1: error: has x of '' without its y and z");
  says(refused("a.csv", "t,a,b\n1,2,3\n"), "names no x, y and z");
  says(refused("a.csv", "x,y,z\n1,2,3\n2,2,3\n"), "has no time");
  says(refused("a.csv", "t,x [kg],y,z\n"),
       "a.csv:1:3: error: 'kg' is no unit of length");
  says(refused("a.csv", "t,x,y,z\n0,1,2,3\n"), "one frame doesn't show");
  says(refused("a.csv", "t,x,y,z\n0,1,2,3\n1,1,b,3\n"),
       "a.csv:3:5: error: 'b' isn't a number");
  says(refused("a.csv", "t,x,y,z\n0,1,2,3\n1,1,2\n"), "a.csv:3:1: error: has 3 cells");
  says(refused("a.csv", "t,x,y,z\n0,1,2,3\n2,1,2,3\n1,1,2,3\n"),
       "a.csv:4:1: error: its time, 1 s, isn't after");
  says(refused("a.csv", "t,x,y,z\n0,1,2,3\n1,1,2,3\n2,1,2,3\n3.4,1,2,3\n"),
       "times must be evenly spaced");
  says(refused("a.csv", "t,x,y,z\n0,1,2,3\n0.01,1,2,3\n0.02,1,2,3\n", 50),
       "frames are 100 a second by their times, but 50");
  says(refused("a.trc", "frames\n"), "doesn't begin as a TRC file does");
  says(refused("a.trc",
               "PathFileType\nDataRate,Units\n50,mm\nFrame#,Time,a,,\n,,X1,Y1,Z1\n"
               "1,0,1,2,3\n2,0.01,1,2,3\n3,0.02,1,2,3\n"),
       "frames are 100 a second by their times, but 50");
  says(refused("a.trc", "PathFileType\nDataRate,Units\n0,furlong\n,,a\n,\n"),
       "its DataRate isn't above 0");
  says(refused("a.tum", "1 2 3\n"), "a.tum:1:1: error: has 3 numbers");
  says(refused("a.xyz", "x"), "isn't a kind of recording that is read");
  Diagnostics none;
  EXPECT_FALSE(read_recording(folder_.path() / "b.csv", {}, none));
  EXPECT_EQ(none.size(), 1u);
}

}  // namespace
}  // namespace delos::recordings
