// Trackers that aren't linear.
#include "simulation/simulated.h"

namespace delos::test {
namespace {

const TargetPose kInVolume{Eigen::Matrix3d::Identity(), {0.2, 0.2, 0.4}};

/// gaps of the plans, 7: at (0.2, 0.2, 0.4) of the acoustic scene with speakers 1.0485
/// m up σ is 41.7, 41.7, 14.9 mm and 288, 288, 133 mm/s before updates (SciPy's DARE).
TEST(Tracker, OfRangesReachesWhatIsPublishedOfIt) {
  const Simulation s =
      simulate(acoustic_system(), kInVolume, {.runs = 1500, .seed = 1, .seconds = 0.8});
  const SimulatedCovariance& c = s.covariances[0];
  const double sigma[] = {0.0417, 0.0417, 0.0149, 0.288, 0.288, 0.133};
  for (int k = 0; k < 6; ++k) {
    EXPECT_NEAR(std::sqrt(c.predicted(k, k)), sigma[k], 0.005 * sigma[k]);
    // Ranges of half a metre bend little over 42 mm: 3 % besides the scatter.
    const double error = c.error(k, k) / c.predicted(k, k);
    EXPECT_NEAR(c.measured(k, k) / c.predicted(k, k), 1, 0.06 + 4 * error) << k;
  }
  EXPECT_EQ(s.lost, 0u);
  EXPECT_EQ(s.coasting, 0u);
}

/// All speakers are in one plane: a target that came near it may be taken for its
/// mirror image, of which P∞ knows nothing. Such runs are counted, and the others are
/// right.
TEST(Tracker, CountsThoseThatFollowAMirrorImage) {
  const TargetPose below{Eigen::Matrix3d::Identity(), {0.2, 0.2, 0.85}};
  const Simulation s = simulate(acoustic_system(), below, {.runs = 500, .seed = 1});
  EXPECT_GT(s.lost, 3u);
  EXPECT_LT(s.lost, 250u);
  const SimulatedCovariance& c = s.covariances[0];
  EXPECT_NEAR(c.measured(0, 0) / c.predicted(0, 0), 1, 0.3);
}

/// A ten-thousandth of the noise, and nothing is left of curvature: NEES is in its
/// band.
TEST(Tracker, OfPreciseRangesIsConsistent) {
  System system = acoustic_system();
  for (PlacedDevice& placed : system.devices) placed.noise = 1e-4;
  for (const FilterKind kind : {FilterKind::extended, FilterKind::iterated,
                                FilterKind::sequential, FilterKind::unscented}) {
    const Simulation s = simulate(
        system, kInVolume, {.runs = 400, .seed = 6, .filter = kind, .seconds = 0.4});
    EXPECT_TRUE(s.instants.back().nees.inside())
        << to_string(kind) << " " << s.instants.back().nees.mean;
    EXPECT_TRUE(s.instants.back().nis.inside()) << to_string(kind);
  }
}

/// Where the range is as short as the error, the extended filter is too sure of itself:
/// NEES leaves its band.
TEST(Tracker, NearABeaconIsNotConsistent) {
  System system = acoustic_system(10);
  for (PlacedDevice& placed : system.devices) {
    placed.X_WS().p.z() = 0.45;
    placed.X_WS().p.head<2>() =
        0.2 * Eigen::Vector2d::Ones() +
        0.15 * (placed.X_WS().p.head<2>() - 0.2 * Eigen::Vector2d::Ones());
    placed.noise = 40;
  }
  const Simulation s = simulate(system, kInVolume, {.runs = 200, .seed = 6});
  EXPECT_FALSE(s.instants.back().nees.inside()) << s.instants.back().nees.mean;
}

/// A target that leaves the reach of all devices for a second and comes back.
TEST(Tracker, CoastsWhereNoDeviceSees) {
  System system = acoustic_system();
  for (PlacedDevice& placed : system.devices)
    placed.device = std::make_shared<TestRange>(0.005, 1.5);
  const GivenPath path{{0, 1, 1.5, 2.5, 3, 4},
                       {kInVolume.p,
                        kInVolume.p,
                        {2.5, 0.2, 0.4},
                        {2.5, 0.2, 0.4},
                        kInVolume.p,
                        kInVolume.p}};
  const Simulation s = simulate(system, kInVolume, {.runs = 8, .path = path});
  EXPECT_EQ(s.coasting, 8u);
  EXPECT_GT(s.longest_gap, 1);
  EXPECT_LT(s.longest_gap, 2);
  std::size_t blind = 0;
  for (const SimulatedInstant& at : s.instants) blind += at.seen == 0;
  EXPECT_NEAR(static_cast<double>(blind) * s.step, s.longest_gap, 1e-9);
  // What isn't observed has no P∞, and the filter says how little it knows.
  EXPECT_TRUE(std::isinf(s.instants[100].predicted(0)));
  EXPECT_GT(s.instants[120].filter(0), 10 * s.instants[49].filter(0));
}

/// A target that turns: two fixes of whole poses in space. About rest it is P∞'s model,
/// and turning at a few degrees an update leaves it so within a percent.
TEST(Tracker, OfPosesThatTurnReachesPInfinity) {
  class PoseFix final : public Device {
   public:
    Span span() const override { return Span::pose; }
    bool observe(const Target& t, Observation& out) const override {
      // The orientation by two of its columns, of which small turns are three numbers.
      out.z.resize(9);
      out.z << t.p_ST, t.R_ST.col(0), t.R_ST.col(1);
      out.H.setZero(9, 6);
      out.H.topLeftCorner(3, 3).setIdentity();
      for (int c = 0; c < 2; ++c) {
        const Eigen::Vector3d v = t.R_ST.col(c);
        out.H.block<3, 3>(3 + 3 * c, 3) << 0, v.z(), -v.y(), -v.z(), 0, v.x(), v.y(),
            -v.x(), 0;
      }
      out.R.setIdentity(9, 9);
      out.R *= 1e-6;
      return true;
    }
  };
  System system;
  CoordinateMatrix q = CoordinateMatrix::Identity(6, 6);
  system.motion = chain_motion(PoseState::pose, 2, q);
  system.markers = {Eigen::Vector3d::Zero()};
  std::mt19937_64 random(3);
  system.devices = {place("fix", std::make_shared<PoseFix>(),
                          {random_rotation(random), {0.3, 0.2, 0.1}}, 100)};
  const TargetPose about{random_rotation(random), {1, 2, 3}};
  const Simulation s = simulate(system, about, {.runs = 1000, .seed = 8});
  const SimulatedCovariance& c = s.covariances[0];
  for (int k = 0; k < 12; ++k)
    EXPECT_NEAR(c.measured(k, k) / c.predicted(k, k), 1,
                0.02 + 4.5 * c.error(k, k) / c.predicted(k, k))
        << k;
  EXPECT_NEAR(s.instants.back().nees.mean, 12, 0.8);
}

/// Beacons by chance: a device on the target that reads all of one at a time. Of equal
/// ones, whichever comes, the information is that of the mean.
TEST(Tracker, DrawsBeaconsByTheirShares) {
  class Fix final : public Device {
   public:
    bool observe(const Target& t, Observation& out) const override {
      out.z = t.p_ST;
      out.H.setIdentity(3, 3);
      out.R.setIdentity(3, 3);
      out.R *= 1e-3;
      return true;
    }
  };
  std::vector<Beacon> beacons(5);
  for (std::size_t i = 0; i < beacons.size(); ++i)
    beacons[i].p = {static_cast<double>(i), 1, 2};
  for (const SightingRule rule :
       {SightingRule::mean, SightingRule::random, SightingRule::nearest}) {
    System system = moving(1, {});
    PlacedDevice device = place("d", std::make_shared<Fix>(), {}, 50);
    device.mount =
        TargetMount{{}, std::make_shared<const BeaconIndex>(beacons), {}, rule, 2};
    system.devices = {device};
    const Simulation s = simulate(system, kOrigin, {.runs = 1000, .seed = 2});
    expect_predicted(s);
    EXPECT_EQ(s.instants.back().nis.expected, 6);  // two beacons of three rows
  }
}

}  // namespace
}  // namespace delos::test
