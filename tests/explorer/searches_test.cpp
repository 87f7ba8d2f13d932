// Searches of a tab: steered while they run, told as they go on, and the same as those
// of the command line.
#include <gtest/gtest.h>

#include "room.h"

namespace delos::test {
namespace {

TEST(Searches, FindWhatTheCommandLineFinds) {
  const Room room;
  const std::string before = room.text();
  room.ask("search_start", {{"starts", 2}, {"seed", 5}});
  const Json ended = room.until_phase("ended");
  const Json alone =
      run({"optimize", room.file.string(), "--starts", "2", "--seed", "5", "--json"})
          .json();
  EXPECT_EQ(ended["result"]["best"], alone["best"]);
  EXPECT_EQ(ended["result"]["initial"], alone["initial"]);
  EXPECT_EQ(room.text(), before) << "nobody has followed it yet";
  EXPECT_EQ(room.ask("search_follow")["undo"], 1);
  EXPECT_EQ(room.ask("search_accept")["undo"], 1) << "one step";
  EXPECT_EQ(room.variables(), alone["variables"]);

  // Incumbents get better, and each can be had again.
  const Json& incumbents = ended["incumbents"];
  ASSERT_GE(incumbents.size(), 2u);
  for (std::size_t i = 1; i < incumbents.size(); ++i)
    EXPECT_LT(incumbents[i]["objective"], incumbents[i - 1]["objective"]);
  room.ask("search_reinstate", {{"search", 1}, {"incumbent", 0}});
  EXPECT_EQ(room.variables()["devices.s1.at.z"], 1.0485) << "the scene's own";
  room.ask("undo");
  EXPECT_EQ(room.variables(), alone["variables"]);
  room.ask("undo");
  EXPECT_EQ(room.text(), before);
}

TEST(Searches, GoOnAsIfTheyHadntStopped) {
  const Room room;
  room.ask("search_start", {{"starts", 8}, {"study", "room.study"}});
  room.until_found(2);
  room.ask("search_pause");
  const Json paused = room.until_phase("paused");
  EXPECT_EQ(run({"study", (room.folder / "room.study").string(), "show", "--json"})
                .json()["rounds"][0]["ended"],
            false);
  room.ask("search_resume");
  const Json ended = room.until_phase("ended");
  EXPECT_GT(ended["evaluations"], paused["evaluations"]);
  const Json alone =
      run({"optimize", room.file.string(), "--starts", "8", "--json"}).json();
  EXPECT_EQ(ended["result"]["best"], alone["best"]);
  EXPECT_EQ(ended["evaluations"].get<int>(),
            alone["evaluations"].get<int>() + alone["gradient_evaluations"].get<int>())
      << "what is recalled counts once";
}

TEST(Searches, GoOnFromWhatAHandHasMade) {
  const Room room;
  room.ask("search_start", {{"starts", 40}, {"study", "room.study"}});
  room.until_found(3);
  room.ask("search_follow");
  const Json moved = room.variables();
  room.ask("change",
           {{"set", {{{"path", "devices.s2.params.r"}, {"value", "0.001"}}}}});
  EXPECT_EQ(room.variables(), moved);
  const Json next = room.until(
      [](const Json& search) { return search["rounds"].back()["round"] == 2; });
  const Json study =
      run({"study", (room.folder / "room.study").string(), "show", "--json"}).json();
  EXPECT_EQ(study["acts"][0]["verb"], "set");
  EXPECT_EQ(study["rounds"][0]["ended"], true);
  // The second round's first design is the one that the hand has left.
  const Json search =
      room.until([](const Json& s) { return s["incumbents"].back()["round"] == 2; });
  for (const Json& one : search["incumbents"]) {
    if (one["round"] != 2) continue;
    for (std::size_t v = 0; v < moved.size(); ++v)
      EXPECT_NEAR(one["values"][v].get<double>(),
                  moved[search["rounds"].back()["variables"][v].get<std::string>()]
                      .get<double>(),
                  1e-12);
    break;
  }
  room.ask("search_reject");
  room.until_phase("paused");
  EXPECT_EQ(room.variables()["devices.s1.at.z"], 1.0485) << "as when it began";
  EXPECT_EQ(room.ask("describe")["devices"][1]["params"]["r"], 0.001)
      << "but for the hand's";
}

TEST(Searches, KeepWhatIsLocked) {
  const Room room;
  room.ask("search_start", {{"starts", 40}, {"locked", {"devices.s2"}}});
  const auto searches = [](const Json& variables) {
    return [variables](const Json& s) {
      return !s["rounds"].empty() && s["rounds"].back()["variables"] == variables &&
             !s["incumbents"].empty() &&
             s["incumbents"].back()["round"] == s["rounds"].back()["round"];
    };
  };
  room.until(searches({"devices.s1.at.x", "devices.s1.at.y", "devices.s1.at.z"}));
  room.until_found(2);
  room.ask("search_follow");
  EXPECT_EQ(room.variables()["devices.s2.at.x"], 0.4) << "locked from the first";
  room.ask("search_lock", {{"path", "devices.s1.at.x"}, {"locked", true}});
  room.ask("search_follow");  // nothing new: it goes on from what it found before
  room.until(searches({"devices.s1.at.y", "devices.s1.at.z"}));
  room.ask("search_follow");
  const double x = room.variables()["devices.s1.at.x"];
  room.until([](const Json& s) {
    return s["evaluations"] > s["incumbents"].back()["evaluation"].get<int>() + 20;
  });
  room.ask("search_pause");
  room.until_phase("paused");
  room.ask("search_follow");
  EXPECT_EQ(room.variables()["devices.s2.at.x"], 0.4);
  EXPECT_NEAR(room.variables()["devices.s1.at.x"].get<double>(), x, 1e-12);
  EXPECT_EQ(room.explorer
                .ask("search_lock", room.session,
                     {{"path", "devices.nobody"}, {"locked", true}})
                .status,
            422);
}

TEST(Searches, WriteBesideTheSceneOnly) {
  const Room room;
  for (const std::string name : {"../room.study", "sub/room.study", "/tmp/room.study",
                                 ".study", "room.yaml", "room", "room.study\n"})
    EXPECT_EQ(room.explorer.ask("search_start", room.session, {{"study", name}}).status,
              400)
        << name;
  // A file of that name that is none isn't touched.
  room.folder.write("other.study", "mine");
  EXPECT_EQ(room.explorer.ask("search_start", room.session, {{"study", "other.study"}})
                .status,
            400);
  EXPECT_EQ(read_file(room.folder / "other.study"), "mine");
  for (const Json& more : {Json{{"evaluations", -1}}, Json{{"seconds", "x"}},
                           Json{{"starts", 1e9}}, Json{{"locked", {1}}}})
    EXPECT_EQ(room.explorer.ask("search_start", room.session, more).status, 400)
        << more;
  for (const char* verb : {"search_pause", "search_resume", "search_follow",
                           "search_accept", "search_reject", "search_reinstate"})
    EXPECT_EQ(room.explorer.ask(verb, room.session).status, 400) << verb;
  EXPECT_TRUE(room.ask("searches")["searches"].empty());
}

TEST(Searches, TellWhatMayChange) {
  const Room room;
  const std::string before = room.text();
  room.ask("vary",
           {{"path", "devices.s3.params.r"}, {"lower", "0.001"}, {"upper", "0.01"}});
  room.ask("vary", {{"path", "devices.s1.at.z"}, {"upper", "1.1"}});
  Json variables = room.ask("task")["variables"];
  ASSERT_EQ(variables.size(), 7u);
  EXPECT_EQ(variables[6]["path"], "devices.s3.params.r");
  EXPECT_EQ(variables[6]["lower"], 0.001);
  EXPECT_EQ(variables[2]["upper"], 1.1);
  EXPECT_EQ(variables[2]["lower"], 0.9);
  EXPECT_EQ(variables[2]["followers"], 1);
  room.ask("fix", {{"path", "devices.s1.at"}});
  EXPECT_EQ(room.ask("task")["variables"].size(), 4u);
  const auto refused = [&](const Json& more) {
    return room.explorer.ask("vary", room.session, more).status;
  };
  EXPECT_EQ(refused({{"path", "devices.s9.at.x"}}), 422);
  EXPECT_EQ(refused({{"path", "devices.s2.at.x"}, {"lower", "2 m"}}), 422);
  EXPECT_EQ(refused({{"path", "devices.s2.at.x"}, {"lower", "2 kg"}}), 422);
  for (int i = 0; i < 3; ++i) room.ask("undo");
  EXPECT_EQ(room.text(), before);
}

TEST(Searches, ChooseAmongCandidates) {
  const Explorer explorer;
  const std::string session = explorer.open("12-ceiling-anchors")["session"];
  const std::string before = explorer.ask("text", session).body;
  ASSERT_EQ(explorer.ask("select_start", session, {{"gap", 0.05}}).status, 200);
  Json search;
  do {
    std::this_thread::sleep_for(kGlance);
    search = explorer.ask("searches", session).json()["searches"][0];
  } while (search["phase"] == "running" || search["phase"] == "waiting");
  ASSERT_EQ(search["phase"], "ended") << search;
  const Json alone =
      run({"select", scene("12-ceiling-anchors"), "--gap", "0.05", "--json"}).json();
  EXPECT_EQ(search["result"]["chosen"], alone["chosen"]);
  EXPECT_EQ(search["result"]["value"], alone["value"]);
  EXPECT_LE(search["curve"].back()["bound"], search["curve"].back()["value"]);
  const Json chosen = explorer.ask("search_accept", session).json();
  ASSERT_EQ(chosen["devices"].size(), 30u);
  for (std::size_t i = 0; i < 30; ++i)
    EXPECT_EQ(chosen["devices"][i]["name"], alone["chosen"][i]);
  EXPECT_EQ(chosen["undo"], 1);
  explorer.ask("undo", session);
  EXPECT_EQ(explorer.ask("text", session).body, before);
}

TEST(Searches, TradeOff) {
  const Room room;
  room.ask("front_start", {{"constraint", "budget"},
                           {"from", 3.7},
                           {"to", 4.4},
                           {"levels", 2},
                           {"starts", 1}});
  const Json ended = room.until_phase("ended");
  const Json alone = run({"tradeoff", room.file.string(), "--limit", "budget=3.7..4.4",
                          "--levels", "2", "--starts", "1", "--json"})
                         .json();
  ASSERT_EQ(ended["front"]["points"], alone["points"]);
  room.ask("search_reinstate", {{"search", 1}, {"point", 1}});
  EXPECT_EQ(room.variables(), alone["points"][1]["variables"]);
}

}  // namespace
}  // namespace delos::test
