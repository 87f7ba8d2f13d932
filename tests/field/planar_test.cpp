// Targets that move in a level plane: x and y, or x, y and yaw.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "delos/field/point.h"
#include "delos/field/soft_field.h"
#include "delos/model/metric_table.h"
#include "support/rigs.h"

namespace delos {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using testing::chain_motion;
using testing::place;

/// The direction of a point in the device's x-y plane, of standard deviation `sigma`.
///
///     z = atan2(y, x),  ∂z/∂p = [−y, x, 0]/(x² + y²)
class TestBearing final : public Device {
 public:
  explicit TestBearing(double sigma) : sigma_(sigma) {}
  bool observe(const Target& target, Observation& out) const override {
    const double x = target.p_ST.x(), y = target.p_ST.y(), square = x * x + y * y;
    out.z.setConstant(1, std::atan2(y, x));
    out.H.resize(1, 3);
    out.H << -y / square, x / square, 0;
    out.R.setConstant(1, 1, sigma_ * sigma_);
    return true;
  }

 private:
  double sigma_;
};

constexpr double kSigma = 0.02;  // rad
constexpr double kR = 1e-4;      // of a range's law

struct Station {
  Vector3d p;
  double yaw;
  bool bearing;
};
const Station kStations[] = {{{0, 0, 1}, 0.3, true},
                             {{5, 0.5, 1}, -2, true},
                             {{2, 6, 2.5}, 0, false},
                             {{-1, 3, 0.2}, 1, false}};
constexpr double kRate = 20;

System stations(const MotionModel& motion) {
  System system;
  system.motion = motion;
  system.markers = {{0.3, -0.1, 0.2}, {-0.2, 0.1, 0}};
  for (const Station& s : kStations) {
    std::shared_ptr<const Device> device = std::make_shared<testing::TestRange>(kR);
    if (s.bearing) device = std::make_shared<TestBearing>(kSigma);
    system.devices.push_back(place("d" + std::to_string(system.devices.size()), device,
                                   {rotation_from_rpy({0, 0, s.yaw}), s.p}, kRate));
  }
  return system;
}

/// What a station reads of a marker of a target at (x, y), turned by yaw, at height z.
double reading(const Station& s, const Vector3d& marker, double z,
               const Vector3d& pose) {
  const double c = std::cos(pose.z()), n = std::sin(pose.z());
  const double x = pose.x() + c * marker.x() - n * marker.y() - s.p.x(),
               y = pose.y() + n * marker.x() + c * marker.y() - s.p.y(),
               h = z + marker.z() - s.p.z();
  return s.bearing ? std::atan2(y, x) - s.yaw : std::sqrt(x * x + y * y + h * h);
}

/// The steady covariance before an update, by the Kalman filter's own recursion run
/// until nothing changes, with rows by central differences of the readings.
MatrixXd recursion(const System& system, double z, const Vector3d& pose) {
  const int d = system.motion.layout.coordinates(), n = system.motion.layout.size();
  const int rows = 8;
  MatrixXd H = MatrixXd::Zero(rows, n), R = MatrixXd::Zero(rows, rows);
  int row = 0;
  for (const Station& s : kStations) {
    for (const Vector3d& marker : {system.markers[0].p, system.markers[1].p}) {
      for (int i = 0; i < d; ++i) {
        const Vector3d step = 1e-5 * Vector3d::Unit(i);
        H(row, i) =
            (reading(s, marker, z, pose + step) - reading(s, marker, z, pose - step)) /
            2e-5;
      }
      const double range = reading({s.p, 0, false}, marker, z, pose);
      R(row, row) = s.bearing ? kSigma * kSigma : kR * range * range;
      ++row;
    }
  }
  const auto [A, Q] = discretize(system.motion, 1 / kRate);
  MatrixXd P = MatrixXd::Identity(n, n);
  for (int i = 0; i < 4000; ++i) {
    const MatrixXd K = P * H.transpose() * (H * P * H.transpose() + R).inverse();
    P = (A * (P - K * H * P) * A.transpose() + Q).eval();
    P = ((P + P.transpose()) / 2).eval();
  }
  return P;
}

const Vector3d kPose(1.5, 2, 0.7);  // x, y, yaw
constexpr double kHeight = 0.4;
const TargetPose kTarget{rotation_from_rpy({0, 0, 0.7}), {1.5, 2, kHeight}};

TEST(Planar, BearingsAndRangesGiveTheFiltersOwnCovariance) {
  for (const PoseState state : {PoseState::planar, PoseState::planar_pose}) {
    for (int order = 1; order <= 3; ++order) {
      const CoordinateMatrix q =
          Vector3d(0.3, 0.2, 0.5).head(state == PoseState::planar ? 2 : 3).asDiagonal();
      const System system = stations(chain_motion(state, order, q));
      const MatrixXd expected = recursion(system, kHeight, kPose);
      for (const Solver solver : {Solver::spectral, Solver::doubling}) {
        const StateMatrix P = testing::state_at(system, kTarget, solver).prior;
        ASSERT_EQ(P.rows(), expected.rows());
        EXPECT_LT((P - expected).norm(), 1e-8 * expected.norm()) << order;
      }
    }
  }
}

/// A perfect reading at every update of what a plane's target can't do.
PlacedDevice pin(PoseState state) {
  MatrixXd H = MatrixXd::Zero(state == PoseState::position ? 1 : 3, 6);
  H(0, 2) = 1;
  if (state == PoseState::pose) H(1, 3) = H(2, 4) = 1;
  return place("pin",
               std::make_shared<testing::TestLinear>(
                   Span::pose, H, MatrixXd::Zero(H.rows(), H.rows())),
               {}, kRate);
}

void expect_block_of_space(PoseState planar, PoseState spatial, int order,
                           CovarianceKind kind) {
  const bool turns = planar == PoseState::planar_pose;
  CoordinateMatrix q2 = CoordinateMatrix::Identity(turns ? 3 : 2, turns ? 3 : 2);
  q2(0, 1) = q2(1, 0) = 0.4;
  CoordinateMatrix q3 = CoordinateMatrix::Identity(turns ? 6 : 3, turns ? 6 : 3);
  q3(0, 1) = q3(1, 0) = 0.4;
  System flat = stations(chain_motion(planar, order, q2)),
         space = stations(chain_motion(spatial, order, q3));
  flat.covariance = space.covariance = kind;
  space.devices.push_back(pin(spatial));
  // Each sample's target moves at its own height.
  const Samples samples = testing::points({{1, 2, 0.4}, {3, 1, 0}, {4, 5, 1.7}});
  const Orientations turned{{{0, 0, 0.7}}, OrientationRule::worst};
  std::vector<const char*> names = {"sigma_x", "sigma_y", "sigma_horizontal"};
  if (order > 1) names.push_back("sigma_vy");
  if (turns) names.push_back("sigma_yaw");
  for (const char* name : names) {
    const Field a =
        evaluate_field(flat, samples, turned, testing::metric_of(flat, name), {});
    const Field b =
        evaluate_field(space, samples, turned, testing::metric_of(space, name), {});
    for (std::size_t i = 0; i < a.value.size(); ++i) {
      ASSERT_TRUE(std::isfinite(b.value[i]));
      EXPECT_NEAR(a.value[i], b.value[i], 1e-9 * b.value[i]) << name << " " << i;
    }
  }
}

// In space with height, or height and tilt, read without noise at every update, which
// is the same for all that is known of the rest.
TEST(Planar, AFieldIsTheBlockOfOneInSpaceWhoseHeightIsKnown) {
  for (int order = 1; order <= 3; ++order) {
    expect_block_of_space(PoseState::planar, PoseState::position, order,
                          CovarianceKind::prior);
    expect_block_of_space(PoseState::planar_pose, PoseState::pose, order,
                          CovarianceKind::posterior);
  }
}

// A diagonal P of a plane: √(1 + 4), max, (1 + 16)^(1/4), 1 + 4, 1·4; yaw apart.
TEST(Planar, MetricsReadTheBlockOfTwo) {
  const StateLayout layout{PoseState::planar_pose, 1, {}};
  const StateMatrix P = Vector3d(1, 4, 9).asDiagonal();
  const auto value = [&](const char* name) {
    return metric_value(std::get<Metric>(parse_metric(name, layout)), layout, P);
  };
  EXPECT_DOUBLE_EQ(value("sigma_position"), std::sqrt(5.0));
  EXPECT_DOUBLE_EQ(value("sigma_horizontal"), std::sqrt(5.0));
  EXPECT_DOUBLE_EQ(value("sigma_orientation"), 3);
  EXPECT_DOUBLE_EQ(value("sigma_yaw"), 3);
  EXPECT_DOUBLE_EQ(value("eigmax"), 2);
  EXPECT_DOUBLE_EQ(value("eiglen"), std::pow(17, 0.25));
  EXPECT_DOUBLE_EQ(value("trace"), 5);
  EXPECT_DOUBLE_EQ(value("det"), 4);
  const auto unit = [&](const char* name) {
    return std::get<Metric>(parse_metric(name, layout)).unit;
  };
  EXPECT_EQ(unit("det"), "m^4");
  EXPECT_EQ(unit("mle"), "m^-2 rad^-1");
  EXPECT_EQ(unit("sigma_orientation"), "rad");
}

// The larger eigenvalue of [a, p; p, c] in any direction, by Eigen's solver.
TEST(Planar, TheWorstDirectionIsInThePlane) {
  const StateLayout layout{PoseState::planar, 1, {}};
  const Metric eigmax = std::get<Metric>(parse_metric("eigmax", layout));
  for (const double angle : {0.0, 0.3, 1.2, 2.9}) {
    for (const double ratio : {1.0, 1e-3, 1e-12}) {
      const Eigen::Matrix2d U = Eigen::Rotation2Dd(angle).toRotationMatrix();
      const Eigen::Matrix2d P =
          U * Eigen::Vector2d(3, 3 * ratio).asDiagonal() * U.transpose();
      EXPECT_NEAR(metric_value(eigmax, layout, P), std::sqrt(3.0), 1e-14);
    }
  }
}

// Searches: the slopes of a planar field with the places of devices, with levers.
TEST(Planar, SoftFieldsHaveSlopes) {
  for (const PoseState state : {PoseState::planar, PoseState::planar_pose}) {
    System system = testing::acoustic_system();
    const int d = state == PoseState::planar ? 2 : 3;
    system.motion = chain_motion(state, 2, CoordinateMatrix::Identity(d, d));
    system.markers = {{0.05, 0.1, 0}, {-0.1, 0, 0.05}};
    system.prior = 1;
    for (PlacedDevice& device : system.devices)
      device.device = std::make_shared<testing::TestFullRange>(0.005);
    const Samples samples = testing::points({{0.1, 0.3, 0}, {0.35, 0.2, 0.4}});
    for (const char* name : {"eigmax", "sigma_x"}) {
      const Metric metric = testing::metric_of(system, name);
      SoftField soft(samples, {}, {metric});
      soft.evaluate(system, 0.2);
      soft.adjoin({{1.0, 1.0}});
      const std::vector<PoseSlope> slopes = soft.pose_slopes();
      const auto sum = [&](const System& at) {
        SoftField other(samples, {}, {metric});
        const std::vector<double> values = other.evaluate(at, 0.2)[0];
        return values[0] + values[1];
      };
      for (std::size_t i = 0; i < system.devices.size(); ++i) {
        for (int k = 0; k < 3; ++k) {
          constexpr double kStep = 1e-5;
          System up = system, down = system;
          up.devices[i].X_WS().p(k) += kStep;
          down.devices[i].X_WS().p(k) -= kStep;
          EXPECT_NEAR(slopes[i](k), (sum(up) - sum(down)) / (2 * kStep),
                      1e-6 * slopes[i].norm());
        }
      }
    }
  }
}

// One range fixes one direction of two.
TEST(Planar, LosesTheDirectionThatNoDeviceReads) {
  System system =
      stations(chain_motion(PoseState::planar, 2, CoordinateMatrix::Identity(2, 2)));
  system.markers = {{0, 0, 0}};
  system.devices = {place("one", std::make_shared<testing::TestRange>(kR),
                          {Eigen::Matrix3d::Identity(), {0, 0, 3}}, kRate)};
  const PointReport report =
      evaluate_point(system, {Eigen::Matrix3d::Identity(), {2, 0, 0}},
                     testing::metric_of(system, "eigmax"));
  ASSERT_EQ(report.state.unobservable.cols(), 2);  // y and its velocity
  EXPECT_NEAR(report.state.unobservable.topRows(1).norm(), 0, 1e-12);
  EXPECT_EQ(report.state.unobservable.rows(), 4);
}

}  // namespace
}  // namespace delos
