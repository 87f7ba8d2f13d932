// Bodies put somewhere by hand: their corners are where they were put.
#include "session/bodies.h"

#include "designs.h"
#include "session/description.h"
#include "session/refusal.h"

namespace delos::session {
namespace {

/// The bounds of a region or an occluder, from what a page draws.
Eigen::AlignedBox3d bounds_drawn(const Design& design, const char* kind,
                                 std::size_t i) {
  const Json json = surroundings(design.loaded().scene)[kind][i];
  Eigen::AlignedBox3d box;
  for (std::size_t k = 0; k < json["vertices"].size(); k += 3)
    box.extend(Eigen::Vector3d(json["vertices"][k], json["vertices"][k + 1],
                               json["vertices"][k + 2]));
  return box;
}

Design room_of_bodies() {
  Design design = design_of("05-optitrack-lab");
  change(design, {{"occluders",
                   "[{name: table, box: {min: [0, 0, 0], max: [1, 2, 0.7]}}, "
                   "{cylinder: {radius: 0.2, height: 3}, at: [1, 1, 0]}]"},
                  {"regions",
                   "{door: {box: {min: [0, 0, 0], max: [1, 1, 2]}, at: [1, 2, 0], rpy: "
                   "[0, 0, 90 deg]}}"}});
  return design;
}

TEST(Bodies, AreMoved) {
  Design design = room_of_bodies();
  const Eigen::Vector3d p(-0.25, 0.5, 1.125);
  change(design, shaping(design.loaded().scene, "occluders.table", p, {}));
  EXPECT_LT((bounds_drawn(design, "occluders", 0).center() - p).norm(), 1e-6);
  EXPECT_EQ(std::get<BoxShape>(design.loaded().scene.occluders[0].body).min,
            Eigen::Vector3d(-0.75, -0.5, 0.775))
      << "by its corners, since it has no place";
  change(design, shaping(design.loaded().scene, "occluders.1", p, {}));
  EXPECT_LT((bounds_drawn(design, "occluders", 1).center() - p).norm(), 1e-6);
  change(design, shaping(design.loaded().scene, "regions.door", p, {}));
  EXPECT_LT((bounds_drawn(design, "regions", 0).center() - p).norm(), 1e-6);
  EXPECT_EQ(design.surroundings(), 4u) << "the room was drawn anew each time";
  change(design, {{"devices.c104325.at.x", "2"}});
  EXPECT_EQ(design.surroundings(), 4u);
  for (int i = 0; i < 2; ++i) design.undo(plugins());
  EXPECT_EQ(design.surroundings(), 5u);
}

TEST(Bodies, HaveOtherSizesAboutTheirMiddle) {
  Design design = room_of_bodies();
  const Eigen::Vector3d middle = bounds_drawn(design, "regions", 0).center();
  change(design, shaping(design.loaded().scene, "regions.door", {},
                         Eigen::Vector3d(3, 1, 0.5)));
  const Eigen::AlignedBox3d box = bounds_drawn(design, "regions", 0);
  // Along its own axes: it is turned by a right angle.
  EXPECT_LT((box.sizes() - Eigen::Vector3d(1, 3, 0.5)).norm(), 1e-6);
  EXPECT_LT((box.center() - middle).norm(), 1e-6);
  const Scene& scene = design.loaded().scene;
  EXPECT_THROW(shaping(scene, "occluders.1", {}, Eigen::Vector3d(1, 1, 1)), Refusal);
  EXPECT_THROW(shaping(scene, "regions.door", {}, Eigen::Vector3d(1, 0, 1)), Refusal);
  EXPECT_THROW(shaping(scene, "regions.window", Eigen::Vector3d(1, 0, 1), {}), Refusal);
  EXPECT_THROW(shaping(scene, "motion.q", Eigen::Vector3d(1, 0, 1), {}), Refusal);
}

TEST(Bodies, AreDrawnAsBoxes) {
  Design design = room_of_bodies();
  const Eigen::AlignedBox3d box(Eigen::Vector3d(-1, -1, 0.5),
                                Eigen::Vector3d(0.25, 0.5, 0.5));
  const double height = sample_box(design.loaded().scene).sizes().z();
  for (const char* name : {"region", "region_2"}) {
    change(design, painting(design.loaded(), "region", box));
    const RegionEntry& made = design.loaded().scene.regions.back();
    EXPECT_EQ(made.name, name);
    EXPECT_EQ(std::get<BoxShape>(made.body).max,
              Eigen::Vector3d(0.25, 0.5, 0.5 + height));
  }
  change(design, painting(design.loaded(), "occluder", box));
  EXPECT_EQ(design.loaded().scene.occluders.back().name, "body");
  EXPECT_EQ(std::get<BoxShape>(design.loaded().scene.occluders.back().body).min,
            box.min());
  EXPECT_THROW(painting(design.loaded(), "cloud", box), Refusal);
  EXPECT_THROW(painting(design.loaded(), "region", {box.min(), box.min()}), Refusal);
}

/// A search can be about a part of the room as soon as it is drawn.
TEST(Bodies, AreSetsOfSamples) {
  Design design = design_of("10-better-speakers");
  const Eigen::AlignedBox3d box(Eigen::Vector3d(0, 0, 0),
                                Eigen::Vector3d(0.3, 0.2, 0.1));
  change(design, painting(design.loaded(), "samples", box));
  ASSERT_EQ(design.loaded().scene.samples.size(), 2u);
  EXPECT_EQ(design.loaded().scene.samples[0].name, "all");
  EXPECT_EQ(design.loaded().scene.samples[1].name, "part");
  change(design, {{"objective", "{terms: [{minimize: mean, over: part}]}"}});
  EXPECT_EQ(design.loaded().scene.objective.terms[0].over[0].name, "part");
}

}  // namespace
}  // namespace delos::session
