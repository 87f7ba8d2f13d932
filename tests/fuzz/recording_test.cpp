// Damaged recordings: places that are finite or gaps, or a finding that names the file.
#include "recordings/recording.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>

#include "fuzz/damage.h"

namespace delos::fuzz {
namespace {

void damage_recordings(const std::string& suffix, const std::vector<std::string>& seeds,
                       const std::vector<std::string>& words) {
  const ScratchFile file("." + suffix);
  damage(suffix, seeds, words, [&](const std::string& bytes) -> std::string {
    file.write(bytes);
    Diagnostics findings;
    const auto got = recordings::read_recording(file.path(), {0, 0.01}, findings);
    bool error = false;
    for (const Diagnostic& d : findings) {
      error = error || d.severity == Severity::error;
      if (d.where.file != file.path()) return "a finding of another file";
    }
    if (got.has_value() == error) return "neither a recording nor an error, or both";
    if (!got) return "";
    if (!(got->period > 0) || got->tracks.empty()) return "no period, or no tracks";
    for (const recordings::Track& track : got->tracks) {
      if (track.at.rows() < 2) return "fewer than two frames";
      if (track.at.array().isInf().any()) return "a place that is infinite";
    }
    return "";
  });
}

TEST(FuzzRecording, Text) {
  damage_recordings(
      "csv",
      {"t [s],hand.x [mm],hand.y [mm],hand.z [mm]\n0,1,2,3\n0.1,1,,3\n0.2,1,2,3\n",
       "Format Version,1.23,Export Frame Rate,100,Length Units,Meters\n,Name,a,a,a\n,,"
       "Position,Position,Position\nFrame,Time,X,Y,Z\n0,0,1,2,3\n1,0.01,1,2,3\n"},
      {"Format Version", "Length Units", "[mm]", ",", "\t", ";", "Position", "nan"});
}

TEST(FuzzRecording, Bvh) {
  damage_recordings(
      "bvh",
      {"HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 4 Xposition Yposition Zposition "
       "Zrotation\nJOINT b {\nOFFSET 0 1 0\nCHANNELS 1 Xrotation\nEnd Site\n{\nOFFSET "
       "0 0 0\n}\n}\n}\nMOTION\nFrames: 2\nFrame Time: 0.1\n1 2 3 4 5\n1 2 3 4 6\n"},
      {"JOINT c\n{\n", "End Site", "{", "}", "MOTION\n", "CHANNELS 0\n", "OFFSET ",
       "Frames: ", "Frame Time: ", "ROOT "});
}

TEST(FuzzRecording, C3d) {
  std::vector<std::string> seeds;
  for (const char* name : {"pc_int", "dec_real", "sgi_int"}) {
    std::ifstream in(DELOS_TEST_DATA "/c3d/" + std::string(name) + ".c3d",
                     std::ios::binary);
    seeds.emplace_back(std::istreambuf_iterator<char>(in),
                       std::istreambuf_iterator<char>());
    // The head and the parameters are where a reader can be led astray.
    ASSERT_GT(seeds.back().size(), 7000u);
  }
  damage_recordings("c3d", seeds,
                    {"\xff\xff", std::string(4, '\0'), "\x7f\x80\x00\x00", "POINT",
                     "LABELS", "\x01P"});
}

}  // namespace
}  // namespace delos::fuzz
