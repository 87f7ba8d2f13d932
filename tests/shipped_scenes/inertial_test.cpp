// Sensors of the target's own motion, and states of the devices' own.
#include <Eigen/LU>
#include <sstream>

#include "delos/field/point.h"
#include "shipped_scenes/shipped.h"

namespace delos::test {
namespace {

/// P∞ before or after an update of x⁺ = A x + w, z = H x + v, by a long iteration.
Eigen::MatrixXd iterated(const Eigen::MatrixXd& A, const Eigen::MatrixXd& Q,
                         const Eigen::MatrixXd& H, const Eigen::MatrixXd& R) {
  Eigen::MatrixXd P = Q;
  for (int i = 0; i < 60'000; ++i) {
    const Eigen::MatrixXd S = H * P * H.transpose() + R;
    const Eigen::MatrixXd after = P - P * H.transpose() * S.inverse() * H * P;
    P = A * after * A.transpose() + Q;
    P = (P + P.transpose().eval()) / 2;
  }
  return P;
}

/// The devices of the build, and that of docs/plugins.md.
PluginRegistry& with_biased_beacon() {
  static PluginRegistry registry({DELOS_PLUGINS, DELOS_TEST_PLUGINS});
  return registry;
}

FusedState state_at(const std::string& text, const Pose& pose) {
  Diagnostics findings;
  const auto scene = parse_scene(text, "s.yaml", {}, with_biased_beacon(), findings);
  for (const Diagnostic& finding : findings) ADD_FAILURE() << to_string(finding);
  const System system = build_system(scene.value(), with_biased_beacon());
  const auto trace = std::get<Metric>(parse_metric("trace", scene->motion.layout));
  return evaluate_point(system, pose, trace).state;
}

StateMatrix prior_at(const std::string& text, const Pose& pose = {}) {
  return state_at(text, pose).prior;
}

/// What a single reading knows.
StateMatrix single_at(const std::string& text, const Pose& pose) {
  return state_at(text, pose).posterior;
}

/// Position at 30 Hz, R = 1e-6 m², under PVA with q = 100 m²/s⁵, continuous.
std::string position_fix(const std::string& more) {
  return "delos: 1\n"
         "motion: {type: position_velocity_acceleration, q: [100, 100, 100]}\n"
         "fusion: continuous\n"
         "sample: {points: [[0, 0, 0]]}\n"
         "devices:\n"
         "  - {name: fix, type: linear, rate: 30, params: {"
         "H: [[1,0,0,0,0,0,0,0,0], [0,1,0,0,0,0,0,0,0], [0,0,1,0,0,0,0,0,0]], "
         "R: [[1e-6,0,0],[0,1e-6,0],[0,0,1e-6]]}}\n" +
         more;
}

// By SciPy's solve_continuous_are, an axis each: R = 1e-6/30 m²s and 1e-2/100 (m/s²)²s.
TEST(Accelerometer, SharpensAPositionFix) {
  const auto expect = [](const std::string& more, double p, double v, double a) {
    const StateMatrix P = prior_at(position_fix(more));
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(std::sqrt(P(i, i)), p, 1e-6 * p) << more;
      EXPECT_NEAR(std::sqrt(P(3 + i, 3 + i)), v, 1e-5 * v) << more;
      EXPECT_NEAR(std::sqrt(P(6 + i, 6 + i)), a, 1e-5 * a) << more;
    }
  };
  const std::string accelerometer =
      "  - {name: imu, type: accelerometer, mount: target, rate: 100, params: {sigma: "
      "0.1}";
  expect("", 1.591162e-3, 74.0083e-3, 2.294853);
  expect(accelerometer + "}\n", 0.590655e-3, 4.37134e-3, 0.316228);
  expect(accelerometer + ", rpy: [0.3, -1.1, 2]}\n", 0.590655e-3, 4.37134e-3, 0.316228);
}

/// One axis of a fix and an accelerometer at 50 Hz whose bias drifts: x = [p v a b].
struct BiasedAxis {
  double dt = 0.02, q = 4, r_fix = 1e-6, r = 0.01, bias = 0.2, time = 5;
  [[nodiscard]] Eigen::MatrixXd covariance() const {
    const double a = std::exp(-dt / time);
    Eigen::Matrix4d A, Q = Eigen::Matrix4d::Zero();
    A << 1, dt, dt * dt / 2, 0, 0, 1, dt, 0, 0, 0, 1, 0, 0, 0, 0, a;
    Q.topLeftCorner<3, 3>() << std::pow(dt, 5) / 20, std::pow(dt, 4) / 8,
        std::pow(dt, 3) / 6, std::pow(dt, 4) / 8, std::pow(dt, 3) / 3, dt * dt / 2,
        std::pow(dt, 3) / 6, dt * dt / 2, dt;
    Q *= q;
    // What keeps b at its standard deviation.
    Q(3, 3) = bias * bias * (1 - a * a);
    Eigen::Matrix<double, 2, 4> H;
    H << 1, 0, 0, 0, 0, 0, 1, 1;
    return iterated(A, Q, H, Eigen::Vector2d(r_fix, r).asDiagonal());
  }
};

std::string biased_room(const std::string& imu) {
  return "delos: 1\n"
         "motion: {type: position_velocity_acceleration, q: [4, 4, 4]}\n"
         "sample: {points: [[0, 0, 0]]}\n"
         "devices:\n"
         "  - {name: fix, type: linear, rate: 50, params: {"
         "H: [[1,0,0,0,0,0,0,0,0], [0,1,0,0,0,0,0,0,0], [0,0,1,0,0,0,0,0,0]], "
         "R: [[1e-6,0,0],[0,1e-6,0],[0,0,1e-6]]}}\n"
         "  - {name: imu, type: accelerometer, mount: target, rate: 50, " +
         imu + "}\n";
}

TEST(Accelerometer, HasABiasThatTheFilterEstimates) {
  const Eigen::MatrixXd axis = BiasedAxis().covariance();
  const StateMatrix P =
      prior_at(biased_room("params: {sigma: 0.1, bias: 0.2, bias_time: 5}"));
  ASSERT_EQ(P.rows(), 12);
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 4; ++k)
      for (int j = 0; j < 4; ++j)
        EXPECT_NEAR(P(3 * k + i, 3 * j + i), axis(k, j),
                    1e-8 * std::sqrt(axis(k, k) * axis(j, j)))
            << i << k << j;
  // The bias is along the sensor's axes; the motion knows no turn of those.
  const StateMatrix turned = prior_at(
      biased_room("rpy: [1, 0.4, -2], params: {sigma: 0.1, bias: 0.2, bias_time: 5}"));
  const Eigen::MatrixXd of_motion = P.topLeftCorner(9, 9);
  EXPECT_LT((turned.topLeftCorner(9, 9) - of_motion).norm(), 1e-9 * of_motion.norm());
}

// On an arm l, the sensor feels a + α × l, along its own axes, and turns with ω: rows
// of `linear` written by hand.
TEST(InertialSensors, FeelWhatTheirArmAdds) {
  const Pose sensor{rotation_from_rpy({0.2, -0.7, 1.3}), {0.3, -0.2, 0.5}};
  const Pose target{rotation_from_rpy({-0.4, 0.9, 0.1}), {1, 2, 3}};
  const Eigen::Matrix3d R_SW = (target.R * sensor.R).transpose();
  const Eigen::Vector3d arm = target.R * sensor.p;
  Eigen::Matrix3d cross;  // arm ×
  cross << 0, -arm.z(), arm.y(), arm.z(), 0, -arm.x(), -arm.y(), arm.x(), 0;
  Eigen::Matrix<double, 6, 18> H = Eigen::Matrix<double, 6, 18>::Zero();
  H.block<3, 3>(0, 9) = R_SW;            // ω
  H.block<3, 3>(3, 12) = R_SW;           // a
  H.block<3, 3>(3, 15) = -R_SW * cross;  // α × l = −l × α
  const auto room = [](const std::string& devices) {
    return "delos: 1\n"
           "motion: {type: position_velocity_acceleration, state: pose, q: [4, 4, 4, "
           "2, 2, 2]}\n"
           "sample: {points: [[0, 0, 0]]}\n"
           "devices:\n"
           "  - {name: fix, type: linear, rate: 50, params: {"
           "H: [[1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0], "
           "[0,1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0], "
           "[0,0,1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0], "
           "[0,0,0,1,0,0,0,0,0,0,0,0,0,0,0,0,0,0], "
           "[0,0,0,0,1,0,0,0,0,0,0,0,0,0,0,0,0,0], "
           "[0,0,0,0,0,1,0,0,0,0,0,0,0,0,0,0,0,0]], "
           "R: [[1e-6,0,0,0,0,0],[0,1e-6,0,0,0,0],[0,0,1e-6,0,0,0],"
           "[0,0,0,1e-5,0,0],[0,0,0,0,1e-5,0],[0,0,0,0,0,1e-5]]}}\n" +
           devices;
  };
  std::ostringstream by_hand;
  by_hand.precision(17);
  by_hand << "  - {name: imu, type: linear, rate: 50, params: {H: [";
  for (int r = 0; r < 6; ++r) {
    by_hand << (r ? ", [" : "[");
    for (int c = 0; c < 18; ++c) by_hand << (c ? "," : "") << H(r, c);
    by_hand << ']';
  }
  by_hand << "], R: [[1e-4,0,0,0,0,0],[0,1e-4,0,0,0,0],[0,0,1e-4,0,0,0],"
             "[0,0,0,4e-4,0,0],[0,0,0,0,4e-4,0],[0,0,0,0,0,4e-4]]}}\n";
  const std::string place =
      "mount: target, rate: 50, at: [0.3, -0.2, 0.5], "
      "rpy: [0.2, -0.7, 1.3], params: ";
  const StateMatrix P =
      prior_at(room("  - {name: g, type: gyroscope, " + place +
                    "{sigma: 0.01}}\n  - {name: a, type: accelerometer, " + place +
                    "{sigma: 0.02}}\n"),
               target);
  const StateMatrix expected = prior_at(room(by_hand.str()), target);
  ASSERT_EQ(P.rows(), 18);
  EXPECT_LT((P - expected).norm(), 1e-10 * expected.norm());
}

// What scenes/19-inertial-camera.yaml says of itself; sensors of endless noise are
// none.
TEST(InertialSensors, ThreefoldTheAccuracyOfTwoCameras) {
  const auto mean = [](const std::vector<Override>& changes) {
    const Field field = field_of("19-inertial-camera", changes);
    double sum = 0;
    for (const double value : field.value) sum += value;
    return sum / static_cast<double>(field.value.size());
  };
  EXPECT_NEAR(mean({}), 269e-6, 0.5e-6);
  EXPECT_NEAR(mean({{"devices.accel.params.sigma", "1e6"},
                    {"devices.gyro.params.sigma", "1e6"}}),
              823e-6, 0.5e-6);
}

// A walk of density K² is a bias that forgets in T → ∞ with 2 bias²/T = K²; a reading
// of density N at f a second has the variance N² f.
TEST(Imu, IsAGyroscopeAndAnAccelerometer) {
  const std::string one =
      "  - {name: imu, type: imu, mount: target, at: [0.1, 0, 0.2], rpy: [0.3, 0.1, "
      "2], "
      "rate: 100, params: {readings: 100, rate_noise: 1e-4, rate_walk: 1e-3, "
      "acceleration_noise: 2e-3, acceleration_walk: 3e-3}}\n";
  const std::string two =
      "  - {name: g, type: gyroscope, mount: target, at: [0.1, 0, 0.2], rpy: [0.3, "
      "0.1, "
      "2], rate: 100, params: {sigma: 1e-3, bias: 22.360679774997898, bias_time: "
      "1e9}}\n"
      "  - {name: a, type: accelerometer, mount: target, at: [0.1, 0, 0.2], rpy: [0.3, "
      "0.1, 2], rate: 100, params: {sigma: 0.02, bias: 67.0820393249937, bias_time: "
      "1e9}}\n";
  const auto P = [](const std::string& devices) {
    return prior_at(
        "delos: 1\nmotion: {type: position_velocity_acceleration, state: pose, q: [9, "
        "9, 9, 5, 5, 5]}\nsample: {points: [[0, 0, 0]]}\n"
        "target: {markers: [[0, 0, 0], [0.2, 0, 0], [0, 0.2, 0], [0, 0, 0.2]]}\n"
        "devices:\n"
        "  - {name: r1, type: uwb_range, rate: 100, at: [5, 0, 0]}\n"
        "  - {name: r2, type: uwb_range, rate: 100, at: [0, 5, 0]}\n"
        "  - {name: r3, type: uwb_range, rate: 100, at: [0, 0, 5]}\n"
        "  - {name: r4, type: uwb_range, rate: 100, at: [-5, -5, -5]}\n" +
        devices);
  };
  const StateMatrix of_one = P(one), of_two = P(two);
  ASSERT_EQ(of_one.rows(), 24);
  EXPECT_LT((of_one - of_two).norm(), 1e-5 * of_two.norm());
}

// z = ‖p‖ + b: each of five beacons has a bias of its own.
TEST(OwnStates, OfARangeAreEstimatedWithThePlace) {
  const Eigen::Vector3d at[] = {
      {0, 0, 2.5}, {6, 0, 2.2}, {6, 5, 2.7}, {0, 5, 0.3}, {3, 2, 3}};
  const Eigen::Vector3d p{2, 1.5, 1};
  std::ostringstream text;
  text << "delos: 1\nmotion: {type: position_velocity, q: [0.3, 0.3, 0.3]}\n"
          "sample: {points: [[2, 1.5, 1]]}\ndevices:\n";
  Eigen::Matrix<double, 5, 11> H = Eigen::Matrix<double, 5, 11>::Zero();
  for (int i = 0; i < 5; ++i) {
    text << "  - {name: b" << i << ", type: biased_beacon, rate: 20, at: [" << at[i].x()
         << ", " << at[i].y() << ", " << at[i].z()
         << "], params: {sigma: 0.05, bias: 0.1, time: 60}}\n";
    H.block<1, 3>(i, 0) = (p - at[i]).normalized().transpose();
    H(i, 6 + i) = 1;
  }
  const double dt = 0.05, a = std::exp(-dt / 60);
  Eigen::MatrixXd A = Eigen::MatrixXd::Identity(11, 11), Q = 0 * A;
  for (int i = 0; i < 3; ++i) {
    A(i, 3 + i) = dt;
    Q(i, i) = 0.3 * dt * dt * dt / 3;
    Q(i, 3 + i) = Q(3 + i, i) = 0.3 * dt * dt / 2;
    Q(3 + i, 3 + i) = 0.3 * dt;
  }
  A.bottomRightCorner(5, 5) *= a;
  Q.bottomRightCorner(5, 5).diagonal().setConstant(0.01 * (1 - a * a));
  const Eigen::MatrixXd expected =
      iterated(A, Q, H, 0.0025 * Eigen::MatrixXd::Identity(5, 5));
  const StateMatrix P = prior_at(text.str(), {Eigen::Matrix3d::Identity(), p});
  ASSERT_EQ(P.rows(), 11);
  EXPECT_LT((P - expected).norm(), 1e-8 * expected.norm());
}

// Nothing is known before a single reading, neither place nor bias: a biased beacon
// that sees one marker says nothing of the place, and one that sees two says how much
// farther one is than the other. Its bias is what it reads less what the others know.
TEST(OwnStates, OfASingleReadingAreSolvedForBesideThePlace) {
  const Eigen::Vector3d at[] = {{0, 0, 2.5}, {6, 0, 2.2}, {6, 5, 0.3}};
  const Eigen::Vector3d p{2, 1.5, 1}, biased{0, 5, 2}, marker{0.5, 0, 0.2};
  const double r = 0.05 * 0.05;
  const auto text = [&](const std::string& markers, bool with_biased) {
    std::ostringstream scene;
    scene << "delos: 1\nmotion: {type: position_velocity, q: [0.3, 0.3, 0.3]}\n"
             "covariance: single\nsample: {points: [[2, 1.5, 1]]}\n"
             "target: {markers: "
          << markers << "}\ndevices:\n";
    for (const Eigen::Vector3d& a : at)
      scene << "  - {name: r" << &a - at << ", type: uwb_range, rate: 20, at: ["
            << a.x() << ", " << a.y() << ", " << a.z() << "], params: {sigma: 5 cm}}\n";
    if (with_biased)
      scene << "  - {name: b, type: biased_beacon, rate: 20, at: [0, 5, 2], params: "
               "{sigma: 0.05, bias: 0.1, time: 60}}\n";
    return scene.str();
  };
  const Pose pose{Eigen::Matrix3d::Identity(), p};
  const StateMatrix alone = single_at(text("[[0, 0, 0]]", false), pose),
                    with = single_at(text("[[0, 0, 0]]", true), pose);
  ASSERT_EQ(with.rows(), 4);
  EXPECT_LT((with.topLeftCorner(3, 3) - alone).norm(), 1e-10 * alone.norm());
  const Eigen::Vector3d h = (p - biased).normalized();
  EXPECT_NEAR(with(3, 3), r + h.dot(alone * h), 1e-10 * with(3, 3));

  const std::string two = "[[0, 0, 0], [0.5, 0, 0.2]]";
  const StateMatrix both = single_at(text(two, false), pose),
                    more = single_at(text(two, true), pose);
  const Eigen::Vector3d d = (p + marker - biased).normalized() - h;
  const Eigen::Matrix3d expected =
      (both.inverse() + d * d.transpose() / (2 * r)).inverse();
  EXPECT_LT((more.topLeftCorner(3, 3) - expected).norm(), 1e-10 * expected.norm());
}

// Whoever forgets the mount is told so, and where; what it then measures is defined.
TEST(InertialSensors, InTheRoomAreAskedAbout) {
  for (const std::string id : {"accelerometer", "gyroscope"}) {
    Diagnostics found;
    const auto scene = parse_scene(
        "delos: 1\nmotion: {type: position_velocity_acceleration, state: pose, q: [1, "
        "1, 1, 1, 1, 1]}\nsample: {points: [[0, 0, 0]]}\ndevices:\n"
        "  - {name: a, type: " +
            id + ", rate: 50, params: {sigma: 1}}\n",
        "s.yaml", {}, plugins(), found);
    EXPECT_TRUE(scene);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].severity, Severity::warning);
    EXPECT_EQ(to_string(found[0]),
              "s.yaml:5:5: warning: devices.a: stands in the room and measures the "
              "target's motion along its own axes there; if the target carries " +
                  id + ", give 'mount: target'");
  }
}

TEST(InertialSensors, AreRefusedWhereTheyMeasureNothing) {
  const auto refusal = [](const std::string& motion, const std::string& device) {
    Diagnostics found;
    (void)parse_scene("delos: 1\nmotion: " + motion +
                          "\nsample: {points: [[0, 0, 0]]}\ndevices:\n  - " + device +
                          "\n",
                      "s.yaml", {}, plugins(), found);
    std::string all;
    for (const Diagnostic& d : found) all += to_string(d) + '\n';
    return all;
  };
  EXPECT_EQ(refusal("{type: position_velocity, q: [1, 1, 1]}",
                    "{name: a, type: accelerometer, mount: target, rate: 50, params: "
                    "{sigma: 1}}"),
            "s.yaml:5:5: error: devices.a: accelerometer measures none of this "
            "motion's states: x, y, z, vx, vy, vz\n");
  EXPECT_EQ(refusal("{type: position_velocity, q: [1, 1, 1]}",
                    "{name: l, type: linear, mount: target, rate: 50, params: {H: "
                    "[[1, 0, 0, 0, 0, 0]], R: [[1]]}}"),
            "s.yaml:5:36: error: devices.l.mount: linear measures the state, wherever "
            "it is mounted; leave 'mount' out\n");
  EXPECT_EQ(refusal("{type: position_velocity_acceleration, q: [1, 1, 1]}",
                    "{name: a, type: accelerometer, mount: target, beacons: sky, rate: "
                    "50, params: {sigma: 1}}"),
            "s.yaml:5:60: error: devices.a.beacons: is for a device that looks at "
            "beacons; accelerometer measures how the target moves\n");
  EXPECT_EQ(refusal("{type: position_velocity_acceleration, q: [1, 1, 1]}",
                    "{name: a, type: accelerometer, mount: target, rate: 50, params: "
                    "{sigma: 1, bias: 1}}\n  - {name: u, type: uwb_range, rate: 50, "
                    "exposure: 1 ms}"),
            "s.yaml:5:3: error: devices: have states of their own, such as biases and "
            "clocks, and an exposure, which aren't solved for together; leave one of "
            "them out\n");
  std::string many;
  for (int i = 0; i < 8; ++i)
    many += (i ? "\n  - " : "") + std::string("{name: a") + std::to_string(i) +
            ", type: accelerometer, mount: target, rate: 50, params: {sigma: 1, bias: "
            "1}}";
  EXPECT_EQ(refusal("{type: position_velocity_acceleration, q: [1, 1, 1]}", many),
            "s.yaml:5:3: error: devices: have 24 states of their own, which make 33 "
            "with those of the motion; at most 30 can be estimated\n");
}

}  // namespace
}  // namespace delos::test
