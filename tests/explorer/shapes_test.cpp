// What the server makes of the fields that a page draws.
#include <gtest/gtest.h>

#include "client.h"

namespace delos::test {
namespace {

Answer shapes(const Explorer& explorer, const std::string& session, const Json& list) {
  return explorer.ask("shapes", session, {{"shapes", list}});
}

// The surface is that of delos render: its area to the last bit.
TEST(Shapes, AreThoseOfTheCommandLine) {
  const Explorer explorer;
  const std::string session = explorer.open("01-acoustic")["session"];
  EXPECT_EQ(explorer.ask("field", session).status, 200);
  const Json head =
      shapes(explorer, session, {{{"level", 0.025}}, {{"between", {nullptr, 0.03}}}})
          .packed_head("DLS1");
  const Folder folder;
  const Json drawn =
      run({"render", scene("01-acoustic"), "--surface", "25 mm", "--between", ",30 mm",
           "-o", (folder.path() / "x.png").string(), "--json"})
          .json();
  ASSERT_EQ(head["meshes"].size(), 2u);
  EXPECT_EQ(head["meshes"][0]["area"], drawn["surfaces"][0]["area"]);
  EXPECT_EQ(head["meshes"][1]["area"], drawn["bodies"][0]["area"]);
  EXPECT_TRUE(drawn["bodies"][0]["low"].is_null());
}

TEST(Shapes, AreOfTheFieldThatWasAskedForLast) {
  const Explorer explorer;
  const std::string session = explorer.open("01-acoustic")["session"];
  EXPECT_EQ(shapes(explorer, session, {{{"level", 0.025}}}).status, 400)
      << "there is none yet";
  explorer.ask("field", session);
  explorer.ask("pin", session);
  const Json first =
      shapes(explorer, session, {{{"level", 0.025}}}).packed_head("DLS1");
  explorer.ask("change", session,
               {{"set", {{{"path", "devices.s1.at.z"}, {"value", "0.9"}}}}});
  EXPECT_EQ(shapes(explorer, session, {{{"level", 0.025}}}).packed_head("DLS1"), first)
      << "the change hasn't been evaluated";
  explorer.ask("field", session, {{"most", 1000}});
  explorer.ask("field", session, {{"of", "pinned"}});
  const Json now = shapes(explorer, session,
                          {{{"level", 0.025}}, {{"of", "pinned"}, {"level", 0.025}}})
                       .packed_head("DLS1");
  EXPECT_EQ(now["level"], "coarse");
  EXPECT_EQ(now["revision"], first["revision"].get<int>() + 1) << "changed once";
  EXPECT_NE(now["meshes"][0]["area"], first["meshes"][0]["area"]);
  EXPECT_EQ(now["meshes"][1]["area"], first["meshes"][0]["area"]);
}

TEST(Shapes, OfReliefsAndLeaves) {
  const Explorer explorer;
  const std::string session = explorer.open("06-furnished-lab")["session"];
  explorer.ask("change", session,
               {{"set", {{{"path", "sample.volume.adaptive.depth"}, {"value", "2"}}}}});
  explorer.ask("field", session);
  const Answer answer = explorer.ask(
      "shapes", session,
      {{"shapes",
        {{{"relief",
           {{"axis", 2}, {"at", 1}, {"low", 0}, {"high", 1e-3}, {"size", 1}}}}}},
       {"leaves", {{"axis", 2}, {"at", 1}}}});
  const Json head = answer.packed_head("DLS1");
  ASSERT_EQ(head["meshes"].size(), 1u);
  EXPECT_GT(head["meshes"][0]["corners"], 0);
  const int near = head["leaves"]["count"];
  const int all = explorer
                      .ask("shapes", session,
                           {{"shapes", Json::array()}, {"leaves", Json::object()}})
                      .packed_head("DLS1")["leaves"]["count"];
  EXPECT_TRUE(near > 0 && near < all) << near << " of " << all;
  const std::string summary = run({"field", scene("06-furnished-lab"), "--set",
                                   "sample.volume.adaptive.depth=2"})
                                  .out;
  EXPECT_NE(summary.find(std::to_string(all) + " leaf cells"), std::string::npos)
      << summary;
}

TEST(Shapes, AreRefusedWhereTheyAreNone) {
  const Explorer explorer;
  const std::string session = explorer.open("01-acoustic")["session"];
  explorer.ask("field", session);
  const Json relief{{"axis", 2}, {"at", 0}, {"low", 0}, {"high", 1}, {"log10", true}};
  for (const Json& wrong :
       {Json(1), Json{1}, Json{{{"level", "x"}}},
        Json{{{"of", "nothing"}, {"level", 1}}}, Json{{{"between", {1}}}},
        Json{{{"between", {"a", 1}}}}, Json{Json::object()},
        Json{{{"relief", {{"axis", 0.5}}}}}, Json{{{"relief", relief}}},
        Json(std::vector<Json>(17, {{"level", 0.02}}))})
    EXPECT_EQ(shapes(explorer, session, wrong).status, 400) << wrong;
  EXPECT_EQ(explorer.ask("shapes", session, {{"shapes", Json::array()}, {"leaves", 1}})
                .status,
            400);
  EXPECT_EQ(shapes(explorer, session, {{{"level", 0.025}}}).status, 200)
      << "the server lives on";
}

}  // namespace
}  // namespace delos::test
