#include <gtest/gtest.h>

#include <stdexcept>

#include "device/devices.h"

namespace delos::test {
namespace {

// By hand: [1 0 0.5; 0 2 0] · (1, 2, 3) = (2.5, 4).
TEST(Linear, MultipliesTheState) {
  const auto linear =
      device("linear", "{H: [[1, 0, 0.5], [0, 2, 0]], R: [[4, 2], [2, 1]]}");
  EXPECT_EQ(linear->span(), Span::state);
  EXPECT_EQ(linear->state_size(), 3);
  Target target;
  target.state = Eigen::Vector3d(1, 2, 3);
  Observation out;
  ASSERT_TRUE(linear->observe(target, out));
  EXPECT_EQ(out.z, Eigen::Vector2d(2.5, 4));
  EXPECT_EQ(out.H, (Eigen::Matrix<double, 2, 3>() << 1, 0, 0.5, 0, 2, 0).finished());
  EXPECT_EQ(out.R,
            (Eigen::Matrix2d() << 4, 2, 2, 1).finished());  // singular: 4·1 − 2·2
}

TEST(Linear, RefusesMatricesThatDontFit) {
  EXPECT_EQ(refusal("linear", "{H: [[1, 0], [0, 1]], R: [[1, 0]]}"),
            "R must be square, it is 1×2");
  EXPECT_EQ(refusal("linear", "{H: [[1, 0], [0, 1]], R: [[1]]}"),
            "R must have as many rows as H, it is 1×1 and H is 2×2");
  EXPECT_EQ(refusal("linear", "{H: [[1, 0], [0, 1]], R: [[1, 0.5], [0.4, 1]]}"),
            "R must be symmetric, row 1 differs from column 1");
  // Eigenvalues of [1 2; 2 1]: 1 ± 2.
  EXPECT_EQ(refusal("linear", "{H: [[1, 0], [0, 1]], R: [[1, 2], [2, 1]]}"),
            "R must have no negative eigenvalue, it has -1.000000");
  std::string row = "[0";
  for (int i = 0; i < kMaxState; ++i) row += ", 0";
  EXPECT_EQ(refusal("linear", "{H: [" + row + "]], R: [[1]]}"),
            "H must be 1×1 to 30×30, it is 1×31");
}

TEST(Linear, TakesSingularNoise) {
  EXPECT_EQ(refusal("linear", "{H: [[1, 0], [0, 1]], R: [[0, 0], [0, 0]]}"),
            "accepted");
  // Rank one with eigenvalues that rounding may carry below zero.
  EXPECT_EQ(refusal("linear",
                    "{H: [[1], [1], [1]], R: [[0.01, 0.01, 0.01], [0.01, 0.01, 0.01], "
                    "[0.01, 0.01, 0.01]]}"),
            "accepted");
}

}  // namespace
}  // namespace delos::test
