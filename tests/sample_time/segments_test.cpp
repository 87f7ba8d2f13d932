// Records whose motion changes are cut where it does.
#include "motion/segments.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace delos::motion {
namespace {

constexpr double kPeriod = 0.01;

/// A target that moves on as a chain of another order, or another q, from where it was.
class Drawn {
 public:
  explicit Drawn(unsigned seed) : random_(seed) {}

  /// @param k order; more frames of it
  void move(int k, double q, int frames) {
    for (int i = 0; i < frames; ++i) {
      for (int axis = 0; axis < 3; ++axis) {
        // Small steps of the driving noise, of which the last decide.
        constexpr int kSteps = 4;
        const double h = kPeriod / kSteps;
        auto& [p, v, a] = state_[axis];
        for (int s = 0; s < kSteps; ++s) {
          const double w = std::sqrt(q * h) * normal_(random_);
          if (k == 1) {
            p += w;
            v = 0;
          } else if (k == 2) {
            p += v * h;
            v += w;
          } else {
            p += v * h + a * h * h / 2;
            v += a * h;
            a += w;
          }
        }
        values_.push_back(p + 1e-4 * normal_(random_));
      }
    }
  }
  [[nodiscard]] recordings::Track track() const {
    recordings::Track track{"hand", {}};
    track.at =
        Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>>(
            values_.data(), static_cast<Eigen::Index>(values_.size() / 3), 3);
    return track;
  }

 private:
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
  std::array<std::array<double, 3>, 3> state_{};
  std::vector<double> values_;
};

std::vector<Segment> cut(const recordings::Track& track) {
  auto answer = fit_segments(track, kPeriod, {});
  auto* segments = std::get_if<std::vector<Segment>>(&answer);
  return segments ? *segments : std::vector<Segment>();
}

TEST(Segments, OneMotionIsOnePart) {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    Drawn drawn(seed);
    drawn.move(2, 0.3, 700);
    EXPECT_EQ(cut(drawn.track()).size(), 1u) << seed;
  }
}

TEST(Segments, CutWhereTheMotionChanges) {
  Drawn drawn(7);
  drawn.move(1, 1e-4, 400);
  drawn.move(2, 2.0, 400);
  drawn.move(1, 1e-4, 300);
  const auto parts = cut(drawn.track());
  ASSERT_EQ(parts.size(), 3u);
  EXPECT_NEAR(parts[0].to, 4.0, 0.15);
  EXPECT_NEAR(parts[1].to, 8.0, 0.15);
  EXPECT_EQ(parts[0].from, 0);
  EXPECT_EQ(parts[1].from, parts[0].to);
  EXPECT_NEAR(parts[2].to, 11.0, 1e-9);
  EXPECT_EQ(parts[0].fit.best, 0);
  EXPECT_EQ(parts[1].fit.best, 1);
  EXPECT_EQ(parts[2].fit.best, 0);
  const ChainFit& x = parts[1].fit.orders[1].axes[0];
  EXPECT_LT(x.q.low, 2.0);
  EXPECT_GT(x.q.high, 2.0);
  const std::string block = motions_block(parts, "a.csv");
  EXPECT_NE(block.find("motions:\n  part1:  # a.csv, 0 s to "), std::string::npos)
      << block;
  EXPECT_NE(block.find("\n    type: position_velocity\n"), std::string::npos) << block;
}

/// The same order, ten times as lively.
TEST(Segments, CutWhereQGrows) {
  Drawn drawn(9);
  drawn.move(2, 0.05, 500);
  drawn.move(2, 5.0, 400);
  const auto parts = cut(drawn.track());
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_NEAR(parts[0].to, 5.0, 0.15);
}

TEST(Segments, SayWhyThereAreNone) {
  Drawn drawn(3);
  drawn.move(1, 1, 20);
  const auto answer = fit_segments(drawn.track(), kPeriod, {});
  ASSERT_TRUE(std::holds_alternative<std::string>(answer));
  EXPECT_NE(std::get<std::string>(answer).find("only 20 frames"), std::string::npos);
}

}  // namespace
}  // namespace delos::motion
