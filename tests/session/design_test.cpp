// A scene while it is changed.
#include "designs.h"

namespace delos::session {
namespace {

TEST(Design, IsTheScenePlusItsChanges) {
  Design design = design_of("01-acoustic");
  const std::vector<Override> changes = {{"devices.s1.at.z", "1.5"},
                                         {"devices.s2.params.r", "0.01"}};
  for (const Override& one : changes) change(design, {one});
  Diagnostics findings;
  const auto loaded = load(design.file(), changes, plugins(), findings);
  EXPECT_EQ(design.loaded().scene, loaded->scene);
  design.undo(plugins());
  EXPECT_EQ(design.loaded().scene,
            load(design.file(), {changes[0]}, plugins(), findings)->scene);
}

TEST(Design, StaysAsItWasWhereAChangeIsRefused) {
  Design design = design_of("01-acoustic");
  change(design, {{"devices.s1.at.z", "1.5"}});
  const Scene before = design.loaded().scene;
  Diagnostics findings;
  EXPECT_FALSE(design.change({{"devices.s1.at.z", "1 kg"}}, "", plugins(), findings));
  EXPECT_FALSE(findings.empty());
  EXPECT_EQ(design.loaded().scene, before);
  EXPECT_EQ(design.history().undoable(), 1u);
}

/// Far from the file it is what the file and all changes are, too; back, and on another
/// way.
TEST(Design, IsTheSameHoweverLongItsHistory) {
  Design design = design_of("01-acoustic");
  std::vector<std::string> texts = {design.text()};
  for (int i = 0; i < 200; ++i) {
    const std::string device = "devices.s" + std::to_string(1 + i % 4);
    const double z = 1 + 0.001 * i;
    Diagnostics none;
    // Every third is a part of the step before.
    ASSERT_TRUE(
        design.change({{device + (i % 2 ? ".at.z" : ".at.x"), std::to_string(z)}},
                      std::to_string(i - (i % 3 == 2)), plugins(), none));
    if (i % 3 == 2)
      texts.back() = design.text();
    else
      texts.push_back(design.text());
  }
  Diagnostics findings;
  const auto loaded =
      load(design.file(), design.history().changes(), plugins(), findings);
  EXPECT_EQ(design.loaded().scene, loaded->scene);
  for (std::size_t i = texts.size() - 1; i-- > 20;) {
    ASSERT_TRUE(design.undo(plugins()));
    ASSERT_EQ(design.text(), texts[i]) << i;
  }
  for (std::size_t i = 21; i < texts.size(); ++i) {
    ASSERT_TRUE(design.redo(plugins()));
    ASSERT_EQ(design.text(), texts[i]) << i;
  }
  for (int i = 0; i < 40; ++i) design.undo(plugins());
  change(design, {{"devices.s1.at.y", "0.5"}});
  EXPECT_EQ(
      design.loaded().scene,
      load(design.file(), design.history().changes(), plugins(), findings)->scene);
}

/// Its text is the same scene, wherever it is read.
TEST(Design, ReadsBackFromItsText) {
  for (const char* name :
       {"03-hybrid", "07-torso", "10-better-speakers", "16-robust-room"}) {
    const Design design = design_of(name);
    Diagnostics findings;
    const auto scene =
        parse_scene(design.text(), "/nowhere/scene.yaml", {}, plugins(), findings);
    ASSERT_TRUE(scene) << name << (findings.empty() ? "" : to_string(findings[0]));
    EXPECT_EQ(scene->devices, design.loaded().scene.devices) << name;
    EXPECT_EQ(write_scene(*scene), design.text()) << name;
  }
}

}  // namespace
}  // namespace delos::session
