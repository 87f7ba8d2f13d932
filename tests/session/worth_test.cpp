// What devices are worth, against scenes that were written without them.
#include <cmath>

#include "designs.h"
#include "session/device_worth.h"

namespace delos::session {
namespace {

Field without(const LoadedScene& loaded, std::size_t device, const Samples& samples) {
  Scene scene = loaded.scene;
  scene.devices.erase(scene.devices.begin() + static_cast<std::ptrdiff_t>(device));
  return evaluate_field(build_system(scene, plugins()), samples, scene.orientations,
                        loaded.metric, {});
}

void expect_as_without(const Design& design) {
  const LoadedScene& loaded = design.loaded();
  const Samples samples = make_samples(loaded.scene.samples);
  const Field with = evaluate_field(loaded.system, samples, loaded.scene.orientations,
                                    loaded.metric, {});
  const auto worth = device_worth(loaded, samples, {});
  ASSERT_EQ(worth.size(), loaded.scene.devices.size());
  for (std::size_t i = 0; i < worth.size(); ++i) {
    EXPECT_EQ(worth[i].name, loaded.scene.devices[i].name);
    const Field less = without(loaded, i, samples);
    std::size_t blinded = 0, lost = 0;
    double a = 0, b = 0;
    for (std::size_t k = 0; k < with.value.size(); ++k) {
      if (!with.inside.empty() && with.inside[k]) continue;
      lost += with.observable[k] && !less.observable[k];
      if (!std::isfinite(with.value[k])) continue;
      if (!std::isfinite(less.value[k])) {
        ++blinded;
        continue;
      }
      a += with.value[k];
      b += less.value[k];
    }
    EXPECT_EQ(worth[i].blinded, blinded);
    EXPECT_EQ(worth[i].lost, lost);
    EXPECT_NEAR(worth[i].rise, (with.larger_is_better ? -1 : 1) * (b / a - 1), 1e-9);
  }
}

TEST(Worth, IsWhatIsLostWithoutADevice) {
  expect_as_without(design_of("02-eight-cameras"));
  expect_as_without(design_of("08-self-occlusion"));
}

/// Where more is better, less is the loss.
TEST(Worth, OfCoverageIsPositive) {
  Design design = design_of("02-eight-cameras");
  change(design, {{"metric", "coverage"}});
  expect_as_without(design);
  const auto worth =
      device_worth(design.loaded(), make_samples(design.loaded().scene.samples), {});
  for (const DeviceWorth& w : worth) EXPECT_GT(w.rise, 0);
}

TEST(Worth, OfTheOnlyDeviceIsNotAsked) {
  const Design design = design_of("13-camera-spots");
  EXPECT_TRUE(
      device_worth(design.loaded(), make_samples(design.loaded().scene.samples), {})
          .empty());
}

}  // namespace
}  // namespace delos::session
