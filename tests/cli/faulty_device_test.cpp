// Devices that answer with nonsense: refused by their name, never taken for perfect.
#include <gtest/gtest.h>

#include <ostream>

#include "program.h"

namespace delos::test {
namespace {

/// Four sound ranges and a fifth, by a plugin that misbehaves.
std::string room_with(const std::string& params, bool carried = false) {
  std::string text = R"(delos: 1
motion: {type: position_velocity, q: [0.4, 0.4, 0.4]}
sample: {volume: {min: [1, 1, 1], max: [2, 2, 2], step: 0.5}}
beacons: {wall: {list: [[5, 5, 5], [5, 0, 5]]}}
devices:
)";
  for (const char* at : {"[0, 0, 0]", "[4, 0, 1]", "[0, 4, 2]", "[4, 4, 3]"})
    text += std::string("  - {name: a") + at[1] + at[4] + at[7] +
            ", type: uwb_range, rate: 10 Hz, at: " + at + ", params: {sigma: 10 cm}}\n";
  return text + "  - {name: s1, type: faulty, rate: 10 Hz, " +
         (carried ? "mount: target" : "at: [2, 2, 3]") + ", params: {" + params +
         "}}\n";
}

struct Fault {
  const char* params;
  const char* message;  ///< behind "delos: s1 (faulty): its plugin "
};

void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.params; }

class FaultyDevice : public testing::TestWithParam<Fault> {};

TEST_P(FaultyDevice, IsRefusedByItsName) {
  const Folder folder;
  const std::string message =
      std::string("delos: s1 (faulty): its plugin ") + GetParam().message + "\n";
  for (const bool carried : {false, true}) {
    const std::string room =
        folder.write("room.yaml", room_with(GetParam().params, carried)).string();
    for (std::vector<std::string> words :
         {std::vector<std::string>{"field", room, "--json"},
          {"point", room, "--at", "1,1,1"}}) {
      words.insert(words.end(), {"--plugin-dir", DELOS_FAULTY_PLUGINS});
      const Finished done = run(words);
      EXPECT_EQ(done.code, 1) << words[0] << carried << done.out << done.err;
      EXPECT_EQ(done.out, "") << words[0] << carried;
      EXPECT_EQ(done.err, message) << words[0] << carried;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Answers, FaultyDevice,
    testing::Values(
        Fault{"answer: nan", "answers with an R that isn't finite"},
        Fault{"answer: infinite_R", "answers with an R that isn't finite"},
        Fault{"answer: negative", "answers with a variance below 0"},
        Fault{
            "answer: large_R",
            "answers with an R that doesn't have a row and a column for each row of H"},
        Fault{
            "answer: small_R",
            "answers with an R that doesn't have a row and a column for each row of H"},
        Fault{"answer: narrow_H", "answers with an H of the wrong number of columns"},
        Fault{"answer: asymmetric", "answers with an R that isn't symmetric"},
        Fault{"answer: indefinite",
              "answers with an R that isn't a covariance: some combination of its rows "
              "would have a variance below 0"},
        Fault{"answer: wild_H", "answers with an H that isn't finite"},
        Fault{"answer: throws", "fails: the lens is dirty"},
        Fault{"answer: silent", "fails without a reason"},
        Fault{"answer: number", "throws what isn't a std::exception"},
        Fault{"answer: nan, entry: lanes",
              "answers with a variance that is below 0 or isn't a number"},
        Fault{"answer: negative, entry: lanes",
              "answers with a variance that is below 0 or isn't a number"},
        Fault{"answer: rows, entry: lanes",
              "answers for many points with 4 rows, not 0 to 3"},
        Fault{
            "answer: wild_H, entry: lanes",
            "answers with what is beyond the range of a double: an H that is too large "
            "or isn't finite, or too little noise"},
        Fault{"answer: throws, entry: lanes", "fails: the lens is dirty"}));

TEST(FaultyDevice, IsMadeOrRefusedWhereItStands) {
  const Folder folder;
  const std::string place = ":10:5: error: devices.s1: ";
  const auto errors = [&](const std::string& create) {
    const auto room =
        folder.write("room.yaml", room_with("knob: 1, create: " + create));
    const Finished done =
        run({"check", room.string(), "--plugin-dir", DELOS_FAULTY_PLUGINS});
    EXPECT_EQ(done.code, 1);
    return done.err.substr(std::min(done.err.size(), room.string().size()));
  };
  EXPECT_EQ(errors("throws"), place + "the lens is dirty\n");
  EXPECT_EQ(errors("silent"),
            place + "plugin 'faulty' refuses these values without a reason\n");
  EXPECT_EQ(errors("number"),
            place + "plugin 'faulty' throws what isn't a std::exception\n");
}

TEST(FaultyDevice, SoundAnswersPass) {
  const Folder folder;
  const auto room = folder.write("room.yaml", room_with("knob: 1"));
  const Finished done =
      run({"field", room.string(), "--plugin-dir", DELOS_FAULTY_PLUGINS});
  EXPECT_EQ(done.code, 0) << done.err;
}

}  // namespace
}  // namespace delos::test
