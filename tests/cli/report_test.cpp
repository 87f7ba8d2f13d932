// delos report and what is in it, as a user runs it.
#include <gtest/gtest.h>

#include <fstream>

#include "program.h"

namespace delos::test {
namespace {

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t n = 0;
  for (std::size_t at = text.find(what); at != std::string::npos;
       at = text.find(what, at + what.size()))
    ++n;
  return n;
}

bool has(const std::string& page, const std::string& what) {
  return page.find(what) != std::string::npos;
}

/// Everything is within the file: what the SVG namespace is named fetches nothing.
void expect_self_contained(const std::string& page) {
  EXPECT_EQ(page.rfind("<!DOCTYPE html>", 0), 0u);
  EXPECT_EQ(count(page, "<script"), 0u);
  EXPECT_EQ(count(page, "http"), count(page, "xmlns=\"http://www.w3.org/2000/svg\""));
  EXPECT_EQ(count(page, "href="), count(page, "href=\"data:image/png;base64,"));
  EXPECT_EQ(count(page, "<svg"), count(page, "aria-label="));
  EXPECT_EQ(count(page, ">nan") + count(page, ">inf"), 0u);
}

TEST(Report, OfASceneTellsTheFieldDevicesAndWhereItIsBlind) {
  const Folder folder;
  const Finished done =
      run({"report", scene("06-furnished-lab"), "-o", "lab.html", "--set",
           "sample={volume: {min: [-3, -4.2, 0], max: [1.6, "
           "3.4, 2], step: 0.4}}"},
          folder.path());
  ASSERT_EQ(done.code, 0) << done.err;
  EXPECT_EQ(done.out, "");
  const std::string page = read_file(folder.path() / "lab.html");
  expect_self_contained(page);
  EXPECT_EQ(count(page, "aria-label=\"Map of eigmax"), 3u);
  EXPECT_TRUE(has(page, "Hidden from "));
  EXPECT_TRUE(has(page, "Outside the view of "));
  EXPECT_TRUE(has(page, "device pinhole_camera"));
}

TEST(Report, OfAStudyTellsBeforeAndAfter) {
  const Folder folder;
  const std::vector<std::string> search = {
      "optimize",      scene("10-better-speakers"),
      "--evaluations", "60",
      "--starts",      "2",
      "--samples",     "100",
      "--seed",        "7",
      "--study",       "s.study",
      "--set",         "name=<b>Ours</b> & \"theirs\""};
  ASSERT_EQ(run(search, folder.path()).code, 0);
  ASSERT_EQ(run({"study", "s.study", "lock", "devices.s1.at.z"}, folder.path()).code,
            0);
  const Finished resumed = run({"study", "s.study", "resume", "--json"}, folder.path());
  ASSERT_EQ(resumed.code, 0) << resumed.err;
  const Finished done = run({"report", "s.study", "-o", "s.html"}, folder.path());
  ASSERT_EQ(done.code, 0) << done.err;
  const std::string page = read_file(folder.path() / "s.html");
  expect_self_contained(page);
  // Names are text, wherever they stand.
  EXPECT_FALSE(has(page, "<b>Ours"));
  EXPECT_TRUE(has(page, "<h1>&lt;b&gt;Ours&lt;/b&gt; &amp; &quot;theirs&quot;</h1>"));
  // Three levels, each before, after and as a change.
  EXPECT_EQ(count(page, "aria-label=\"Map of eigmax"), 9u);
  EXPECT_TRUE(has(page, "aria-label=\"Convergence: "));
  EXPECT_TRUE(has(page, "from 61.9 mm to "));
  EXPECT_TRUE(has(page, "All constraints are kept."));
  EXPECT_TRUE(has(page, ">lock devices.s1.at.z<"));
  EXPECT_TRUE(has(page, "(locked)"));
  EXPECT_TRUE(has(page, "--seed 7"));
  EXPECT_TRUE(has(page, "delos study again.study lock devices.s1.at.z\n"));
  EXPECT_TRUE(has(page, "If one device fails"));
  EXPECT_TRUE(has(page, "What the best layouts have in common"));

  // The same study gives the same page.
  ASSERT_EQ(
      run({"report", "s.study", "-o", "t.html", "--threads", "1"}, folder.path()).code,
      0);
  EXPECT_EQ(read_file(folder.path() / "t.html"), page);
}

TEST(Report, ShowsWhatTradeoffFound) {
  const Folder folder;
  const std::vector<std::string> little = {"--evaluations", "40", "--starts", "1",
                                           "--samples",     "60", "--json"};
  std::vector<std::string> words = {"tradeoff", scene("10-better-speakers"),
                                    "--limit",  "budget=4..4.8",
                                    "--levels", "3"};
  words.insert(words.end(), little.begin(), little.end());
  const Finished front = run(words, folder.path());
  ASSERT_EQ(front.code, 0) << front.err;
  const Json json = front.json();
  ASSERT_EQ(json["points"].size(), 3u);
  // From the loosest to the tightest, each no better than the one before.
  for (std::size_t i = 0; i < 3; ++i) {
    const Json& p = json["points"][i];
    EXPECT_NEAR(p["limit"], 4.8 - 0.4 * static_cast<double>(i), 1e-12);
    EXPECT_LE(p["used"].get<double>(), p["limit"].get<double>() + 1e-9);
    EXPECT_EQ(p["kept"], true);
    if (i > 0) {
      EXPECT_GE(p["objective"], json["points"][i - 1]["objective"]);
    }
  }
  std::ofstream(folder.path() / "front.json") << front.out;
  ASSERT_EQ(run({"optimize", scene("10-better-speakers"), "--evaluations", "20",
                 "--starts", "1", "--samples", "60", "--study", "s.study"},
                folder.path())
                .code,
            0);
  const Finished done =
      run({"report", "s.study", "-o", "s.html", "--brief", "--tradeoff", "front.json"},
          folder.path());
  ASSERT_EQ(done.code, 0) << done.err;
  const std::string page = read_file(folder.path() / "s.html");
  EXPECT_TRUE(has(page, "Accuracy against budget"));
  EXPECT_FALSE(has(page, "If one device fails"));
  const Finished wrong = run({"report", "s.study", "-o", "s.html", "--brief",
                              "--tradeoff", scene("10-better-speakers")},
                             folder.path());
  EXPECT_EQ(wrong.code, 1);
  EXPECT_TRUE(has(wrong.err, "isn't JSON")) << wrong.err;
}

TEST(Report, RefusesAndLeavesWhatWasThere) {
  const Folder folder;
  folder.write("old.html", "old");
  EXPECT_EQ(run({"report", "none.yaml", "-o", "old.html"}, folder.path()).code, 1);
  EXPECT_EQ(read_file(folder.path() / "old.html"), "old");
  const Finished lost =
      run({"report", scene("11-stereo-pair"), "-o", "no/where.html"}, folder.path());
  EXPECT_EQ(lost.code, 1);
  EXPECT_TRUE(has(lost.err, "doesn't exist; create it first")) << lost.err;
  EXPECT_EQ(run({"report", scene("11-stereo-pair")}, folder.path()).code, 2);
}

TEST(Tradeoff, TellsTheCheapestKit) {
  const Folder folder;
  const Finished kit = run(
      {"tradeoff", scene("11-stereo-pair"), "--set",
       "variables=[{path: devices.*.params.focal, lower: 4 mm, upper: 8 mm}]", "--set",
       "constraints=[{name: spec, metric: eigmax, below: 1}]", "--devices", "2..3",
       "--price", "pinhole_camera=800", "--starts", "1", "--json", "--scenes", "kits"},
      folder.path());
  ASSERT_EQ(kit.code, 0) << kit.err;
  const Json json = kit.json();
  ASSERT_EQ(json["points"].size(), 2u);
  EXPECT_EQ(json["points"][1]["price"], 2400);
  EXPECT_LT(json["points"][1]["objective"], json["points"][0]["objective"]);
  EXPECT_EQ(json["cheapest"]["devices"], 2);
  const Finished field = run({"field", "kits/devices-3.yaml", "--json"}, folder.path());
  ASSERT_EQ(field.code, 0) << field.err;
  EXPECT_NEAR(field.json()["mean"], json["points"][1]["objective"], 1e-6);
}

TEST(Tradeoff, RefusesWhatItCantRead) {
  const std::string file = scene("10-better-speakers");
  EXPECT_EQ(run({"tradeoff", file}).code, 2);
  EXPECT_EQ(run({"tradeoff", file, "--limit", "budget=3"}).code, 2);
  EXPECT_EQ(run({"tradeoff", file, "--limit", "cash=3..4"}).code, 1);
  EXPECT_EQ(run({"tradeoff", file, "--devices", "0..4"}).code, 2);
  EXPECT_EQ(run({"tradeoff", file, "--devices", "4..5.5"}).code, 2);
  EXPECT_EQ(run({"tradeoff", file, "--devices", "4..5", "--price", "camera=1"}).code,
            2);
  const Finished tied = run({"tradeoff", file, "--devices", "4..5"});
  EXPECT_EQ(tied.code, 1);
  EXPECT_TRUE(has(tied.err, "move together")) << tied.err;
}

TEST(Consensus, OfAStudyCountsLayoutsAndDevices) {
  const Folder folder;
  ASSERT_EQ(run({"optimize", scene("10-better-speakers"), "--evaluations", "240",
                 "--starts", "6", "--samples", "60", "--study", "s.study"},
                folder.path())
                .code,
            0);
  const Finished done =
      run({"study", "s.study", "consensus", "--best", "3", "--json"}, folder.path());
  ASSERT_EQ(done.code, 0) << done.err;
  const Json json = done.json();
  EXPECT_EQ(json["starts"], 6);
  EXPECT_LE(json["layouts"].size(), 3u);
  EXPECT_GE(json["layouts"].size(), 1u);
  EXPECT_EQ(json["layouts"][0]["distance"], 0);
  EXPECT_EQ(json["devices"].size(), 4u);
}

}  // namespace
}  // namespace delos::test
