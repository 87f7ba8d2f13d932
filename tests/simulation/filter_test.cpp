// Filters against a textbook's, and wrong ones that tests must notice.
#include <Eigen/Geometry>
#include <Eigen/LU>

#include "simulation/simulated.h"

namespace delos::test {
namespace {

/// What a textbook's filter does wrong.
enum class Mistake { none, nis_by_S, nis_after, no_gain, too_modest, too_sure };

/// The extended Kalman filter with all readings in one vector and plain inverses.
class TextbookFilter final : public TrackFilter {
 public:
  explicit TextbookFilter(Mistake mistake = Mistake::none) : mistake_(mistake) {}

  Innovation update(const ReadingModel& model, std::span<const TrackReading> readings,
                    TrackEstimate& e) const override {
    const Eigen::Index n = e.x.size();
    Eigen::MatrixXd H(0, n), R(0, 0);
    Eigen::VectorXd nu(0);
    Innovation out;
    PredictedReading p;
    for (const TrackReading& reading : readings) {
      if (!model.predict(reading, e.x, e.R, p)) continue;
      const Eigen::Index m = H.rows(), more = p.z.size();
      H.conservativeResize(m + more, n);
      H.bottomRows(more) = p.H;
      R.conservativeResize(m + more, m + more);
      R.rightCols(more).setZero();
      R.bottomRows(more).setZero();
      R.bottomRightCorner(more, more) = p.R;
      nu.conservativeResize(m + more);
      nu.tail(more) = reading.z - p.z;
    }
    if (nu.size() == 0) return out;
    Eigen::MatrixXd P = e.P;
    const Eigen::MatrixXd S = H * P * H.transpose() + R;
    const Eigen::MatrixXd K = P * H.transpose() * S.inverse();
    const Eigen::MatrixXd after = P - K * H * P;
    Eigen::MatrixXd weight = S.inverse();
    if (mistake_ == Mistake::nis_by_S) weight = S;
    if (mistake_ == Mistake::nis_after)
      weight = (H * after * H.transpose() + R).inverse();
    out.nis = nu.dot(weight * nu);
    out.rows = static_cast<int>(nu.size());
    const Eigen::VectorXd change = K * nu;
    if (mistake_ != Mistake::no_gain)
      move_state(model.system().motion.layout, StateVector(change), e.x, e.R);
    e.P = (after + after.transpose()) / 2;
    if (mistake_ == Mistake::too_modest) e.P *= 1.1;
    if (mistake_ == Mistake::too_sure) e.P *= 0.9;
    return out;
  }

 private:
  Mistake mistake_;
};

System fixes() {
  return moving(2, {axis(0, 1e-3, 50), axis(1, 4e-3, 50), axis(2, 1e-3, 50)});
}

Simulation by(const TrackFilter& filter, const System& system = fixes()) {
  return simulate(system, kOrigin, {.runs = 600, .seed = 5, .own_filter = &filter});
}

TEST(Filters, ExtendedIsTheTextbooks) {
  const System system = acoustic_system();
  const TargetPose pose{Eigen::Matrix3d::Identity(), {0.1, 0.2, 0.4}};
  const TextbookFilter textbook;
  SimulationOptions options{.runs = 32, .seed = 2, .seconds = 1};
  const Simulation own = simulate(system, pose, options);
  options.own_filter = &textbook;
  const Simulation other = simulate(system, pose, options);
  for (std::size_t i = 0; i < own.instants.size(); ++i) {
    EXPECT_NEAR(own.instants[i].square.sum(), other.instants[i].square.sum(),
                1e-9 * other.instants[i].square.sum());
    EXPECT_NEAR(own.instants[i].nis.mean, other.instants[i].nis.mean, 1e-8);
    EXPECT_NEAR(own.instants[i].nees.mean, other.instants[i].nees.mean, 1e-8);
  }
}

TEST(Filters, AllAreOneWhereAllIsLinear) {
  const System system = fixes();
  SimulationOptions options{.runs = 16, .seed = 9, .seconds = 0.5};
  const Simulation extended = simulate(system, kOrigin, options);
  for (const FilterKind kind :
       {FilterKind::iterated, FilterKind::sequential, FilterKind::unscented}) {
    options.filter = kind;
    const Simulation s = simulate(system, kOrigin, options);
    const StateMatrix &a = s.covariances[0].measured,
                      &b = extended.covariances[0].measured;
    EXPECT_LT((a - b).norm(), 1e-9 * b.norm()) << to_string(kind);
    EXPECT_NEAR(s.instants.back().nis.mean, extended.instants.back().nis.mean, 1e-9)
        << to_string(kind);
  }
}

TEST(Filters, ThatAreRightPass) {
  const Simulation s = by(TextbookFilter());
  expect_predicted(s);
  EXPECT_TRUE(s.instants.back().nees.inside());
  EXPECT_TRUE(s.instants.back().nis.inside());
}

TEST(Filters, ThatWeighInnovationsByTheirCovarianceAreNoticed) {
  EXPECT_FALSE(by(TextbookFilter(Mistake::nis_by_S)).instants.back().nis.inside());
}

TEST(Filters, ThatTakeTheCovarianceAfterTheUpdateAreNoticed) {
  const Simulation s = by(TextbookFilter(Mistake::nis_after));
  EXPECT_FALSE(s.instants.back().nis.inside());
  EXPECT_TRUE(s.instants.back().nees.inside());  // what it estimates is right
}

TEST(Filters, ThatDontUseTheirReadingsAreNoticed) {
  const Simulation s = by(TextbookFilter(Mistake::no_gain));
  EXPECT_GT(s.lost, s.runs / 2);
}

/// A one-sided test would pass it.
TEST(Filters, ThatAreTooModestAreNoticed) {
  const Simulation s = by(TextbookFilter(Mistake::too_modest));
  EXPECT_LT(s.instants.back().nees.mean, s.instants.back().nees.lower);
}

TEST(Filters, ThatAreTooSureAreNoticed) {
  const Simulation s = by(TextbookFilter(Mistake::too_sure));
  EXPECT_GT(s.instants.back().nees.mean, s.instants.back().nees.upper);
}

/// Bearings of what stands at ±180° of three of them, one of which is below the others.
System bearings(bool come_back) {
  System system = moving(1, {axis(2, 1e-4, 50)});
  for (const Eigen::Vector3d& p :
       {Eigen::Vector3d(3, 0, 0), Eigen::Vector3d(4, 2, 0), Eigen::Vector3d(4, -2, 0)})
    system.devices.push_back(
        place("b", std::make_shared<TestBearing>(0.01, come_back),
              {Eigen::AngleAxisd(std::atan2(p.y(), p.x()), Eigen::Vector3d::UnitZ())
                   .toRotationMatrix(),
               p},
              50));
  return system;
}

TEST(Filters, TakeAnglesAcrossTheirSeamForNeighbours) {
  for (const FilterKind kind : {FilterKind::extended, FilterKind::iterated,
                                FilterKind::sequential, FilterKind::unscented}) {
    const SimulationOptions options{.runs = 400, .seed = 4, .filter = kind};
    const Simulation s = simulate(bearings(true), kOrigin, options);
    EXPECT_EQ(s.lost, 0u) << to_string(kind);
    expect_predicted(s);
    EXPECT_TRUE(s.instants.back().nis.inside()) << to_string(kind);
    // What is left at the seam is 2π, where nobody says that they come back.
    EXPECT_GT(simulate(bearings(false), kOrigin, options).lost, 100u);
  }
}

/// A sensor of all that moves, on an arm of a target that moves and turns: Jacobians
/// against central differences.
TEST(Filters, JacobiansOfMovingSensorsEqualDifferences) {
  System system;
  CoordinateMatrix q = CoordinateMatrix::Identity(6, 6);
  system.motion = chain_motion(PoseState::pose, 3, q);
  system.markers = {Eigen::Vector3d::Zero()};
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  class Motion18 final : public Device {
   public:
    Span span() const override { return Span::motion; }
    bool observe(const Target& t, Observation& out) const override {
      out.z.resize(12);
      out.z << t.velocity, t.acceleration;
      out.H.setZero(12, 18);
      out.H.rightCols(12).setIdentity();
      out.R.setIdentity(12, 12);
      return true;
    }
  };
  PlacedDevice sensor = place("s", std::make_shared<Motion18>(), {}, 50);
  sensor.mount = TargetMount{{random_rotation(random), {0.1, -0.2, 0.3}},
                             std::make_shared<const BeaconIndex>(std::vector<Beacon>{}),
                             {},
                             SightingRule::all,
                             1};
  system.devices = {sensor};
  const TargetPose about{random_rotation(random), {1, 2, 3}};
  const ReadingModel model(system, about, 18);
  StateVector x(18);
  for (double& number : x) number = normal(random);
  TrackReading reading;
  reading.block = {0, 18};
  PredictedReading at, ahead, behind;
  ASSERT_TRUE(model.predict(reading, x, about.R, at));
  for (int k = 0; k < 18; ++k) {
    constexpr double kStep = 1e-5;
    StateVector change = StateVector::Zero(18);
    for (const double sign : {1.0, -1.0}) {
      StateVector moved = x;
      Eigen::Matrix3d R = about.R;
      change(k) = sign * kStep;
      move_state(system.motion.layout, change, moved, R);
      ASSERT_TRUE(model.predict(reading, moved, R, sign > 0 ? ahead : behind));
    }
    const Eigen::VectorXd slope = (ahead.z - behind.z) / (2 * kStep);
    EXPECT_LT((slope - at.H.col(k)).norm(), 1e-8) << k;
  }
}

}  // namespace
}  // namespace delos::test
