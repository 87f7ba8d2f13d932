// The room changed by requests: what it is made of, regions, bodies, what sticks.
#include <gtest/gtest.h>

#include "client.h"

namespace delos::test {
namespace {

struct Lab {
  Explorer explorer;
  std::string session = explorer.open("05-optitrack-lab")["session"];

  Json ask(const std::string& verb, const Json& more) const {
    const Answer answer = explorer.ask(verb, session, more);
    EXPECT_EQ(answer.status, 200) << verb << ": " << answer.body;
    return answer.json();
  }
  void refused(const std::string& verb, const Json& more, int status,
               const std::string& words) const {
    const Answer answer = explorer.ask(verb, session, more);
    EXPECT_EQ(answer.status, status) << verb << " " << more;
    EXPECT_NE(answer.error().find(words), std::string::npos) << answer.body;
  }
  [[nodiscard]] Json place(const Json& p, const Json& stick) const {
    const Json all = ask("place", {{"device", "c104325"}, {"p", p}, {"stick", stick}});
    for (const Json& device : all["devices"])
      if (device["name"] == "c104325") return device["pose"];
    return {};
  }
};

Json set(const std::string& path, const std::string& value) {
  return {{"set", {{{"path", path}, {"value", value}}}}};
}

TEST(Rooms, AreChangedAsTheirSheetSays) {
  const Lab lab;
  const Json painted =
      lab.ask("paint", {{"what", "region"}, {"min", {-1, 0, 0}}, {"max", {1, -1, 2}}});
  EXPECT_EQ(painted["surroundings"], 1);
  lab.ask("edit", set("constraints.+", "{name: out, outside: region, devices: '*'}"));
  lab.ask("rename_part", {{"path", "regions.region"}, {"name", "door"}});
  lab.ask("copy_part", {{"path", "regions.door"}});
  lab.ask("shape", {{"path", "regions.door_2"}, {"p", {1, 1, 1}}, {"gesture", "drag"}});
  lab.ask("shape", {{"path", "regions.door_2"}, {"p", {2, 2, 2}}, {"gesture", "drag"}});
  const Json regions = lab.ask("around", Json::object())["regions"];
  ASSERT_EQ(regions.size(), 2u);
  EXPECT_EQ(regions[1]["path"], "regions.door_2");
  EXPECT_EQ(regions[1]["size"], Json({2, 1, 2}));
  EXPECT_EQ(lab.ask("describe", Json::object())["undo"], 5) << "a drag is one step";
  std::size_t sections = 0;
  const Json form = lab.ask("form", Json::object());
  for (const Json& section : form["sections"])
    if (section["path"] == "regions" || section["path"] == "constraints")
      sections += section["members"].size();
  EXPECT_EQ(sections, 3u);

  // What was made is what the file evaluates to.
  const Folder folder;
  const std::string file =
      folder.write("room.yaml", lab.explorer.ask("text", lab.session).body).string();
  const Json checked = run({"check", file, "--json"}).json();
  EXPECT_EQ(checked[0]["in_order"], true) << checked;
}

TEST(Rooms, RefuseWhatIsWrong) {
  const Lab lab;
  const std::string before = lab.explorer.ask("text", lab.session).body;
  lab.refused("edit", Json::object(), 400, "'set'");
  lab.refused("edit", {{"set", Json::array()}}, 400, "nothing to change");
  lab.refused("edit", set("motion.q.7", "1"), 422, "motion.q.7");
  lab.refused("edit", set("occluders.+", "{box: {min: [0,"), 422, "YAML");
  lab.refused("edit", set("occluders.+", "{name: a, box: {min: [0, 0, 0]}}"), 422,
              "occluders.a.box.max");
  lab.refused("copy_part", {{"path", "regions.door"}}, 422, "there is no regions.door");
  lab.refused("rename_part", {{"path", "regions.door"}}, 400, "'name'");
  lab.refused("shape", {{"path", "occluders.7"}, {"p", {0, 0, 0}}}, 422, "occluders.7");
  lab.refused("shape", {{"path", "occluders.7"}, {"p", {0, 0}}}, 400, "'p'");
  lab.refused("paint", {{"what", "region"}, {"min", {0, 0, 0}}}, 400, "'max'");
  lab.refused("paint", {{"what", "hat"}, {"min", {0, 0, 0}}, {"max", {1, 1, 1}}}, 422,
              "'hat'");
  const Json at{{"device", "c104325"}, {"p", {0, 0, 0.5}}};
  for (const Json& stick :
       {Json(1), Json{{"ray", 2}}, Json{{"ray", {{"from", {0, 0, 0}}}}},
        Json{{"ray", {{"from", {0, 0, 0}}, {"along", {0, 0, 0}}}}},
        Json{{"within", -1}}, Json{{"turn", "yes"}, {"within", 1}}}) {
    Json request = at;
    request["stick"] = stick;
    EXPECT_EQ(lab.explorer.ask("place", lab.session, request).status, 400) << stick;
  }
  EXPECT_EQ(lab.explorer.ask("text", lab.session).body, before);
}

/// On the top of a table at 0.7 m, to 1e-9; where nothing is near, as it was put.
TEST(Rooms, HoldWhatSticks) {
  const Lab lab;
  lab.ask("edit",
          set("occluders.+", "{name: t, box: {min: [0, 0, 0], max: [1, 2, 0.7]}}"));
  const auto height = [&](double z) {
    return lab.place({0.5, 0.5, z}, Json::object())["p"][2].get<double>();
  };
  EXPECT_NEAR(height(0.74), 0.7, 1e-9);
  EXPECT_EQ(height(0.8), 0.8);
  const Json met = lab.place(
      {0.5, 0.5, 2},
      {{"ray", {{"from", {0.1, 0.2, 1.7}}, {"along", {1, 1, -5}}}}, {"turn", true}});
  EXPECT_NEAR(met["p"][0], 0.3, 1e-9);
  EXPECT_NEAR(met["p"][1], 0.4, 1e-9);
  EXPECT_NEAR(met["p"][2], 0.7, 1e-9);
  EXPECT_NEAR(met["R"][2][2], 1, 1e-9) << "turned to its normal";
  // Without `stick` a hand puts it where it likes.
  const Json free = lab.ask("place", {{"device", "c104325"}, {"p", {0.5, 0.5, 0.71}}});
  for (const Json& device : free["devices"])
    if (device["name"] == "c104325") EXPECT_EQ(device["pose"]["p"][2], 0.71);
}

}  // namespace
}  // namespace delos::test
