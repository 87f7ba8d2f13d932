// Where points of a room fall in a picture.
#include "render/eye.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "session/refusal.h"

namespace delos::render {
namespace {

const Eigen::AlignedBox3d kRoom(Eigen::Vector3d(-2, -3, 0), Eigen::Vector3d(4, 5, 2));
const Frame kFrame{900, 600, 800};

TEST(Eye, LooksAlongAxes) {
  // What is to the right, and what is up, from each side.
  const std::vector<std::tuple<const char*, Eigen::Vector3d, Eigen::Vector3d>> views{
      {"top", {1, 0, 0}, {0, 1, 0}},   {"below", {1, 0, 0}, {0, -1, 0}},
      {"front", {1, 0, 0}, {0, 0, 1}}, {"back", {-1, 0, 0}, {0, 0, 1}},
      {"right", {0, 1, 0}, {0, 0, 1}}, {"left", {0, -1, 0}, {0, 0, 1}}};
  for (const auto& [name, right, up] : views) {
    View view = view_of(name);
    view.orthographic = true;
    const Eye eye(view, kRoom, kFrame);
    const Spot middle = eye.spot(eye.seen(kRoom.center()));
    EXPECT_NEAR(middle.x, 400, 1e-9);
    EXPECT_NEAR(middle.y, 300, 1e-9);
    const Spot r = eye.spot(eye.seen(kRoom.center() + right));
    const Spot u = eye.spot(eye.seen(kRoom.center() + up));
    EXPECT_GT(r.x, middle.x + 20) << name;
    EXPECT_NEAR(r.y, middle.y, 1e-9) << name;
    EXPECT_NEAR(middle.y - u.y, r.x - middle.x, 1e-9) << name << ": to one scale";
    EXPECT_NEAR(u.x, middle.x, 1e-9) << name;
  }
}

TEST(Eye, HasTheWholeRoomInThePicture) {
  for (const char* name : {"corner", "top", "front", "30,25", "200,-40"})
    for (const bool orthographic : {false, true}) {
      View view = view_of(name);
      view.orthographic = orthographic;
      const Eye eye(view, kRoom, kFrame);
      double most = 0;
      for (int i = 0; i < 8; ++i) {
        const Spot s = eye.spot(
            eye.seen(kRoom.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i))));
        most = std::max({most, std::abs(s.x - 400) / 400, std::abs(s.y - 300) / 300});
      }
      EXPECT_NEAR(most, 1 / 1.06, 1e-9) << name << ": as large as fits";
    }
}

// With a view of 40 degrees over the 600 pixels, what is 8 m ahead of the eye and 1 m
// up is 300/(8·tan 20°) pixels above the middle.
TEST(Eye, IsAsFarAsAskedFor) {
  const Eye eye(view_of("0,0,8 m"), kRoom, kFrame);
  EXPECT_TRUE(
      eye.position().isApprox(kRoom.center() + Eigen::Vector3d(8, 0, 0), 1e-12));
  const Spot up = eye.spot(eye.seen(kRoom.center() + Eigen::Vector3d(0, 0, 1)));
  EXPECT_NEAR(300 - up.y, 300 / (8 * std::tan(std::numbers::pi / 9)), 1e-9);
  // From 30 degrees from x towards y, 25 degrees up.
  const Eigen::Vector3d towards = view_of("30,25").towards;
  EXPECT_NEAR(std::atan2(towards.y(), towards.x()), std::numbers::pi / 6, 1e-12);
  EXPECT_NEAR(std::asin(towards.z()), 25 * std::numbers::pi / 180, 1e-12);
  EXPECT_TRUE(
      view_of("0.5 rad, 10 deg")
          .towards.isApprox(
              view_of(std::to_string(90 / std::numbers::pi) + ",10").towards, 1e-6));
}

TEST(Eye, RefusesWhatIsNoView) {
  for (const char* text : {"", "north", "30", "30,25,8,1", "30,95", "30,25,-1",
                           "30,25,0 m", "30 m,25", "x,25"}) {
    try {
      static_cast<void>(view_of(text));
      ADD_FAILURE() << text;
    } catch (const session::Refusal& refusal) {
      EXPECT_NE(std::string(refusal.what()).find("should be corner"),
                std::string::npos);
    }
  }
}

}  // namespace
}  // namespace delos::render
