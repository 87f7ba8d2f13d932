// Whole boxes against a point: what may be in between, and what is hidden for certain.
#include <gtest/gtest.h>

#include <random>

#include "delos/geometry/occluders.h"
#include "delos/geometry/primitives.h"

namespace delos::test {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : engine_(seed) {}
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }
  Vector3d point(double reach) {
    return {uniform(-reach, reach), uniform(-reach, reach), uniform(-reach, reach)};
  }
  Vector3d inside(const AlignedBox3d& box) {
    return {uniform(box.min().x(), box.max().x()),
            uniform(box.min().y(), box.max().y()),
            uniform(box.min().z(), box.max().z())};
  }
  /// One in four is flat in some directions.
  AlignedBox3d box(double reach, double largest) {
    const Vector3d corner = point(reach);
    Vector3d size(uniform(0, largest), uniform(0, largest), uniform(0, largest));
    if (uniform(0, 1) < 0.25) {
      for (int i = 0; i < 3; ++i) size[i] *= uniform(0, 1) < 0.5;
    }
    return {corner, corner + size};
  }

 private:
  std::mt19937_64 engine_;
};

/// A room's clutter: bodies, a sheet with dents and loose triangles.
Occluders clutter() {
  Draw draw(11);
  TriangleMesh loose;
  for (std::uint32_t i = 0; i < 40; ++i) {
    const Vector3d at = draw.point(2);
    for (int k = 0; k < 3; ++k) loose.vertices.push_back(at + draw.point(0.3));
    loose.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  TriangleMesh dented = make_sphere(0.6, 3);
  for (Vector3d& p : dented.vertices) p *= 1 + 0.2 * std::sin(8 * p.x());
  return Occluders({loose, make_box({-2, -0.1, -1}, {-1, 0.1, 1}),
                    transformed(make_cylinder(0.2, 2), Pose{.p = {1, 1, -1}}),
                    transformed(dented, Pose{.p = {0, -1, 0}})});
}

AlignedBox3d cube(const Vector3d& centre, double half) {
  return {centre.array() - half, centre.array() + half};
}

// The oracle is blocks(), which is compared with brute force elsewhere.
TEST(Shaft, IsTouchedWhereverASegmentIsBlocked) {
  const Occluders occluders = clutter();
  Draw draw(1);
  int blocked = 0;
  for (int i = 0; i < 40000; ++i) {
    const Vector3d apex = draw.point(3);
    const AlignedBox3d box = draw.box(3, i % 2 == 0 ? 0.2 : 2);
    const Vector3d p = i % 3 == 0
                           ? box.corner(static_cast<AlignedBox3d::CornerType>(i % 8))
                           : draw.inside(box);
    if (!occluders.blocks(apex, p, i % 5 == 0 ? 0.01 : 0)) continue;
    ++blocked;
    ASSERT_TRUE(occluders.touches_shaft(apex, box))
        << "apex " << apex.transpose() << ", box " << box.min().transpose() << " to "
        << box.max().transpose() << ", p " << p.transpose();
  }
  EXPECT_GT(blocked, 5000);
}

// Triangles that end on the shaft's very planes: rounding must not lose them.
TEST(Shaft, IsTouchedByWhatGrazesIt) {
  Draw draw(2);
  for (int i = 0; i < 20000; ++i) {
    const double scale = std::pow(10.0, draw.uniform(-3, 4));
    const Vector3d apex = scale * draw.point(3);
    AlignedBox3d box = draw.box(3, 1);
    box = AlignedBox3d(scale * box.min(), scale * box.max());
    // A triangle that has a corner on the segment to a corner of the box, at a place
    // that needs no rounding, and leads away from the box.
    const Vector3d corner = box.corner(static_cast<AlignedBox3d::CornerType>(i % 8));
    const Vector3d touch = i % 2 == 0 ? corner : apex;
    const Vector3d away = (touch - box.center()).normalized() * scale;
    TriangleMesh thorn;
    thorn.vertices = {touch, touch + away, touch + away + 0.1 * scale * draw.point(1)};
    thorn.triangles = {{0, 1, 2}};
    const Occluders occluders({thorn});
    if (occluders.triangles() == 0) continue;
    ASSERT_TRUE(occluders.touches_shaft(apex, box)) << i;
  }
}

// The hull of a far apex and a small box is thin: most of the clutter's surroundings
// are out of it. Whether something is truly in between is sampled by 60 segments.
TEST(Shaft, IsFreeForMostBoxesInTheClear) {
  const Occluders occluders = clutter();
  Draw draw(3);
  int clear = 0, free = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vector3d apex = draw.point(3);
    const AlignedBox3d box = draw.box(3, 0.2);
    bool blocked = false;
    for (int k = 0; k < 60 && !blocked; ++k) {
      blocked = occluders.blocks(apex, draw.inside(box), 0);
    }
    if (blocked) continue;
    ++clear;
    free += !occluders.touches_shaft(apex, box);
  }
  EXPECT_GT(clear, 500);
  EXPECT_GT(free, 0.9 * clear) << "of " << clear;
}

TEST(Shaft, IsTheBoxItselfAroundTheApex) {
  const Occluders post({make_box({1, 1, 0}, {1.1, 1.1, 3})});
  EXPECT_TRUE(post.touches_shaft({0, 0, 1}, cube({0, 0, 1}, 1.05)));
  EXPECT_FALSE(post.touches_shaft({0, 0, 1}, cube({0, 0, 1}, 0.95)));
}

TEST(Hidden, BoxesHaveNoPointInTheLight) {
  const Occluders occluders = clutter();
  Draw draw(4);
  int hidden = 0;
  for (int i = 0; i < 60000; ++i) {
    const double skin = i % 2 == 0 ? 0 : 0.003;
    const Vector3d apex = draw.point(3);
    const AlignedBox3d box = draw.box(3, 0.5);
    if (!occluders.hides(apex, box, skin)) continue;
    ++hidden;
    for (int k = 0; k < 40; ++k) {
      const Vector3d p = k < 8 ? box.corner(static_cast<AlignedBox3d::CornerType>(k))
                               : draw.inside(box);
      ASSERT_TRUE(occluders.blocks(apex, p, skin)) << i;
    }
    ASSERT_TRUE(occluders.touches_shaft(apex, box));
  }
  EXPECT_GT(hidden, 1000);
}

// By similar triangles: a wall 1 m away and 2 m wide hides ±3 m at 3 m.
TEST(Hidden, IsWhatIsBehindAWall) {
  const Occluders wall({make_box({1, -1, -1}, {1.1, 1, 1})});
  const Vector3d apex(0, 0, 0);
  EXPECT_TRUE(wall.hides(apex, cube({4, 0, 0}, 1), 1e-3));
  EXPECT_TRUE(wall.hides(apex, cube({4, 1.9, 1.9}, 1), 1e-3));      // to 2.9 at x = 3
  EXPECT_FALSE(wall.hides(apex, cube({4, 2.1, 0}, 1), 1e-3));       // to 3.1
  EXPECT_FALSE(wall.hides(apex, cube({-4, 0, 0}, 1), 1e-3));        // in front
  EXPECT_FALSE(wall.hides(apex, cube({1.5, 0, 0}, 0.4005), 1e-3));  // within the skin
  EXPECT_TRUE(wall.hides(apex, cube({1.5, 0, 0}, 0.39), 1e-3));
}

TEST(Hidden, IsWhatIsBehindAPillar) {
  const Occluders pillar({transformed(make_cylinder(0.3, 3), Pose{.p = {2, 0, 0}})});
  EXPECT_TRUE(pillar.hides({0, 0, 1.5}, cube({4, 0, 1.5}, 0.25), 1e-3));
  EXPECT_FALSE(pillar.hides({0, 0, 1.5}, cube({4, 0.5, 1.5}, 0.25), 1e-3));
}

// Each of two boxes side by side hides half of what is behind them: no single piece
// does.
TEST(Hidden, NeedsOnePieceForTheWholeBox) {
  const Occluders halves(
      {make_box({1, -1, -1}, {1.1, 0, 1}), make_box({1, 0, -1}, {1.1, 1, 1})});
  EXPECT_FALSE(halves.hides({0, 0, 0}, cube({4, 0, 0}, 0.5), 0));
  EXPECT_TRUE(halves.hides({0, 0, 0}, cube({4, 1, 0}, 0.5), 0));
}

TEST(Hidden, IsNotWhatSharesTheBodyWithTheApex) {
  const Occluders room({make_box({-2, -2, 0}, {2, 2, 3})});
  EXPECT_FALSE(room.hides({0, 0, 1}, cube({1, 1, 1}, 0.2), 1e-3));
  EXPECT_TRUE(room.hides({0, 0, 1}, cube({4, 1, 1}, 0.2), 1e-3));  // outside
  EXPECT_TRUE(room.hides({4, 1, 1}, cube({0, 0, 1}, 0.2), 1e-3));
}

// What a slab within the skin of the apex would hide, blocks() doesn't see.
TEST(Hidden, IsNotWhatOnlyTheApexSkinCovers) {
  const Occluders slab({make_box({0.001, -1, -1}, {0.002, 1, 1})});
  EXPECT_FALSE(slab.hides({0, 0, 0}, cube({4, 0, 0}, 0.5), 0.01));
  EXPECT_TRUE(slab.hides({0, 0, 0}, cube({4, 0, 0}, 0.5), 0.0005));
}

}  // namespace
}  // namespace delos::test
