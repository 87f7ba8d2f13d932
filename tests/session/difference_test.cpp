// Two designs on the same samples.
#include "session/difference.h"

#include <algorithm>
#include <cmath>

#include "designs.h"
#include "session/device_worth.h"

namespace delos::session {
namespace {

TEST(Difference, IsZeroBetweenEqualDesigns) {
  const Design design = design_of("02-eight-cameras");
  Baseline baseline{design.loaded(), {}};
  const DrawnField same = draw_difference(design.loaded(), baseline, 0, {});
  for (std::size_t i = 0; i < same.mask.size(); ++i)
    if (same.mask[i] == Drawn::value) EXPECT_EQ(same.field.value[i], 0);
  EXPECT_EQ(same.summary["mean"], 0);
  EXPECT_EQ(same.summary["better"], 0);
  EXPECT_EQ(same.summary["gained"], 0);
  EXPECT_EQ(same.summary["lost"], 0);
  EXPECT_EQ(same.summary["finite"], 2178) << "as scenes/README.md says";
}

/// Sample by sample what the two fields are apart; and back, when the change is taken
/// back.
TEST(Difference, IsTheDesignMinusTheBaseline) {
  Design design = design_of("01-acoustic");
  Baseline baseline{design.loaded(), {}};
  const Field before = evaluate_scene(design.loaded(), {}).field;
  change(design, {{"devices.s1.params.r", "0.001"}, {"devices.s3.at.z", "1.2"}});
  const Field after = evaluate_scene(design.loaded(), {}).field;
  const DrawnField drawn = draw_difference(design.loaded(), baseline, 0, {});
  double sum = 0;
  for (std::size_t i = 0; i < after.value.size(); ++i) {
    EXPECT_EQ(drawn.field.value[i], after.value[i] - before.value[i]);
    sum += after.value[i] - before.value[i];
  }
  EXPECT_NEAR(drawn.summary["mean"], sum / static_cast<double>(after.value.size()),
              1e-15);
  EXPECT_NE(drawn.summary["mean"], 0);
  design.undo(plugins());
  EXPECT_EQ(draw_difference(design.loaded(), baseline, 0, {}).summary["mean"], 0);
}

/// Of what is seen only before there are as many as the device was worth.
TEST(Difference, TellsWhatIsLostAndGained) {
  Design design = design_of("02-eight-cameras");
  const Samples samples = make_samples(design.loaded().scene.samples);
  const auto all = device_worth(design.loaded(), samples, {});
  const DeviceWorth worth = *std::max_element(
      all.begin(), all.end(),
      [](const DeviceWorth& a, const DeviceWorth& b) { return a.blinded < b.blinded; });
  ASSERT_GT(worth.blinded, 0u);
  Baseline baseline{design.loaded(), {}};
  change(design, {{"devices.-", worth.name}});
  const DrawnField without = draw_difference(design.loaded(), baseline, 0, {});
  EXPECT_EQ(without.summary["lost"], worth.blinded);
  EXPECT_EQ(without.summary["gained"], 0);
  Baseline fewer{design.loaded(), {}};
  design.undo(plugins());
  const DrawnField with = draw_difference(design.loaded(), fewer, 0, {});
  EXPECT_EQ(with.summary["gained"], worth.blinded);
  EXPECT_EQ(with.summary["lost"], 0);
  for (std::size_t i = 0; i < with.mask.size(); ++i)
    EXPECT_EQ(with.mask[i] == Drawn::gained, without.mask[i] == Drawn::lost);
}

/// Another fusion isn't a better design: what was pinned has it then, too, as delos
/// compare has it.
TEST(Difference, IsOfOneFusion) {
  Design design = design_of("01-acoustic");
  Baseline baseline{design.loaded(), {}};
  (void)draw_difference(design.loaded(), baseline, 0, {});  // kept, of stacked fusion
  change(design, {{"fusion", "continuous"}});
  const DrawnField drawn = draw_difference(design.loaded(), baseline, 0, {});
  EXPECT_EQ(drawn.summary["definition"], "a-priori covariance, continuous fusion");
  EXPECT_TRUE(drawn.summary["pinned_definition"].is_null());
  EXPECT_EQ(drawn.summary["mean"], 0);
  EXPECT_EQ(drawn.summary["better"], 0);
}

TEST(Difference, SaysWhatIsNotAlike) {
  Design design = design_of("01-acoustic");
  change(design, {{"fusion", "continuous"}});
  Baseline baseline{design.loaded(), {}};
  change(design, {{"fusion", "periodic"}});
  const DrawnField drawn = draw_difference(design.loaded(), baseline, 0, {});
  EXPECT_EQ(drawn.summary["definition"], "a-priori covariance, periodic fusion");
  EXPECT_EQ(drawn.summary["pinned_definition"],
            "a-priori covariance, continuous fusion");
}

/// What is pinned follows other samples and another metric.
TEST(Difference, FollowsSamplesAndMetric) {
  Design design = design_of("01-acoustic");
  Baseline baseline{design.loaded(), {}};
  change(design, {{"sample.volume.step", "0.1"}, {"metric", "sigma_z"}});
  const DrawnField drawn = draw_difference(design.loaded(), baseline, 0, {});
  EXPECT_EQ(drawn.summary["mean"], 0);
  EXPECT_EQ(drawn.summary["metric"]["name"], "sigma_z");
  EXPECT_EQ(drawn.mask.size(),
            make_samples(design.loaded().scene.samples).points.size());
}

}  // namespace
}  // namespace delos::session
