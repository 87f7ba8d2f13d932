// Faces that devices stick to: places on them, by geometry done by hand.
#include "session/faces.h"

#include <cmath>

#include "designs.h"

namespace delos::session {
namespace {

constexpr double kOnIt = 1e-9;

/// The laboratory with a table, whose top is at 0.7 m, and a patch that slants by 45°.
Design room_with_a_roof() {
  Design design = design_of("05-optitrack-lab");
  change(design,
         {{"occluders", "[{name: table, box: {min: [0, 0, 0], max: [1, 2, 0.7]}}]"},
          {"surfaces",
           "{roof: {patch: {origin: [-1, -1, 1], u: [1, 0, 0], v: [0, 1, 1]}}}"}});
  return design;
}

TEST(Faces, HoldWhatIsNear) {
  const Design design = room_with_a_roof();
  const Faces faces(design.loaded(), "");
  const auto top = faces.nearest({0.4, 0.5, 0.73}, 0.05);
  ASSERT_TRUE(top);
  EXPECT_LT((top->p - Eigen::Vector3d(0.4, 0.5, 0.7)).norm(), kOnIt);
  EXPECT_LT((top->normal - Eigen::Vector3d::UnitZ()).norm(), kOnIt);
  EXPECT_FALSE(faces.nearest({0.4, 0.5, 0.76}, 0.05)) << "6 cm away";
  // 2 cm off the patch, whose plane is z − y = 2 through (−1, −1, 1).
  const Eigen::Vector3d on(-0.5, -0.6, 1.4),
      up = Eigen::Vector3d(0, -1, 1).normalized();
  const auto roof = faces.nearest(on + 0.02 * up, 0.05);
  ASSERT_TRUE(roof);
  EXPECT_LT((roof->p - on).norm(), kOnIt);
  EXPECT_LT((roof->normal - up).norm(), kOnIt);
}

TEST(Faces, AreMetByRaysFromTheirFreeSide) {
  const Design design = room_with_a_roof();
  const Faces faces(design.loaded(), "");
  // Down on the table, by a slanted ray of any length: (0.2, 0.4, 0.7) + s·(1, 2, 4).
  const Eigen::Vector3d on(0.2, 0.4, 0.7), along(-0.1, -0.2, -0.4);
  const auto top = faces.first(on - 3 * along, along);
  ASSERT_TRUE(top);
  EXPECT_LT((top->p - on).norm(), kOnIt);
  EXPECT_NEAR(top->p.z(), 0.7, kOnIt);
  EXPECT_LT((top->normal - Eigen::Vector3d::UnitZ()).norm(), kOnIt);
  // From outside the room through its near wall, which is seen from behind, to the far
  // one: that of the cameras and samples.
  double far = -1e9;
  for (const PlacedDevice& device : design.loaded().system.devices)
    far = std::max(far, device.X_WS().p.x());
  const auto wall = faces.first({-50, -3, 2.5}, {2, 0, 0});
  ASSERT_TRUE(wall);
  EXPECT_NEAR(wall->p.x(), far, kOnIt);
  EXPECT_LT((wall->normal + Eigen::Vector3d::UnitX()).norm(), kOnIt);
  EXPECT_FALSE(faces.first({-50, -3, 2.5}, {-1, 0, 0}));
}

/// The device in the hand makes no wall for itself.
TEST(Faces, AreThoseOfOthers) {
  Design design = room_with_a_roof();
  change(design, {{"devices.c104325.at.x", "9"}});
  const Eigen::Vector3d from(-50, -3, 2.5), along(1, 0, 0);
  EXPECT_NEAR(Faces(design.loaded(), "").first(from, along)->p.x(), 9, kOnIt);
  EXPECT_LT(Faces(design.loaded(), "c104325").first(from, along)->p.x(), 3);
}

TEST(Faces, TurnByTheLeastAngle) {
  const Eigen::Matrix3d R =
      Eigen::AngleAxisd(1.1, Eigen::Vector3d(0.3, -0.5, 0.8).normalized())
          .toRotationMatrix();
  const Eigen::Vector3d z = Eigen::Vector3d(1, 2, -2) / 3;
  const Eigen::Matrix3d turned = turned_to(R, z);
  EXPECT_LT((turned.col(2) - z).norm(), 1e-12);
  EXPECT_NEAR(turned.determinant(), 1, 1e-12);
  const double angle = Eigen::AngleAxisd(turned * R.transpose()).angle();
  EXPECT_NEAR(angle, std::acos(R.col(2).dot(z)), 1e-12);
}

}  // namespace
}  // namespace delos::session
