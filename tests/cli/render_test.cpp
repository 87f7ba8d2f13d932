// delos render, as a user runs it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "program.h"

namespace delos::test {
namespace {

TEST(Render, DrawsTheRangeThatFieldPrints) {
  const Folder folder;
  const std::string file = scene("01-acoustic");
  const auto drawn = [&](const std::string& threads) {
    const Finished done =
        run({"render",    file,       "-o",      threads + ".png", "--width",
             "400",       "--height", "300",     "--surface",      "25 mm",
             "--between", "25 mm,",   "--cloud", "--relief",       "10 cm",
             "--slice",   "z",        "--json",  "--threads",      threads},
            folder.path());
    EXPECT_EQ(done.code, 0) << done.err;
    return nlohmann::json::parse(done.out);
  };
  const auto picture = drawn("1");
  const auto field = nlohmann::json::parse(run({"field", file, "--json"}).out);
  EXPECT_EQ(picture["range"]["min"], field["min"]["value"]);
  EXPECT_EQ(picture["range"]["max"], field["max"]["value"]);
  EXPECT_EQ(picture["width"], 400);
  EXPECT_EQ(picture["surfaces"][0]["level"], 0.025);
  EXPECT_GT(picture["surfaces"][0]["area"], 0.16) << "it crosses the column twice";
  EXPECT_EQ(picture["bodies"][0]["low"], 0.025);
  EXPECT_TRUE(picture["bodies"][0]["high"].is_null()) << "it has no end";
  EXPECT_GT(picture["bodies"][0]["volume"], 0);
  drawn("2");
  const std::string png = read_file(folder.path() / "1.png");
  EXPECT_EQ(png.substr(1, 3), "PNG");
  EXPECT_EQ(png, read_file(folder.path() / "2.png"));
}

/// The path of scene 17 spans a surface; its summary is that of the picture.
TEST(Render, DrawsASurfaceThroughAPath) {
  const Folder folder;
  const std::string file = scene("17-crowded-room");
  const Finished done =
      run({"render", file, "-o", "path.png", "--width", "400", "--height", "300",
           "--through", "linear", "--relief", "50 cm", "--json"},
          folder.path());
  ASSERT_EQ(done.code, 0) << done.err;
  const auto picture = nlohmann::json::parse(done.out);
  const auto& through = picture["through"];
  EXPECT_EQ(through["method"], "linear");
  EXPECT_EQ(through["samples"], 257);
  EXPECT_GE(through["min"], picture["range"]["min"])
      << "planes have no extremes between";
  EXPECT_LE(through["max"], picture["range"]["max"]);
  EXPECT_GT(through["blind"], 0);
  const Finished words =
      run({"render", file, "-o", "same.png", "--width", "400", "--height", "300",
           "--through", "linear", "--relief", "50 cm", "--threads", "1"},
          folder.path());
  EXPECT_NE(words.out.find("surface through 257 samples by linear: "),
            std::string::npos)
      << words.out;
  EXPECT_EQ(read_file(folder.path() / "path.png"),
            read_file(folder.path() / "same.png"));
}

/// What can't be drawn is told in a sentence, and no file is written.
TEST(Render, RefusesWhatItCantDraw) {
  const Folder folder;
  const std::string file = scene("01-acoustic");
  const std::vector<std::pair<std::vector<std::string>, std::string>> wrong = {
      {{"--view", "north"}, "--view 'north': should be corner, top"},
      {{"--slice", "w"}, "--slice 'w': should be x, y or z"},
      {{"--slice", "z=high"}, "--slice 'z=high': "},
      {{"--surface", "1 m"}, "the field runs from 17 mm to 81.7 mm"},
      {{"--between", "20 mm"}, "should be two values with a comma between"},
      {{"--between", "30 mm,20 mm"}, "the first is greater than the second"},
      {{"--between", "20 s,"}, "--between '20 s,': "},
      {{"--relief", "high"}, "--relief 'high': "},
      {{"--layers", "box,cells"}, "--layers: there are no cells: the scene isn't"},
      {{"--through", "kriging"}, "--through 'kriging': choose natural-neighbour, "},
      {{"--through", "linear"}, "--through: the scene samples no points, path or mesh"},
      {{"--through", "linear", "--over", "w"}, "--over 'w': choose x, y or z"},
      {{"--through", "linear", "--radius", "0 m"}, "--radius '0 m': must be above 0"},
      {{"--layers", "roof"}, "there is no 'roof'"}};
  for (const auto& [options, sentence] : wrong) {
    std::vector<std::string> words{"render", file, "-o", "no.png"};
    words.insert(words.end(), options.begin(), options.end());
    const Finished done = run(words, folder.path());
    EXPECT_EQ(done.code, 2) << sentence;
    EXPECT_NE(done.err.find(sentence), std::string::npos) << done.err;
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "no.png"));
  }
  EXPECT_EQ(run({"render", file, "-o", "picture.gif"}, folder.path()).code, 2);
}

}  // namespace
}  // namespace delos::test
