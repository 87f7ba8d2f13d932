// Base stations and the noise that the photodiodes of a deck have in common.
#include <Eigen/LU>
#include <numbers>

#include "shipped_scenes/shipped.h"

namespace delos::test {
namespace {

/// Two base stations over a deck of four photodiodes.
std::string stations(const std::string& params, const std::string& state,
                     const std::string& markers) {
  return "delos: 1\nmotion: {type: position, state: " + state + ", q: [1, 1, 1" +
         (state == "pose" ? ", 1, 1, 1" : "") +
         "]}\ncovariance: single\nmetric: sigma_position\n"
         "sample: {points: [[0.3, -0.2, 0.7], [1, 0.5, 1.2], [-0.8, 0.6, 0.2]]}\n"
         "orientations: {rpy: [[0.1, -0.2, 0.5]]}\n"
         "target: {markers: " +
         markers +
         "}\n"
         "devices:\n"
         "  - {name: a, type: lighthouse, rate: 50, at: [2, 2, 2.4], aim: [0, 0, 0.5], "
         "params: &p " +
         params +
         "}\n"
         "  - {name: b, type: lighthouse, rate: 50, at: [-2, 1.5, 2.2], aim: [0, 0, "
         "0.5], "
         "params: *p}\n";
}

const char* const kDeck =
    "[[0.015, 0.0075, 0], [0.015, -0.0075, 0], [-0.015, 0.0075, 0], [-0.015, -0.0075, "
    "0]]";

/// (Hᵀ R⁻¹ H)⁻¹ of all rows at once: R of each station is σ²((1 − c) I + c 11ᵀ) for
/// each of its two angles.
Eigen::MatrixXd all_at_once(const System& system, const Pose& X_WT, double sigma,
                            double common, int columns) {
  Eigen::MatrixXd S = Eigen::MatrixXd::Zero(columns, columns);
  const auto n = static_cast<Eigen::Index>(system.markers.size());
  for (const PlacedDevice& placed : system.devices) {
    Eigen::MatrixXd H[2] = {Eigen::MatrixXd::Zero(n, columns),
                            Eigen::MatrixXd::Zero(n, columns)};
    for (Eigen::Index m = 0; m < n; ++m) {
      const Eigen::Vector3d arm =
          X_WT.R * system.markers[static_cast<std::size_t>(m)].p;
      const Pose& X_WS = placed.X_WS();
      Observation out;
      Target target;
      target.p_ST = X_WS.R.transpose() * (X_WT.p + arm - X_WS.p);
      EXPECT_TRUE(placed.device->observe(target, out));
      for (int r = 0; r < 2; ++r) {
        const Eigen::Vector3d h = X_WS.R * out.H.row(r).transpose();
        H[r].row(m).head<3>() = h.transpose();
        if (columns == 6) H[r].row(m).tail<3>() = arm.cross(h).transpose();
      }
    }
    const Eigen::MatrixXd R = sigma * sigma *
                              ((1 - common) * Eigen::MatrixXd::Identity(n, n) +
                               common * Eigen::MatrixXd::Ones(n, n));
    for (const Eigen::MatrixXd& h : H) S += h.transpose() * R.inverse() * h;
  }
  return S.inverse();
}

TEST(Lighthouse, SharesNoiseAsAFullCovarianceWould) {
  for (const char* generation : {"v1", "v2"})
    for (const double common : {0.0, 0.75, 0.99}) {
      Scene scene =
          scene_of(stations("{sigma: 5e-5, common: " + std::to_string(common) +
                                ", generation: " + generation + "}",
                            "pose", kDeck));
      const System system = build_system(scene, plugins());
      for (const char* metric : {"sigma_position", "sigma_orientation"}) {
        scene.metric = metric;
        const Field field = field_of(scene);
        for (std::size_t i = 0; i < field.value.size(); ++i) {
          const Eigen::MatrixXd P = all_at_once(
              system, {rotation_from_rpy({0.1, -0.2, 0.5}), field.samples.points[i]},
              5e-5, common, 6);
          const double expected = std::sqrt(std::string(metric) == "sigma_position"
                                                ? P.topLeftCorner<3, 3>().trace()
                                                : P.bottomRightCorner<3, 3>().trace());
          EXPECT_NEAR(field.value[i], expected, 1e-8 * expected)
              << generation << ' ' << common << ' ' << metric;
        }
      }
    }
}

// Four photodiodes in one place: a variance of σ²(c + (1 − c)/4), so that three
// quarters in common make the position √(0.8125/0.25) = 1.803 times worse than none.
TEST(Lighthouse, AveragesOnlyWhatIsNotInCommon) {
  const char* const together = "[[0, 0, 0], [0, 0, 0], [0, 0, 0], [0, 0, 0]]";
  const auto sigma = [&](const char* common) {
    return value_of(
        scene_of(stations("{sigma: 5e-5, common: " + std::string(common) + "}",
                          "position", together)),
        "sigma_position");
  };
  EXPECT_NEAR(sigma("0.75") / sigma("0"), std::sqrt(0.8125 / 0.25), 1e-9);
}

// What photodiodes have in common doesn't turn the deck: it is known better, where the
// differences are, by √(1/(1 − c)) = 2. The lever arms are small, so nearly so.
TEST(Lighthouse, KnowsTurnsBetterWhereNoiseIsInCommon) {
  const auto sigma = [&](const char* common) {
    return value_of(
        scene_of(stations("{sigma: 5e-5, common: " + std::string(common) + "}", "pose",
                          kDeck)),
        "sigma_orientation");
  };
  EXPECT_NEAR(sigma("0") / sigma("0.75"), 2, 0.01);
}

// A slope's noise σ is an angle's σ cos²θ: at 60 degrees a camera is 4 times too good.
TEST(Lighthouse, IsNoCameraOffItsAxis) {
  const double z = 1, x = std::tan(std::numbers::pi / 3);
  const auto sigma = [&](const std::string& device) {
    // Where across the sight line is along y: another looks along y and z.
    return value_of(
        scene_of("delos: 1\nmotion: {type: position, q: [1e9, 1e9, 1e9]}\n"
                 "covariance: posterior\n"
                 "metric: sigma_x\nsample: {points: [[" +
                 std::to_string(x) + ", 0, " + std::to_string(z) +
                 "]]}\ndevices:\n  - {name: a, rate: 1, " + device +
                 "}\n  - {name: fix, rate: 1, type: linear, params: {H: [[0,1,0],[" +
                 std::to_string(std::sin(std::numbers::pi / 3)) + ",0," +
                 std::to_string(std::cos(std::numbers::pi / 3)) +
                 "]], R: [[1e-12,0],[0,1e-12]]}}\n"),
        "sigma_x");
  };
  const double swept = sigma(
      "type: lighthouse, params: {generation: v1, sigma: 1e-3, common: 0, across: "
      "2.5}");
  const double camera =
      sigma("type: camera, params: {resolution: [4000, 4000], f_x: 1000, sigma: 1}");
  EXPECT_NEAR(swept / camera, 4, 1e-3);
}

}  // namespace
}  // namespace delos::test
