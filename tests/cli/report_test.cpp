// delos report and what is in it, as a user runs it.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <fstream>

#include "program.h"
#include "support/occurrences.h"

namespace delos::test {
namespace {

bool has(const std::string& page, const std::string& what) {
  return page.find(what) != std::string::npos;
}

/// Everything is within the file.
void expect_self_contained(const std::string& page) {
  EXPECT_EQ(page.rfind("<!doctype html>", 0), 0u);
  EXPECT_EQ(occurrences(page, " src=\""),
            occurrences(page, " src=\"data:image/png;base64,"));
  EXPECT_EQ(occurrences(page, "<link rel=\"icon\" href=\"data:"), 1u);
  EXPECT_EQ(occurrences(page, "<link"), 1u);
}

/// What is frozen into a page.
Json frozen(const std::string& page) {
  const std::string tag = "<script type=\"application/json\" id=\"frozen\">";
  const std::size_t begin = page.find(tag) + tag.size();
  return Json::parse(page.substr(begin, page.find("</script>", begin) - begin));
}

/// The JSON text at the head of a packed field, which is in base64.
Json summary_of(const Json& packed) {
  const std::string text = packed;
  std::string bytes;
  std::uint32_t bits = 0;
  int filled = 0;
  for (const char c : text) {
    static const std::string kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    bits = bits << 6 | static_cast<std::uint32_t>(kDigits.find(c) & 63);
    if ((filled += 6) < 8) continue;
    filled -= 8;
    bytes += static_cast<char>(bits >> filled);
  }
  std::uint32_t length = 0;
  std::memcpy(&length, bytes.data() + 4, sizeof length);
  return Json::parse(bytes.substr(8, length))["summary"];
}

/// The numbers of a field's document, without what depends on the machine.
Json field_numbers(Json field) {
  for (const char* own : {"threads", "seconds", "warnings"}) field.erase(own);
  return field;
}

TEST(Report, OfASceneTellsTheFieldDevicesAndWhereItIsBlind) {
  const Folder folder;
  const std::string samples =
      "sample={volume: {min: [-3, -4.2, 0], max: [1.6, 3.4, 2], step: 0.4}}";
  const Finished done = run({"report", scene("06-furnished-lab"), "-o", "lab.html",
                             "--set", samples, "--threads", "1"},
                            folder.path());
  ASSERT_EQ(done.code, 0) << done.err;
  EXPECT_EQ(done.out, "");
  const std::string page = read_file(folder.path() / "lab.html");
  expect_self_contained(page);
  EXPECT_EQ(occurrences(page, "alt=\"Map of eigmax"), 3u);
  EXPECT_EQ(occurrences(page, "alt=\"The devices of "), 1u);
  const Json report = frozen(page);
  EXPECT_EQ(report["kind"], "scene");
  bool hidden = false, beyond = false;
  for (const Json& region : report["blind"]["regions"])
    for (const Json& view : region["views"]) {
      hidden = hidden || view["hidden"] > 0;
      beyond = beyond || view["beyond"] > 0;
    }
  EXPECT_TRUE(hidden && beyond);
  EXPECT_EQ(report["versions"][1]["part"], "device pinhole_camera");
  EXPECT_EQ(report["installation"]["devices"].size(),
            report["design"]["description"]["devices"].size());
  EXPECT_EQ(report["sees"].size(), report["worth"]["devices"].size());

  // The figures are those of the field.
  const Finished field =
      run({"field", scene("06-furnished-lab"), "--set", samples, "--json"});
  ASSERT_EQ(field.code, 0) << field.err;
  EXPECT_EQ(field_numbers(summary_of(report["design"]["field"])),
            field_numbers(field.json()));

  // The same scene gives the same page, by as many threads as there are.
  ASSERT_EQ(run({"report", scene("06-furnished-lab"), "-o", "again.html", "--set",
                 samples, "--threads", "3"},
                folder.path())
                .code,
            0);
  EXPECT_TRUE(read_file(folder.path() / "again.html") == page);
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
      "--set",         "name=</script><b>Ours</b> & \"theirs\""};
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
  EXPECT_TRUE(has(page,
                  "<h1>&lt;/script&gt;&lt;b&gt;Ours&lt;/b&gt; &amp; "
                  "&quot;theirs&quot;</h1>"));
  // Three levels, each before, after and as a change.
  EXPECT_EQ(occurrences(page, "alt=\"Map of eigmax"), 9u);
  const Json report = frozen(page), result = resumed.json();
  EXPECT_EQ(report["after"]["description"]["name"],
            "</script><b>Ours</b> & \"theirs\"");
  const std::string headline = report["headline"];
  EXPECT_TRUE(has(headline, "from 61.9 mm to ")) << headline;
  EXPECT_TRUE(has(headline, "All constraints are kept.")) << headline;
  // The numbers are those of the search.
  EXPECT_DOUBLE_EQ(report["objective"]["after"], result["best"]);
  for (const Json& variable : report["variables"]) {
    const std::string path = variable["path"];
    EXPECT_EQ(variable["locked"], path == "devices.s1.at.z") << path;
    if (path != "devices.s1.at.z") {
      EXPECT_DOUBLE_EQ(variable["after"], result["variables"][path]) << path;
    }
  }
  EXPECT_EQ(report["study"]["acts"][0]["verb"], "lock");
  EXPECT_FALSE(report["search"]["incumbents"].empty());
  const std::string commands = report["commands"];
  EXPECT_TRUE(has(commands, "--seed 7")) << commands;
  EXPECT_TRUE(has(commands, "delos study again.study lock devices.s1.at.z\n"))
      << commands;
  EXPECT_EQ(report["answers"]["without"].size(), 4u);
  EXPECT_EQ(report["consensus"]["devices"].size(), 4u);
  const Json change = summary_of(report["difference"]);
  EXPECT_NEAR(change["mean"].get<double>(),
              summary_of(report["after"]["field"])["mean"].get<double>() -
                  summary_of(report["before"]["field"])["mean"].get<double>(),
              1e-12);

  // The same study gives the same page.
  ASSERT_EQ(
      run({"report", "s.study", "-o", "t.html", "--threads", "1"}, folder.path()).code,
      0);
  EXPECT_TRUE(read_file(folder.path() / "t.html") == page);
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
  const Json report = frozen(read_file(folder.path() / "s.html"));
  ASSERT_EQ(report["tradeoffs"].size(), 1u);
  EXPECT_EQ(report["tradeoffs"][0]["across"]["name"], "budget");
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_EQ(report["tradeoffs"][0]["points"][i]["objective"],
              json["points"][i]["objective"]);
  EXPECT_TRUE(report["answers"].is_null());
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
