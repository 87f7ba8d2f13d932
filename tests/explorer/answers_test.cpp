// What the server answers is what the command line answers.
#include <gtest/gtest.h>

#include "client.h"

namespace delos::test {
namespace {

/// What differs from run to run.
Json lasting(Json json) {
  json.erase("seconds");
  json.erase("threads");
  json.erase("warnings");
  return json;
}

class FieldAnswers : public testing::TestWithParam<const char*> {};

TEST_P(FieldAnswers, AreThoseOfFieldAndPoint) {
  const Explorer explorer;
  const Json design = explorer.open(GetParam());
  const std::string session = design["session"];
  const Answer field = explorer.ask("field", session, {{"most", 0}});
  ASSERT_EQ(field.status, 200) << field.body;
  const Json summary = field.packed_head("DLF1")["summary"];
  EXPECT_EQ(lasting(summary),
            lasting(run({"field", scene(GetParam()), "--json"}).json()));

  const Json at = summary["max"]["at"];
  const Json point = explorer.ask("point", session, {{"at", at}}).json();
  const std::string place = at[0].dump() + "," + at[1].dump() + "," + at[2].dump();
  EXPECT_EQ(point["point"],
            run({"point", scene(GetParam()), "--at", place, "--json"}).json());
}

INSTANTIATE_TEST_SUITE_P(Of, FieldAnswers,
                         testing::Values("02-eight-cameras", "03-hybrid", "07-torso",
                                         "17-crowded-room", "hiball/six-lepd"),
                         [](const auto& i) {
                           std::string name = i.param;
                           for (char& c : name)
                             if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
                           return name;
                         });

/// A surface through the torso's vertices has the range of delos render's.
TEST(Answers, HaveASurfaceThroughSamples) {
  const Explorer explorer;
  const std::string session = explorer.open("07-torso")["session"];
  const Json how{{"method", "natural-neighbour"}, {"over", "y"}, {"relief", 0.1}};
  const Answer answer = explorer.ask("through", session, how);
  ASSERT_EQ(answer.status, 200) << answer.body;
  const Json head = answer.packed_head("DLF1");
  const Folder folder;
  const Json picture = run({"render", scene("07-torso"), "-o", "torso.png", "--through",
                            "natural-neighbour", "--over", "y", "--json"},
                           folder.path())
                           .json();
  EXPECT_EQ(head["summary"]["through"], picture["through"]);
  EXPECT_EQ(head["parts"][0]["kind"], "surface");
  EXPECT_EQ(head["parts"][1]["count"], 1730);

  const auto refused = [&](const char* key, const Json& value, const char* sentence) {
    Json wrong = how;
    wrong[key] = value;
    const Answer no = explorer.ask("through", session, wrong);
    EXPECT_GE(no.status, 400);
    EXPECT_LT(no.status, 500);
    EXPECT_NE(no.body.find(sentence), std::string::npos) << no.body;
  };
  refused("method", "kriging", "choose natural-neighbour");
  refused("method", 3, "'method' must be a text");
  refused("over", "w", "choose x, y or z");
  refused("of", "all", "'of' must be field, difference or sensitivity");
  refused("of", "difference", "no design is pinned");
  refused("relief", -1, "'relief' must be a number");
  refused("power", 1e9, "'power' must be a number");
}

TEST(Designs, GoBackAndForthToTheSameBytes) {
  const Explorer explorer;
  const std::string session = explorer.open("05-optitrack-lab")["session"];
  const auto text = [&] { return explorer.ask("text", session).body; };
  const auto set = [&](const std::string& path, const std::string& value,
                       const std::string& gesture) {
    const Answer answer = explorer.ask(
        "change", session,
        {{"set", {{{"path", path}, {"value", value}}}}, {"gesture", gesture}});
    EXPECT_EQ(answer.status, 200) << answer.body;
    return answer.json();
  };
  const std::string first = text();
  set("devices.c104321.params.focal", "5 mm", "");
  const std::string second = text();
  EXPECT_NE(first, second);
  set("devices.c104321.at.z", "2.5", "drag 1");
  set("devices.c104321.at.z", "2.25", "drag 1");
  const Json third_state = set("devices.c104321.at.z", "2", "drag 1");
  const std::string third = text();
  EXPECT_EQ(third_state["undo"], 2) << "a drag is one step";

  Json state = explorer.ask("undo", session).json();
  EXPECT_EQ(text(), second);
  EXPECT_EQ(state["redo"], 1);
  explorer.ask("undo", session).json();
  EXPECT_EQ(text(), first);
  state = explorer.ask("undo", session).json();
  EXPECT_EQ(state["undo"], 0) << "there is nothing to undo, and nothing happens";
  EXPECT_EQ(text(), first);
  explorer.ask("redo", session).json();
  EXPECT_EQ(text(), second);
  explorer.ask("redo", session).json();
  EXPECT_EQ(text(), third);
  explorer.ask("undo", session).json();
  state = set("devices.c104321.params.sigma", "0.2 px", "");
  EXPECT_EQ(state["redo"], 0) << "another way was taken";
}

TEST(Designs, AreKeptFromWhatIsWrong) {
  const Explorer explorer;
  const std::string session = explorer.open("05-optitrack-lab")["session"];
  const std::string before = explorer.ask("text", session).body;
  const auto refused = [&](const std::string& path, const std::string& value) {
    const Answer answer = explorer.ask("change", session,
                                       {{"set", {{{"path", path}, {"value", value}}}}});
    EXPECT_EQ(answer.status, 422) << answer.body;
    return answer.error();
  };
  EXPECT_EQ(refused("devices.c104321.params.focal", "-3 mm"),
            "devices.c104321.params.focal: -0.003 m is below the least value 1e-04 m");
  EXPECT_NE(refused("devices.nobody.rate", "1").find("no such member"),
            std::string::npos);
  EXPECT_NE(refused("devices.c104321.params.focal", "3 kg").find("kg"),
            std::string::npos);
  EXPECT_NE(refused("devices.c104321.at", "{"), "");
  EXPECT_NE(refused("metric", "sigma_w").find("sigma_w"), std::string::npos);
  EXPECT_EQ(explorer.ask("text", session).body, before);
  EXPECT_EQ(explorer.ask("describe", session).json()["undo"], 0);

  for (const Json& more :
       {Json{{"set", 1}}, Json{{"set", {1}}}, Json{{"set", Json::array()}},
        Json{{"set", {{{"path", "x"}}}}}, Json::object()})
    EXPECT_EQ(explorer.ask("change", session, more).status, 400) << more;
  for (const Json& at : {Json(), Json("0,0,0"), Json{1, 2}, Json{1, 2, nullptr}})
    EXPECT_EQ(explorer.ask("point", session, {{"at", at}}).status, 400) << at;
  EXPECT_EQ(explorer.ask("field", session, {{"most", -1}}).status, 400);
  EXPECT_EQ(explorer.ask("frob", session).status, 404);
  EXPECT_EQ(explorer.ask("undo", "0123").status, 404);
}

/// Saved in another folder, it evaluates to the same numbers, mesh files and all.
TEST(Designs, AreSavedAsScenes) {
  const Explorer explorer;
  for (const std::string name : {"07-torso", "02-eight-cameras"}) {
    const Json design = explorer.open(name);
    const std::string session = design["session"];
    const std::string device = design["devices"][0]["name"];
    const Answer moved =
        explorer.ask("place", session, {{"device", device}, {"p", {0.5, 0.25, 1.75}}});
    ASSERT_EQ(moved.status, 200) << moved.body;
    const Json summary = explorer.ask("field", session).packed_head("DLF1")["summary"];
    const Folder folder;
    const auto file = folder.write("saved.yaml", explorer.ask("text", session).body);
    const Json saved = run({"field", file.string(), "--json"}).json();
    EXPECT_EQ(lasting(saved), lasting(summary)) << name;
    EXPECT_NE(saved["mean"], run({"field", scene(name), "--json"}).json()["mean"]);
  }
}

TEST(Designs, DontHearEachOther) {
  const Explorer explorer;
  std::vector<std::string> sessions;
  for (int i = 0; i < 20; ++i)
    sessions.push_back(explorer.open("01-acoustic")["session"]);
  for (std::size_t i = 0; i < sessions.size(); ++i)
    explorer.ask("change", sessions[i],
                 {{"set",
                   {{{"path", "devices.s1.at.z"},
                     {"value", std::to_string(2 + static_cast<int>(i))}}}}});
  for (std::size_t i = 0; i < sessions.size(); ++i)
    EXPECT_EQ(explorer.ask("describe", sessions[i]).json()["devices"][0]["at"][2],
              2 + static_cast<int>(i));
}

/// Added to, mirrored and taken from, it is saved as a scene of the same numbers.
TEST(Designs, HaveDevicesMoreAndFewer) {
  const Explorer explorer;
  const std::string session = explorer.open("02-eight-cameras")["session"];
  const auto ask = [&](const std::string& verb, const Json& more) {
    const Answer answer = explorer.ask(verb, session, more);
    EXPECT_EQ(answer.status, 200) << answer.body;
    return answer.json();
  };
  const std::string before = explorer.ask("text", session).body;
  const Json palette = ask("palette", Json::object());
  EXPECT_EQ(palette["types"].size(), run({"devices", "--json"}).json().size());
  ask("add", {{"type", "pinhole_camera"}, {"at", {0.2, 0.2, 1.5}}});
  ask("mirror", {{"device", "lower1"}, {"axis", "y"}});
  ask("copy", {{"device", "upper1"}, {"by", {0.1, 0, 0}}});
  const Json state = ask("remove", {{"device", "upper2"}});
  EXPECT_EQ(state["devices"].size(), 10u);
  const Json summary = explorer.ask("field", session).packed_head("DLF1")["summary"];
  const Folder folder;
  const auto file = folder.write("saved.yaml", explorer.ask("text", session).body);
  EXPECT_EQ(lasting(run({"field", file.string(), "--json"}).json()), lasting(summary));
  for (int i = 0; i < 4; ++i) explorer.ask("undo", session);
  EXPECT_EQ(explorer.ask("text", session).body, before);

  EXPECT_EQ(
      explorer.ask("mirror", session, {{"device", "lower1"}, {"axis", "w"}}).status,
      400);
  EXPECT_EQ(explorer.ask("add", session, {{"type", "../camera"}}).status, 422);
  EXPECT_EQ(explorer.ask("remove", session, {{"device", "nobody"}}).status, 422);
  EXPECT_EQ(explorer.ask("text", session).body, before);
}

/// The difference is that of `delos compare`.
TEST(Designs, AreComparedWithWhatIsPinned) {
  const Explorer explorer;
  const std::string session = explorer.open("02-eight-cameras")["session"];
  EXPECT_EQ(explorer.ask("difference", session).status, 400) << "nothing is pinned";
  EXPECT_FALSE(explorer.ask("pin", session).json()["pinned"].is_null());
  explorer.ask("change", session,
               {{"set", {{{"path", "devices.*.params.focal"}, {"value", "5 mm"}}}}});
  const Json summary =
      explorer.ask("difference", session).packed_head("DLF1")["summary"];
  const Folder folder;
  const auto now = folder.write("now.yaml", explorer.ask("text", session).body);
  const Json difference =
      run({"compare", scene("02-eight-cameras"), now.string(), "--json"})
          .json()["difference"];
  EXPECT_EQ(summary["mean"], difference["mean"]);
  EXPECT_EQ(summary["min"]["value"], difference["min"]);
  EXPECT_EQ(summary["max"]["value"], difference["max"]);
  EXPECT_EQ(summary["better"], difference["improved_fraction"]);
  EXPECT_EQ(summary["finite"], difference["common"]);
  const Json pinned =
      explorer.ask("field", session, {{"of", "pinned"}}).packed_head("DLF1");
  EXPECT_EQ(lasting(pinned["summary"]),
            lasting(run({"field", scene("02-eight-cameras"), "--json"}).json()));
  EXPECT_TRUE(explorer.ask("unpin", session).json()["pinned"].is_null());
  EXPECT_EQ(explorer.ask("difference", session).status, 400);
}

TEST(Designs, SayWhichCutsTheyTake) {
  const Explorer explorer;
  const std::string session = explorer.open("01-acoustic")["session"];
  const auto status = [&](const Json& sections) {
    return explorer.ask("sections", session, {{"sections", sections}}).status;
  };
  const Json good{{"origin", {0, 0, 0.5}}, {"u", {0.4, 0, 0.1}}, {"v", {0, 0.4, 0}}};
  EXPECT_EQ(status({good, good}), 200);
  EXPECT_EQ(status(Json::array()), 400);
  EXPECT_EQ(status(std::vector<Json>(17, good)), 400);
  EXPECT_EQ(status({1}), 400);
  EXPECT_EQ(status({{{"origin", {0, 0, 0}}, {"u", {1, 0, 0}}, {"v", {2, 0, 0}}}}), 400);
  const Json sliver{{"origin", {0, 0, 0}}, {"u", {1e9, 0, 0}}, {"v", {0, 1e-9, 0}}};
  EXPECT_LE(explorer.ask("sections", session, {{"sections", {sliver}}})
                .packed_head("DLF1")["values"]["count"],
            11'000);
  const Answer large = explorer.ask("sections", session,
                                    {{"sections", {good}}, {"most", 4'000'000'000}});
  EXPECT_EQ(large.status, 200);
  EXPECT_LE(large.packed_head("DLF1")["values"]["count"], 102'000) << "bounded";
}

/// Its own scene first, by its name alone: the page never learns of folders.
TEST(Scenes, BeginWithTheOneGiven) {
  const Explorer without;
  EXPECT_EQ(without.get("/api/scenes").json()["first"], Json());
  const Folder folder;
  const auto file = folder.write("mine.yaml", read_file(scene("01-acoustic")));
  const Explorer with({file.string()});
  const Answer list = with.get("/api/scenes");
  EXPECT_EQ(list.json()["first"], "mine.yaml");
  EXPECT_EQ(list.body.find(folder.path().string()), std::string::npos);
  EXPECT_EQ(with.open("mine.yaml")["name"], "Acoustic range tracker");
}

}  // namespace
}  // namespace delos::test
