// Twenty tabs at once, and ten thousand edits: nobody hears another, and memory stays.
#include <gtest/gtest.h>

#include <thread>

#include "client.h"

namespace delos::test {
namespace {

Json set(const std::string& path, const std::string& value) {
  return {{"set", {{{"path", path}, {"value", value}}}}};
}

/// What a tab does while others do likewise. @returns what it heard that isn't its own
std::string work_of(const Explorer& explorer, int tab) {
  const std::string session = explorer.open("01-acoustic")["session"];
  for (int step = 0; step < 10; ++step) {
    const double z = 2 + tab + 0.01 * step;
    const Answer changed =
        explorer.ask("change", session, set("devices.s1.at.z", std::to_string(z)));
    if (changed.status != 200) return changed.body;
    if (std::abs(changed.json()["devices"][0]["at"][2].get<double>() - z) > 1e-9)
      return "another's place";
    if (step == 3 && explorer.ask("pin", session).status != 200) return "not pinned";
    if (explorer.ask("field", session, {{"most", 2000}}).status != 200)
      return "no field";
    if (step > 3 && explorer.ask("difference", session, {{"most", 2000}}).status != 200)
      return "no difference";
    if (explorer.ask("add", session, {{"type", "range"}}).status != 200)
      return "not added";
    if (explorer.ask("undo", session).status != 200) return "not undone";
  }
  return "";
}

Json search_of(const Explorer& explorer, const std::string& session) {
  return explorer.ask("searches", session).json()["searches"].back();
}

/// Six search, of which four do so at once; the others wait for their turn.
TEST(Load, TwentyTabsAndSearchesAtOnce) {
  Explorer explorer;
  std::vector<std::string> searching;
  for (int i = 0; i < 6; ++i) {
    searching.push_back(explorer.open("10-better-speakers")["session"]);
    const Answer begun =
        explorer.ask("search_start", searching.back(),
                     {{"starts", 500},
                      {"seed", 1 + i},
                      {"locked", {i % 2 ? "devices.s1" : "devices.s2"}}});
    ASSERT_EQ(begun.status, 200) << begun.body;
  }
  std::vector<std::string> heard(20, "nothing");
  std::vector<std::thread> tabs;
  for (int tab = 0; tab < 20; ++tab)
    tabs.emplace_back([&, tab] { heard[tab] = work_of(explorer, tab); });
  for (std::thread& tab : tabs) tab.join();
  for (const std::string& one : heard) EXPECT_EQ(one, "");
  int waiting = 0;
  for (int i = 0; i < 6; ++i) {
    const Json search = search_of(explorer, searching[i]);
    if (search["phase"] == "waiting") {
      ++waiting;
      continue;
    }
    EXPECT_EQ(search["phase"], "running") << search["message"];
    EXPECT_EQ(search["rounds"].back()["variables"][0],
              std::string(i % 2 ? "devices.s2.at.x" : "devices.s1.at.x"))
        << "its own";
    EXPECT_GT(search["evaluations"], 0);
  }
  EXPECT_EQ(waiting, 2);
  for (const std::string& session : searching)
    EXPECT_EQ(explorer.ask("search_follow", session).status, 200);
  const Finished done = explorer.end();
  EXPECT_EQ(done.code, 0) << done.err;
}

/// After the first thousand, when all that can be undone is there, no more is kept.
TEST(Load, TenThousandEditsKeepTheirMemory) {
  const Folder folder;
  const auto file =
      folder.write("small.yaml", "delos: 1\nextends: " + scene("01-acoustic") +
                                     "\nsample: {points: [[0.2, 0.2, 0.4]]}\n");
  Explorer explorer({file.string()});
  const std::string session = explorer.open("small.yaml")["session"];
  std::size_t after_first = 0;
  for (int i = 0; i < 10'000; ++i) {
    const Answer answer =
        i % 10 == 8 ? explorer.ask("add", session, {{"type", "range"}})
        : i % 10 == 9
            ? explorer.ask("remove", session, {{"device", "range_2"}})
            : explorer.ask("change", session,
                           set("devices.s" + std::to_string(1 + i % 4) + ".at.z",
                               std::to_string(1 + 1e-4 * i)));
    ASSERT_EQ(answer.status, 200) << i << " " << answer.body;
    if (i == 1000) after_first = explorer.resident();
  }
  EXPECT_LT(explorer.resident(), after_first + (24u << 20));
  EXPECT_EQ(explorer.ask("describe", session).json()["undo"], 500);
  RecordProperty("resident", static_cast<int>(explorer.resident() >> 20));
  EXPECT_EQ(explorer.end().code, 0);
}

}  // namespace
}  // namespace delos::test
