// Slopes of fields against a law of scale, and against values that were worked out
// elsewhere.
#include "session/sensitivity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iomanip>
#include <sstream>

#include "designs.h"
#include "session/refusal.h"

namespace delos::session {
namespace {

Sensitivity slopes(const Design& design, const std::string& path) {
  return draw_sensitivity(design.loaded(), path, 0, {}, plugins());
}

// Of a filter of position and velocity with continuous readings of noise R = r d² the
// variance of a position is q^{1/4} R^{3/4} times a number without a unit. So eigmax
// goes with λ^{3/8} where all r are λ times as large, and by Euler's theorem
//   Σ rᵢ ∂eigmax/∂rᵢ = 3/8 eigmax   at every sample.
TEST(Sensitivity, ObeysEulersTheorem) {
  Design design = design_of("01-acoustic");
  change(design, {{"fusion", "continuous"}});
  const DrawnField field = draw_field(design.loaded(), 0, {});
  std::vector<double> sum(field.field.value.size(), 0);
  std::vector<bool> smooth(sum.size(), true);
  for (const char* device : {"s1", "s2", "s3", "s4"}) {
    const Sensitivity s =
        slopes(design, "devices." + std::string(device) + ".params.r");
    EXPECT_EQ(s.value, 0.005);
    EXPECT_EQ(s.unit, "1");
    EXPECT_EQ(s.drawn.field.unit, "m");
    ASSERT_EQ(s.drawn.field.value.size(), sum.size());
    for (std::size_t i = 0; i < sum.size(); ++i) {
      sum[i] += s.value * s.drawn.field.value[i];
      if (s.drawn.mask[i] != Drawn::value) smooth[i] = false;
    }
  }
  // Where two directions are known equally badly the greater one bends: on some lines.
  // There is no slope there, or, where it bends by less than rounding, half of two.
  std::size_t bent = 0;
  for (std::size_t i = 0; i < sum.size(); ++i) {
    const double wanted = 0.375 * field.field.value[i];
    if (!smooth[i] || std::abs(sum[i] - wanted) > 1e-6 * wanted) ++bent;
    if (smooth[i]) EXPECT_NEAR(sum[i], wanted, 1e-3 * wanted);
  }
  EXPECT_LT(bent, 0.02 * static_cast<double>(sum.size()));
}

// With the speakers above the corners, at (0.1, 0.2, 0.4) an independent solver has
// eigmax 0.0424364432 m at r = 0.00499 and 0.0424497677 m at 0.00501 of the first
// speaker.
TEST(Sensitivity, IsThatOfAnIndependentSolver) {
  Design design = design_of("01-acoustic");
  change(design, {{"devices.s1.at", "[0, 0, 1.0485]"},
                  {"devices.s2.at", "[0.4, 0, 1.0485]"},
                  {"devices.s3.at", "[0, 0.4, 1.0485]"},
                  {"devices.s4.at", "[0.4, 0.4, 1.0485]"}});
  const Sensitivity s = slopes(design, "devices.s1.params.r");
  const double wanted = (0.0424497677 - 0.0424364432) / 2e-5;
  for (std::size_t i = 0; i < s.drawn.field.value.size(); ++i) {
    if ((s.drawn.field.samples.points[i] - Eigen::Vector3d(0.1, 0.2, 0.4)).norm() >
        1e-9)
      continue;
    EXPECT_NEAR(s.drawn.field.value[i], wanted, 1e-4 * wanted);
    return;
  }
  FAIL() << "no such sample";
}

// Fields on both sides at another step, ten times as far apart.
TEST(Sensitivity, OfPlacesAndOfAnglesIsThatOfFields) {
  const Design design = design_of("05-optitrack-lab");
  const DrawnField field = draw_field(design.loaded(), 0, {});
  for (const auto& [path, step] : {std::pair("devices.c104332.at.z", 1e-3),
                                   std::pair("devices.c104332.params.focal", 6.8e-6)}) {
    const Sensitivity s = slopes(design, path);
    std::vector<DrawnField> sides;
    for (const double sign : {-1.0, 1.0}) {
      Design other = design;
      std::ostringstream value;
      value << std::setprecision(17) << s.value + sign * step;
      change(other, {{path, value.str()}});
      sides.push_back(draw_field(other.loaded(), 0, {}));
    }
    const double between = 2 * step;
    double sum = 0, squares = 0;
    std::size_t compared = 0;
    for (std::size_t i = 0; i < sides[0].mask.size(); ++i) {
      if (s.drawn.mask[i] != Drawn::value) continue;
      const double a = sides[0].field.value[i], b = sides[1].field.value[i];
      // Between the wider ends a device may begin to see.
      const double middle = field.field.value[i];
      if (!std::isfinite(a) || !std::isfinite(b) ||
          std::abs(a + b - 2 * middle) > 0.1 * std::abs(b - a) + 1e-6 * middle)
        continue;
      const double error = s.drawn.field.value[i] - (b - a) / between;
      sum += error * error;
      squares += s.drawn.field.value[i] * s.drawn.field.value[i];
      ++compared;
    }
    EXPECT_GT(compared, 8000u) << path;
    EXPECT_LT(std::sqrt(sum / squares), 0.02) << path;
  }
}

TEST(Sensitivity, SaysWhichNumbersThereAre) {
  const Design design = design_of("01-acoustic");
  for (const char* path : {"devices.s9.at.x", "devices.s1.params.focal", "name"})
    EXPECT_THROW(static_cast<void>(slopes(design, path)), Refusal) << path;
}

}  // namespace
}  // namespace delos::session
