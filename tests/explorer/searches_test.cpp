// Searches of a tab: steered while they run, told as they go on, and the same as those
// of the command line.
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "client.h"

namespace delos::test {
namespace {

constexpr auto kGlance = std::chrono::milliseconds(20);

/// Scene 10 in a folder of its own, which ends after some two hundred evaluations.
struct Room {
  Folder folder;
  std::filesystem::path file =
      folder.write("room.yaml", read_file(scene("10-better-speakers")));
  Explorer explorer{{file.string()}};
  std::string session = explorer.open("room.yaml")["session"];

  Json ask(const std::string& verb, const Json& more = Json::object()) const {
    const Answer answer = explorer.ask(verb, session, more);
    EXPECT_EQ(answer.status, 200) << verb << ": " << answer.body;
    return answer.json();
  }
  [[nodiscard]] std::string text() const { return explorer.ask("text", session).body; }
  [[nodiscard]] Json now() const { return ask("searches")["searches"].back(); }
  /// Look until it is so, two minutes at most.
  template <class So>
  Json until(So&& so) const {
    const auto last = std::chrono::steady_clock::now() + std::chrono::minutes(2);
    for (;;) {
      Json search = now();
      if (so(search)) return search;
      if (std::chrono::steady_clock::now() > last) {
        ADD_FAILURE() << "waited in vain: " << search.dump().substr(0, 500);
        return search;
      }
      std::this_thread::sleep_for(kGlance);
    }
  }
  Json until_phase(const std::string& phase) const {
    return until([&](const Json& search) { return search["phase"] == phase; });
  }
  Json until_found(std::size_t incumbents) const {
    return until(
        [&](const Json& search) { return search["incumbents"].size() >= incumbents; });
  }
  /// The values of the variables, from the design's text.
  [[nodiscard]] Json variables() const {
    Json values;
    for (const Json& v : ask("task")["variables"])
      values[v["path"].get<std::string>()] = v["value"];
    return values;
  }
};

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
  room.until_found(2);
  room.ask("search_follow");
  EXPECT_EQ(room.variables()["devices.s2.at.x"], 0.4) << "locked from the first";
  const double x = room.variables()["devices.s1.at.x"];
  room.ask("search_lock", {{"path", "devices.s1.at.x"}, {"locked", true}});
  const Json search =
      room.until([](const Json& s) { return s["rounds"].back()["round"] == 2; });
  EXPECT_EQ(search["rounds"][1]["variables"],
            (Json{"devices.s1.at.y", "devices.s1.at.z"}));
  room.until([](const Json& s) { return s["incumbents"].back()["round"] == 2; });
  room.ask("search_pause");
  room.until_phase("paused");
  room.ask("search_follow");
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
  ASSERT_EQ(explorer.ask("select_start", session, {{"seconds", 30}}).status, 200);
  Json search;
  do {
    std::this_thread::sleep_for(kGlance);
    search = explorer.ask("searches", session).json()["searches"][0];
  } while (search["phase"] == "running" || search["phase"] == "waiting");
  ASSERT_EQ(search["phase"], "ended") << search;
  const Json alone = run({"select", scene("12-ceiling-anchors"), "--json"}).json();
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

/// The head of a WebSocket's request (RFC 6455, section 4.1).
std::string upgrade(const Explorer& explorer, const std::string& session,
                    const std::string& origin) {
  return "GET /api/watch?session=" + session + " HTTP/1.1\r\nHost: " + explorer.host() +
         "\r\nOrigin: " + origin +
         "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: "
         "13\r\n"
         "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n";
}

TEST(Searches, AreToldAsTheyGoOn) {
  const Room room;
  const Connection watching(room.explorer.port());
  watching.send(upgrade(room.explorer, room.session, "http://" + room.explorer.host()));
  room.ask("search_start", {{"starts", 2}});
  room.until_phase("ended");
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  // A close, masked by zeros: the end.
  watching.send(std::string("\x88\x80\0\0\0\0", 6));
  const Answer told = watching.answer();
  EXPECT_EQ(told.status, 101) << told.head;
  // The key's answer is RFC 6455's own example, section 1.3.
  EXPECT_NE(told.head.find("s3pPLMBiTxaQ9kYGzzhZRbK+xOo="), std::string::npos);
  EXPECT_EQ(told.body.substr(0, 1), "\x81") << "a text";
  EXPECT_NE(told.body.find(R"("phase":"running")"), std::string::npos);
  EXPECT_NE(told.body.find(R"("phase":"ended")"), std::string::npos);
  // Each incumbent once.
  const std::string second = R"("number":1})";
  const std::size_t first = told.body.find(second);
  EXPECT_NE(first, std::string::npos);
  EXPECT_EQ(told.body.find(second, first + 1), std::string::npos);
}

TEST(Searches, AreToldToTheirOwnPageOnly) {
  Room room;
  const auto asked = [&](const std::string& session, const std::string& origin) {
    const Connection connection(room.explorer.port());
    connection.send(upgrade(room.explorer, session, origin));
    return connection.answer().status;
  };
  EXPECT_EQ(asked(room.session, "http://evil.example"), 403);
  const std::string own = "http://" + room.explorer.host();
  // What isn't a WebSocket for it is asked again on the same connection, until it
  // tires.
  {
    const Connection wrong(room.explorer.port());
    wrong.send(upgrade(room.explorer, "0123", own) + "GARBAGE\r\n\r\n");
    EXPECT_EQ(wrong.answer().status, 404);
  }
  // Frames that no client may send: without a mask, of a reserved kind, of 2^62 bytes.
  for (const std::string& frame :
       {std::string("\x81\x01x", 3), std::string("\x83\x80\0\0\0\0", 6),
        std::string("\x81\xff\x40\0\0\0\0\0\0\0\0\0\0\0", 14)}) {
    const Connection connection(room.explorer.port());
    connection.send(upgrade(room.explorer, room.session, own));
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    connection.send(frame);
    EXPECT_EQ(connection.answer().status, 101);
  }
  EXPECT_EQ(room.explorer.get("/").status, 200);
  EXPECT_EQ(room.explorer.end().code, 0);
}

TEST(Searches, StopWhenNobodyWatchesAnyMore) {
  Room room;
  const std::string own = "http://" + room.explorer.host();
  room.ask("search_start", {{"starts", 200}});
  {
    const Connection watching(room.explorer.port());
    watching.send(upgrade(room.explorer, room.session, own));
    room.until_found(2);
  }
  const Json left = room.until_phase("paused");
  const Connection again(room.explorer.port());
  again.send(upgrade(room.explorer, room.session, own));
  room.until([&](const Json& search) {
    return search["phase"] == "running" &&
           search["evaluations"].get<int>() > left["evaluations"].get<int>();
  });
  EXPECT_EQ(room.explorer.end().code, 0) << "the end waits for no search";
}

}  // namespace
}  // namespace delos::test
