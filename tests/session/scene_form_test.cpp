// The form of a scene: it shows what there is, and what it offers can be done.
#include "session/scene_form.h"

#include <functional>

#include "delos/scene/definition.h"
#include "delos/scene/io.h"
#include "designs.h"
#include "session/form_edits.h"
#include "session/refusal.h"
#include "session/value_tree.h"

namespace delos::session {
namespace {

using Visit = std::function<void(const Json& field)>;

void each_field(const Json& field, const Visit& visit) {
  visit(field);
  if (!field.contains("members")) return;
  for (const Json& member : field["members"]) each_field(member, visit);
}

void each_field(const Design& design, const Visit& visit) {
  const Json all = scene_form(design.loaded(), plugins());
  for (const Json& section : all["sections"]) each_field(section, visit);
}

Json field_at(const Design& design, const std::string& path) {
  Json found;
  each_field(design, [&](const Json& field) {
    if (field["path"] == path) found = field;
  });
  EXPECT_FALSE(found.is_null()) << path;
  return found;
}

void edit(Design& design, const std::string& path, const std::string& value) {
  change(design, edits(design.loaded().scene, {{path, value}}));
}

bool can(Design& design, const Json& act) {
  Diagnostics findings;
  try {
    const auto changes = edits(design.loaded().scene, {{act["path"], act["value"]}});
    return design.change(changes, "", plugins(), findings);
  } catch (const Refusal&) {
    return false;
  }
}

/// Every single value of a scene's text is a field, with the value that stands there.
class Sheets : public testing::TestWithParam<const char*> {};

TEST_P(Sheets, ShowWhatIsWritten) {
  const Design design = design_of(GetParam());
  const Json tree = value_tree(design.loaded().scene);
  std::size_t numbers = 0;
  each_field(design, [&](const Json& field) {
    const std::string kind = field["kind"];
    if (kind != "number" && kind != "integer") return;
    ++numbers;
    EXPECT_TRUE(field["value"].is_number()) << field;
    EXPECT_TRUE(field["unit"].is_string()) << field;
    if (field["lower"].is_number()) EXPECT_GE(field["value"], field["lower"]) << field;
    if (field["upper"].is_number()) EXPECT_LE(field["value"], field["upper"]) << field;
  });
  EXPECT_GT(numbers, 3u);
  // And none is left out, but for what stands elsewhere and long lists.
  std::size_t written = 0;
  const std::function<void(const Json&)> count = [&](const Json& value) {
    if (value.is_structured() && value.size() > 60) return;
    // Names with dots are paths: such a mapping is one text.
    if (value.is_object())
      for (const auto& [name, inner] : value.items())
        if (name.find('.') != std::string::npos) return;
    if (value.is_string()) {
      written += value.get<std::string>().find_first_not_of("0123456789.-e") ==
                 std::string::npos;
    }
    if (value.is_structured())
      for (const Json& inner : value) count(inner);
  };
  for (const auto& [section, value] : tree.items())
    if (section != "delos" && section != "devices" && section != "variables")
      count(value);
  EXPECT_GE(numbers, written);
}

/// What can be set to what it is already changes nothing; moved, it is there.
TEST_P(Sheets, HavePathsThatCanBeSet) {
  Design design = design_of(GetParam());
  const std::string before = write_scene(design.loaded().scene);
  std::vector<Override> same;
  each_field(design, [&](const Json& field) {
    const std::string kind = field["kind"];
    if (kind == "group" || kind == "many") return;
    const Json& value = field["value"];
    same.push_back(
        {field["path"], value.is_string() ? value.get<std::string>() : value.dump()});
  });
  const auto changes = edits(design.loaded().scene, same);
  if (!changes.empty()) change(design, changes);
  EXPECT_EQ(write_scene(design.loaded().scene), before);
}

INSTANTIATE_TEST_SUITE_P(Of, Sheets,
                         testing::Values("04-motion-capture", "10-better-speakers",
                                         "16-robust-room", "17-crowded-room",
                                         "21-marker-body", "27-by-formulas",
                                         "hiball/six-lepd"),
                         [](const auto& i) {
                           std::string name = i.param;
                           for (char& c : name)
                             if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
                           return name;
                         });

TEST(SceneForm, KnowsUnitsAndBounds) {
  Design design = design_of("05-optitrack-lab");
  change(design,
         {{"occluders", "[{name: pillar, cylinder: {radius: 20 cm, height: 3}}]"},
          {"constraints", "[{name: good, metric: eigmax, below: 5 cm}]"}});
  const Json radius = field_at(design, "occluders.pillar.cylinder.radius");
  EXPECT_EQ(radius["value"], 0.2);
  EXPECT_EQ(radius["unit"], "m");
  EXPECT_EQ(radius["lower"], 0);
  EXPECT_TRUE(radius["upper"].is_null());
  EXPECT_EQ(field_at(design, "sample.volume.step")["unit"], "m");
  EXPECT_EQ(field_at(design, "constraints.good.below")["unit"], "m");
  const Json metric = field_at(design, "constraints.good.metric");
  EXPECT_NE(std::find(metric["known"].begin(), metric["known"].end(), "eigmax"),
            metric["known"].end());
  EXPECT_EQ(field_at(design, "covariance")["words"],
            Json({"prior", "posterior", "single"}));
}

/// What a section offers can be added, whichever it is: a room of its own each time.
TEST(SceneForm, OffersWhatCanBeAdded) {
  for (const std::string section :
       {"occluders", "regions", "sample", "surfaces", "beacons", "groups", "clutter",
        "motions", "constraints", "objective"}) {
    const Json offered = field_at(design_of("05-optitrack-lab"), section)["add"];
    EXPECT_FALSE(offered.empty()) << section;
    for (const Json& act : offered) {
      // Keys of a set are its shape or its sampling: what they need stands beside them.
      if (section == "sample" && act["path"] != "sample") continue;
      Design design = design_of("05-optitrack-lab");
      if (section == "constraints")
        edit(design, "regions.door", "{box: {min: [-9, -9, -9], max: [9, 9, 9]}}");
      Json again = act;
      const Json now = field_at(design, section);
      for (const Json& fresh : now["add"])
        if (fresh["label"] == act["label"]) again = fresh;
      const std::string before = design.text();
      EXPECT_TRUE(can(design, again)) << again;
      EXPECT_NE(design.text(), before) << again;
    }
  }
}

TEST(SceneForm, CopiesRenamesAndRemoves) {
  Design design = design_of("05-optitrack-lab");
  edit(design, "regions.door", "{box: {min: [0, 0, 0], max: [1, 1, 2]}}");
  edit(design, "occluders.+", "{name: table, box: {min: [0, 0, 0], max: [1, 1, 1]}}");
  edit(design, "constraints.+", "{name: out, outside: door, devices: '*'}");
  const auto& scene = [&]() -> const Scene& { return design.loaded().scene; };
  change(design, copying_part(scene(), "regions.door"));
  change(design, copying_part(scene(), "occluders.table"));
  ASSERT_EQ(scene().regions.size(), 2u);
  EXPECT_EQ(scene().regions[1].name, "door_2");
  EXPECT_EQ(scene().regions[1].body, scene().regions[0].body);
  EXPECT_EQ(scene().occluders[1].name, "table_2");

  change(design, renaming_part(scene(), "regions.door", "gate"));
  EXPECT_EQ(scene().regions[0].name, "gate");
  EXPECT_EQ(std::get<KeepInside>(scene().constraints[0].what).region, "gate")
      << "who named it goes on naming it";
  EXPECT_THROW(renaming_part(scene(), "regions.gate", "door_2"), Refusal);
  EXPECT_THROW(renaming_part(scene(), "regions.window", "w"), Refusal);
  EXPECT_THROW(copying_part(scene(), "regions"), Refusal);

  EXPECT_FALSE(can(design, field_at(design, "regions.gate")["remove"]))
      << "a constraint is about it";
  for (const char* path : {"constraints.out", "regions.gate", "regions.door_2",
                           "occluders.table", "occluders.table_2"})
    EXPECT_TRUE(can(design, field_at(design, path)["remove"])) << path;
  EXPECT_TRUE(scene().regions.empty());
  EXPECT_TRUE(scene().occluders.empty());
  EXPECT_EQ(design.history().undoable(), 11u) << "each is a step";
  while (design.undo(plugins())) {
  }
  EXPECT_EQ(design.text(), design_of("05-optitrack-lab").text());
}

/// A variable of what is renamed follows.
TEST(SceneForm, RenamesVariables) {
  Design design = design_of("05-optitrack-lab");
  edit(design, "occluders.+", "{name: post, sphere: {radius: 0.1}, at: [0, 0, 1]}");
  edit(design, "variables.+", "{path: occluders.post.at.x, lower: -1, upper: 1}");
  change(design, renaming_part(design.loaded().scene, "occluders.post", "ball"));
  EXPECT_EQ(design.loaded().scene.variables.back().path, "occluders.ball.at.x");
}

/// However the file says it: here the motion is in words, and is shown by its numbers.
TEST(SceneForm, ChangesWhatIsShown) {
  Design design = design_of("05-optitrack-lab");
  change(design, {{"motion", "{named: walk}"}});
  const double q = field_at(design, "motion.q.0")["value"];
  edit(design, "motion.q.0", std::to_string(2 * q));
  EXPECT_NEAR(field_at(design, "motion.q.0")["value"], 2 * q, 1e-5 * q);
}

/// Sentences are those of `delos check`.
TEST(SceneForm, RefusesWithTheScenesOwnWords) {
  Design design = design_of("05-optitrack-lab");
  Diagnostics findings;
  EXPECT_FALSE(design.change(
      edits(design.loaded().scene, {{"constraints.+", "{inside: hall, devices: '*'}"}}),
      "", plugins(), findings));
  ASSERT_FALSE(findings.empty());
  EXPECT_NE(
      findings[0].message.find("there is no region 'hall'; the scene declares none"),
      std::string::npos)
      << findings[0].message;
  try {
    edits(design.loaded().scene, {{"motion.q.7", "1"}});
    ADD_FAILURE();
  } catch (const Refusal& refusal) {
    EXPECT_EQ(to_string(refusal.findings().front()),
              "--set motion.q.7: error: motion.q.7: there is no such member; known: x, "
              "y, z");
  }
}

/// Of another metric, what was made small is made large where more is better.
TEST(SceneForm, FollowsTheMetric) {
  Design design = design_of("10-better-speakers");
  change(design, {{"objective", "{minimize: mean}"},
                  {"constraints", "[{name: good, metric: eigmax, below: 1}]"}});
  std::string larger;
  for (const std::string& name : metric_names(known_metrics(design.loaded().scene))) {
    const auto metric = parse_metric(name, known_metrics(design.loaded().scene));
    if (std::get<Metric>(metric).larger_is_better) larger = name;
  }
  ASSERT_NE(larger, "");
  edit(design, "objective.terms.0.of", larger);
  EXPECT_TRUE(design.loaded().scene.objective.terms[0].maximize);
  edit(design, "constraints.good.metric", larger);
  EXPECT_EQ(std::get<KeepMetric>(design.loaded().scene.constraints[0].what).metric,
            larger);
  edit(design, "objective.terms.0.of", "eigmax");
  EXPECT_FALSE(design.loaded().scene.objective.terms[0].maximize);
}

}  // namespace
}  // namespace delos::session
