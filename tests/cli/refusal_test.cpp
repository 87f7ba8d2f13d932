// Bad scenes through the program: where the mistake is and what would be right.
#include <gtest/gtest.h>

#include <chrono>
#include <ostream>
#include <stdexcept>

#include "program.h"

namespace delos::test {
namespace {

const std::string kGood = R"(delos: 1
name: Good
motion:
  type: position_velocity
  state: position
  q: [0.4, 0.4, 0.1]
sample:
  points: [[0.1, 0.2, 0.3]]
devices:
  - name: s1
    type: acoustic_range
    rate: 50 Hz
    at: [0, 0, 1]
    params: {r: 0.005}
)";

std::string good_with(const std::string& from, const std::string& to) {
  std::string text = kGood;
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::logic_error("kGood has no " + from);
  return text.replace(at, from.size(), to);
}

std::string plugin_folder() {
  const std::filesystem::path program = DELOS_PROGRAM;
  return (program.parent_path().parent_path() / "lib/delos").string();
}

struct Bad {
  const char* name;
  std::string text;
  std::string message;  ///< behind "scene.yaml:"
};

void PrintTo(const Bad& bad, std::ostream* out) { *out << bad.name; }

/// Lines and columns are counted in the texts above, from 1.
std::vector<Bad> bad_scenes() {
  const std::string points = "points: [[0.1, 0.2, 0.3]]";
  return {
      {"UnknownKey", good_with("name: Good", "nmae: Good"),
       "2:1: error: nmae: unknown key; did you mean 'name'?"},
      {"DuplicateKey", good_with("rate: 50 Hz", "rate: 50 Hz\n    rate: 60 Hz"),
       "13:5: error: devices.s1.rate: duplicate key; the first is on line 12"},
      {"WrongUnit", good_with("at: [0, 0, 1]", "at: [0, 50 Hz, 1]"),
       "13:13: error: devices.s1.at.y: '50 Hz' is a frequency; expected a length such "
       "as '50 mm'"},
      {"NotFinite", good_with("at: [0, 0, 1]", "at: [0, 0, .inf]"),
       "13:16: error: devices.s1.at.z: '.inf' isn't a finite number"},
      {"NegativeNoise", good_with("r: 0.005", "r: -0.005"),
       "14:17: error: devices.s1.params.r: -0.005 is below the least value 0"},
      {"NotSymmetric",
       good_with("[0.4, 0.4, 0.1]", "[[1, 0.5, 0], [0.2, 1, 0], [0, 0, 1]]"),
       "6:6: error: motion.q: is not symmetric: 0.1 is 0.5, 1.0 is 0.2"},
      {"RateZero", good_with("50 Hz", "0 Hz"),
       "12:11: error: devices.s1.rate: must be above 0; a device that is off is left "
       "out"},
      {"EmptySample", good_with(points, "points: []"),
       "8:11: error: sample.points: the list is empty; give at least one"},
      {"MissingFile", good_with(points, "file: nowhere.ptl"),
       "8:9: error: sample.file: there is no readable file 'nowhere.ptl': No such file "
       "or directory"},
      // 1001³ samples of 40 bytes; (1/0.0028 → 357 + 1)³ = 45.9 million are below 50.
      {"BillionPoints",
       good_with(points, "volume: {min: [0, 0, 0], max: [1, 1, 1], step: 0.001}"),
       "8:50: error: sample.volume.step: 1,003,003,001 samples would need about 40 GB; "
       "at most 50,000,000: use step 0.0028 or coarser"},
      {"PluginMisspelt", good_with("acoustic_range", "acoustic_rang"),
       "11:11: error: devices.s1.type: there is no plugin 'acoustic_rang' in " +
           plugin_folder() + "; did you mean 'acoustic_range'?"},
      {"PluginMissing", good_with("acoustic_range", "sonar"),
       "11:11: error: devices.s1.type: there is no plugin 'sonar' in " +
           plugin_folder() +
           "; put its library there, or its folder into DELOS_PLUGIN_PATH"},
      {"NotYaml", good_with("0.3]]", "0.3]"),
       "9:1: error: not a readable YAML text: end of sequence flow not found"},
  };
}

class RefusedScene : public testing::TestWithParam<Bad> {};

/// Alike from every command, on stderr, at once.
TEST_P(RefusedScene, IsLocatedAndExplained) {
  const Folder folder;
  folder.write("scene.yaml", GetParam().text);
  const std::vector<std::vector<std::string>> commands = {
      {"check", "scene.yaml"},
      {"field", "scene.yaml", "--json", "--out", "field.csv"},
      {"point", "scene.yaml", "--at", "0,0,0"}};
  for (const auto& words : commands) {
    const auto start = std::chrono::steady_clock::now();
    const Finished done = run(words, folder.path());
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
    EXPECT_EQ(done.code, 1) << words[0];
    EXPECT_EQ(done.out, "") << words[0];
    EXPECT_EQ(done.err, "scene.yaml:" + GetParam().message + "\n") << words[0];
  }
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "field.csv"));
}

INSTANTIATE_TEST_SUITE_P(Program, RefusedScene, testing::ValuesIn(bad_scenes()),
                         [](const auto& i) { return std::string(i.param.name); });

TEST(RefusedScenes, StandBesideAGoodOne) {
  const Folder folder;
  folder.write("scene.yaml", kGood);
  EXPECT_EQ(run({"check", "scene.yaml"}, folder.path()).code, 0);
}

TEST(RefusedScenes, ReportAllMistakesInOrder) {
  const Folder folder;
  std::string text = good_with("name: Good", "nmae: Good");
  text.replace(text.find("50 Hz"), 5, "50 m");
  text.replace(text.find("r: 0.005"), 8, "r: -1, rr: 2");
  folder.write("scene.yaml", text);
  const Finished done = run({"check", "scene.yaml"}, folder.path());
  EXPECT_EQ(done.code, 1);
  EXPECT_EQ(done.err,
            "scene.yaml:2:1: error: nmae: unknown key; did you mean 'name'?\n"
            "scene.yaml:12:11: error: devices.s1.rate: '50 m' is a length; expected a "
            "frequency such as '100 Hz'\n"
            "scene.yaml:14:17: error: devices.s1.params.r: -1 is below the least value "
            "0\n"
            "scene.yaml:14:21: error: devices.s1.params.rr: unknown key; did you mean "
            "'r'?\n");
}

TEST(RefusedScenes, NameTheMetricsThatThereAre) {
  const Folder folder;
  std::string text = good_with("sample:", "metric: sigma_q\nsample:");
  text.replace(text.find("50 Hz"), 5, "0");
  folder.write("scene.yaml", text);
  const Finished done = run({"check", "scene.yaml"}, folder.path());
  EXPECT_EQ(done.code, 1);
  EXPECT_EQ(
      done.err,
      "scene.yaml:7:9: error: metric: unknown metric 'sigma_q'; this state has "
      "sigma_x sigma_y sigma_z sigma_vx sigma_vy sigma_vz sigma_horizontal "
      "sigma_position eigmax "
      "eiglen mle trace det coverage footprint latency nonlinearity unscented_ratio\n"
      "scene.yaml:13:11: error: devices.s1.rate: must be above 0; a device that is "
      "off is left out\n");
}

}  // namespace
}  // namespace delos::test
