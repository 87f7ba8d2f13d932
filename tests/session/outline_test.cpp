// The edges of views, against what their equations say.
#include <algorithm>
#include <cmath>

#include "designs.h"
#include "session/view_outline.h"

namespace delos::session {
namespace {

/// Half an image of n pixels of 5.5 µm behind a lens: n·5.5e-6/(2·focal) at depth 1.
/// One of 2 mm sees 70 degrees to either side.
TEST(Outline, IsTheImageOfACamera) {
  for (const double focal : {6.8e-3, 2e-3}) {
    Design design = design_of("05-optitrack-lab");
    change(design, {{"devices.c104321.params.focal", std::to_string(focal)}});
    const auto edge = view_outline(*design.loaded().system.devices[0].device, 2.0);
    ASSERT_EQ(edge.size(), 180u);
    const double width = 2048 * 5.5e-6 / focal, height = 1088 * 5.5e-6 / focal;
    for (const Eigen::Vector3d& p : edge) {
      EXPECT_EQ(p.z(), 2.0);
      const double beyond = std::max(std::abs(p.x()) / width, std::abs(p.y()) / height);
      EXPECT_NEAR(beyond, 1, 1e-5) << p.transpose();
    }
  }
}

/// It sees from 0.3 m to 15 m; asked elsewhere, it is looked at where it sees.
TEST(Outline, IsLookedForWhereTheDeviceSees) {
  const Design design = design_of("05-optitrack-lab");
  const Device& camera = *design.loaded().system.devices[0].device;
  for (const double depth : {0.01, 400.0}) {
    const auto edge = view_outline(camera, depth);
    ASSERT_FALSE(edge.empty());
    EXPECT_GE(edge[0].z(), 0.3);
    EXPECT_LE(edge[0].z(), 15);
  }
}

TEST(Outline, IsEmptyOfWhatSeesAllAround) {
  const Design design = design_of("01-acoustic");
  EXPECT_TRUE(view_outline(*design.loaded().system.devices[0].device, 1).empty());
}

}  // namespace
}  // namespace delos::session
