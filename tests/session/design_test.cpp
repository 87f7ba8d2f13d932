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
