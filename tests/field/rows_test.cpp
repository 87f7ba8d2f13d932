// From a device's frame to rows over the state.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <Eigen/QR>

#include "delos/model/lanes.h"
#include "observe/lever.h"
#include "observe/measure.h"
#include "support/rigs.h"

namespace delos {
namespace {

using Eigen::MatrixXd;

MatrixXd random_matrix(std::mt19937_64& random, Eigen::Index rows, Eigen::Index cols) {
  std::normal_distribution<double> normal;
  MatrixXd m(rows, cols);
  for (Eigen::Index i = 0; i < m.size(); ++i) m.data()[i] = normal(random);
  return m;
}

Pose random_pose(std::mt19937_64& random) {
  return {testing::random_rotation(random), random_matrix(random, 3, 1)};
}

/// [v]× with [v]× w = v × w.
Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& v) {
  return (Eigen::Matrix3d() << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0)
      .finished();
}

constexpr PoseState kPoseStates[] = {PoseState::position, PoseState::orientation,
                                     PoseState::pose, PoseState::planar,
                                     PoseState::planar_pose};

/// The columns of [δp, δθ] that a state has.
std::vector<int> columns_of(PoseState pose) {
  switch (pose) {
    case PoseState::position:
      return {0, 1, 2};
    case PoseState::orientation:
      return {3, 4, 5};
    case PoseState::pose:
      return {0, 1, 2, 3, 4, 5};
    case PoseState::planar:
      return {0, 1};
    case PoseState::planar_pose:
      return {0, 1, 5};
    case PoseState::none:
      break;
  }
  return {};
}

System system_of(PoseState pose, int order, Span span, const MatrixXd& H,
                 const MatrixXd& R, const Pose& X_WS) {
  System system;
  const auto d = static_cast<Eigen::Index>(columns_of(pose).size());
  system.motion = testing::chain_motion(pose, order, CoordinateMatrix::Identity(d, d));
  system.markers = {{0.3, -0.1, 0.2}};
  system.devices = {
      testing::place("d", std::make_shared<testing::TestLinear>(span, H, R), X_WS, 4)};
  return system;
}

/// The rows of the only device over [δp, δθ] or its derivatives too, as matrices:
/// H diag(R_SW, …), and for points H R_SW [1, −[arm]×].
MatrixXd rows_by_matrices(const System& system, Span span, const MatrixXd& H,
                          const TargetPose& X_WT) {
  const Eigen::Matrix3d R_SW = system.devices[0].X_WS().R.transpose();
  MatrixXd all;
  if (span == Span::point) {
    MatrixXd lever(3, 6);
    lever << MatrixXd::Identity(3, 3), -cross_matrix(X_WT.R * system.markers[0].p);
    all = H * R_SW * lever;
  } else {
    all = H;
    for (Eigen::Index k = 0; k < H.cols(); k += 3)
      all.middleCols<3>(k) = H.middleCols<3>(k) * R_SW;
  }
  const StateLayout& layout = system.motion.layout;
  MatrixXd rows = MatrixXd::Zero(H.rows(), information_size(system));
  const int orders = span == Span::motion ? layout.order : 1;
  Eigen::Index column = 0;
  for (int k = 0; k < orders; ++k)
    for (const int i : columns_of(layout.pose)) rows.col(column++) = all.col(6 * k + i);
  return rows;
}

// S = Aᵀ R⁻¹ A, with A written out as matrices, for a full R of three rows.
TEST(Rows, CorrelatedNoiseWeighsByItsInverse) {
  std::mt19937_64 random(3);
  for (const PoseState pose : kPoseStates) {
    for (const Span span : {Span::point, Span::pose, Span::motion}) {
      const int of_span = span == Span::point ? 3 : span == Span::pose ? 6 : 18;
      const MatrixXd H = random_matrix(random, 3, of_span),
                     root = random_matrix(random, 3, 3), R = root * root.transpose();
      const System system = system_of(pose, 2, span, H, R, random_pose(random));
      const TargetPose X_WT = random_pose(random);
      const MatrixXd A = rows_by_matrices(system, span, H, X_WT),
                     S = A.transpose() * R.inverse() * A;
      const WhitenedRows w = whitened_rows(system, X_WT);
      EXPECT_EQ(w.exact.rows(), 0);
      EXPECT_LT((w.rows.transpose() * w.rows - S).norm(), 1e-9 * S.norm())
          << static_cast<int>(pose) << " " << static_cast<int>(span);
    }
  }
}

// R = n nᵀ has noise along n alone: (n·z)/|n|² is noisy, what is normal to n exact.
TEST(Rows, DirectionsWithoutNoiseAreExact) {
  std::mt19937_64 random(4);
  const MatrixXd H = random_matrix(random, 3, 3);
  const Eigen::Vector3d n(1, 2, -2);
  const System system = system_of(PoseState::pose, 1, Span::point, H, n * n.transpose(),
                                  random_pose(random));
  const TargetPose X_WT = random_pose(random);
  const MatrixXd A = rows_by_matrices(system, Span::point, H, X_WT);
  const WhitenedRows w = whitened_rows(system, X_WT);
  ASSERT_EQ(w.rows.rows(), 1);
  ASSERT_EQ(w.exact.rows(), 2);
  const Eigen::RowVectorXd noisy = n.transpose() / n.squaredNorm() * A;
  EXPECT_LT(std::min((w.rows - noisy).norm(), (w.rows + noisy).norm()), 1e-12);
  // Both are combinations c A with c n = 0: solve for c.
  const MatrixXd c =
      A.transpose().colPivHouseholderQr().solve(w.exact.transpose()).transpose();
  EXPECT_LT((c * A - w.exact).norm(), 1e-12);
  EXPECT_LT((c * n).norm(), 1e-12);
}

/// Sees points, and says so where one comes with an orientation.
class TestBarePoint final : public testing::TestRange {
 public:
  using TestRange::TestRange;
  bool observe(const Target& target, Observation& out) const override {
    EXPECT_TRUE(target.R_ST.isIdentity(0));
    return TestRange::observe(target, out);
  }
};

TEST(Rows, APointHasNoOrientationWhateverWasSeenBefore) {
  System system = system_of(PoseState::pose, 1, Span::pose, MatrixXd::Identity(6, 6),
                            MatrixXd::Identity(6, 6),
                            {rotation_from_rpy({0.1, 0.2, 0.3}), {0, 0, 0}});
  system.devices.push_back(
      testing::place("p", std::make_shared<TestBarePoint>(0.01), {}, 4));
  EXPECT_EQ(whitened_rows(system, {Eigen::Matrix3d::Identity(), {1, 2, 3}}).rows.rows(),
            7);
}

TEST(Rows, LanesHaveTheBytesOfScalars) {
  std::mt19937_64 random(5);
  StateLayout layout;
  for (const PoseState pose : kPoseStates) {
    layout.pose = pose;
    const Eigen::Matrix3d R = testing::random_rotation(random);
    // One vector a row.
    const MatrixXd h = random_matrix(random, kLanes, 3),
                   arm = random_matrix(random, kLanes, 3);
    double rows[kMaxCoordinates * kLanes];
    pull_row<kLanes>(layout, R, h.data(), arm.data(), rows);
    for (int l = 0; l < kLanes; ++l) {
      const Eigen::Vector3d h_l = h.row(l), arm_l = arm.row(l);
      double row[kMaxCoordinates];
      pull_row<1>(layout, R, h_l.data(), arm_l.data(), row);
      for (int i = 0; i < layout.coordinates(); ++i)
        EXPECT_EQ(row[i], rows[i * kLanes + l]);
    }
  }
}

// A device that reports four times a second, whose R is 2: 1/2 an update, 2 a second.
TEST(Rows, ContinuousFusionWeighsByTheRate) {
  System system = system_of(PoseState::position, 1, Span::point,
                            MatrixXd::Identity(1, 3), MatrixXd::Constant(1, 1, 2), {});
  for (const auto& [fusion, expected] :
       {std::pair{Fusion::stacked, 0.5}, std::pair{Fusion::continuous, 2.0}}) {
    system.fusion = fusion;
    const InformationLayers layers(system, {TargetPose{}});
    LayerBlock scratch;
    EXPECT_EQ(layers.block(0, scratch).total[0], expected);
  }
}

// Of one pose at a time, and of many side by side; beacons: beacon_test.cpp.
TEST(Rows, FourTimesTheNoiseIsAQuarterOfTheInformation) {
  std::mt19937_64 random(6);
  const std::shared_ptr<const Device> devices[] = {
      std::make_shared<testing::TestRange>(0.01),
      std::make_shared<testing::TestFullRange>(0.01),
      std::make_shared<testing::TestLinear>(Span::pose, random_matrix(random, 2, 6),
                                            MatrixXd::Identity(2, 2))};
  for (const auto& device : devices) {
    System system = testing::acoustic_system();
    system.devices = {testing::place("d", device, random_pose(random), 50)};
    const std::vector<TargetPose> poses = {random_pose(random)};
    InformationLayers layers(system, poses);
    LayerBlock scratch;
    const std::vector<double> before = layers.block(0, scratch).total;
    system.devices[0].noise = 4;
    EXPECT_EQ(layers.update(system), 1u);
    const std::vector<double> after = layers.block(0, scratch).total;
    EXPECT_GT(before[0], 0);
    for (std::size_t e = 0; e < before.size(); ++e)
      EXPECT_NEAR(4 * after[e], before[e], 1e-14 * std::abs(before[e]));
  }
}

}  // namespace
}  // namespace delos
