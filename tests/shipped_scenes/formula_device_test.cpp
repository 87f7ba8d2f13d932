// Devices by formulas in scenes: where their mistakes are found, and that they are what
// the same devices in C++ are.
#include <sstream>

#include "shipped_scenes/shipped.h"

namespace delos::test {
namespace {

std::string finding(const std::string& params) {
  Diagnostics findings;
  (void)parse_scene(
      "delos: 1\nmotion: {type: position, q: [1, 1, 1]}\n"
      "sample: {points: [[0, 0, 1]]}\ndevices:\n"
      "  - name: c\n    type: custom\n    rate: 1\n    params:\n      " +
          params + "\n",
      "s.yaml", {}, plugins(), findings);
  EXPECT_EQ(findings.size(), 1u);
  return findings.empty() ? "" : to_string(findings.front());
}

// Columns count from 1: in "      reading: 'x; r'" the r is at 20.
TEST(FormulaDevice, IsToldWhichCharacterIsWrong) {
  EXPECT_EQ(finding("reading: 'x; r'\n      sigma: 1"),
            "s.yaml:9:20: error: devices.c.params.reading: 'r' isn't known here; there "
            "are x, y, z, and R[row, column] of x, y, z");
  EXPECT_EQ(
      finding("reading: x + * y\n      sigma: 1"),
      "s.yaml:9:20: error: devices.c.params.reading: expected a number, a name or "
      "'(', found '*'");
  EXPECT_EQ(finding("reading: x\n      sigma: sqrt(z"),
            "s.yaml:10:20: error: devices.c.params.sigma: expected ')', found the end");
  EXPECT_EQ(finding("reading: x"),
            "s.yaml:9:7: error: devices.c.params.sigma: missing: Standard deviation of "
            "each reading: a formula, or as many as readings.");
}

// A device that reads the orientation is one of the whole pose.
TEST(FormulaDevice, OfTheOrientationNeedsOneToEstimate) {
  const std::string compass =
      "motion: {type: position, state: STATE, q: QS}\ncovariance: single\nmetric: "
      "METRIC\nsample: {points: [[0, 0, 1]]}\ndevices:\n"
      "  - {name: c, type: custom, rate: 1, params: {reading: 'atan2(R[y, x], R[x, "
      "x])', sigma: '0.02', sight: not_needed}}\n";
  const auto scene = [&](const char* state, const char* q, const char* metric) {
    std::string text = "delos: 1\n" + compass;
    for (const auto& [from, to] : {std::pair<std::string, std::string>{"STATE", state},
                                   {"QS", q},
                                   {"METRIC", metric}})
      text.replace(text.find(from), from.size(), to);
    return scene_of(text);
  };
  EXPECT_NEAR(value_of(scene("planar_pose", "[1, 1, 1]", "sigma_yaw"), "sigma_yaw"),
              0.02, 1e-12);
  EXPECT_TRUE(std::isinf(
      value_of(scene("pose", "[1, 1, 1, 1, 1, 1]", "sigma_roll"), "sigma_roll")));
}

// Anchors of scene 15 by formulas: the same field.
TEST(FormulaDevice, GivesTheFieldOfTheSameDevicesInCpp) {
  const Scene anchors = load("15-uwb-anchors");
  Scene formulas = anchors;
  for (DeviceEntry& device : formulas.devices) {
    device.type = "custom";
    device.params = {};
    device.params.set("reading", std::string("sqrt(x^2 + y^2 + z^2)"));
    device.params.set("sigma", std::string("p1"));
    device.params.set("inside", std::string("50 - sqrt(x^2 + y^2 + z^2)"));
    device.params.set(
        "p", ParamValue(Eigen::MatrixXd(Eigen::MatrixXd::Constant(1, 1, 0.1))));
    device.params.set("beyond", std::string("smooth"));
    device.params.set("sight", std::string("needed"));
    device.params.set("period", std::string("0"));
  }
  const Field a = field_of(anchors), b = field_of(formulas);
  ASSERT_EQ(a.value.size(), b.value.size());
  for (std::size_t i = 0; i < a.value.size(); ++i) {
    if (std::isfinite(a.value[i])) {
      EXPECT_NEAR(a.value[i], b.value[i], 1e-12 * a.value[i]) << i;
    } else {
      EXPECT_EQ(std::isnan(a.value[i]), std::isnan(b.value[i])) << i;
      EXPECT_EQ(std::isinf(a.value[i]), std::isinf(b.value[i])) << i;
    }
  }
}

}  // namespace
}  // namespace delos::test
