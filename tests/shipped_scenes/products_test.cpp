// Products whose figures are published: closed forms of what their scenes predict,
// beside the figures. Allen (2007), chapter 2, quotes them.
#include "shipped.h"

namespace delos::test {
namespace {

constexpr double kInch = 0.0254;

// On a dipole's axis σ² is s² r⁸ (2/1.8 + 1/54), s = sigma 4π/(µ0 moment). Published:
// 0.0002 in per in, which the noise floor was chosen by at 30 in.
TEST(Products, FastrakResolvesWhatIsPublishedAtThirtyInches) {
  const Field field = field_of("35-fastrak");
  const double s = 0.04252e-9 / 1e-7;
  for (int i = 0; i < 3; ++i) {
    const double r = 15 * (1 << i) * kInch;
    const double sigma = s * std::pow(r, 4) * std::sqrt(2 / 1.8 + 1.0 / 54);
    EXPECT_NEAR(value_at(field, {0, 0, r}), sigma, 1e-6 * sigma) << r;
  }
  EXPECT_NEAR(value_at(field, {0, 0, 30 * kInch}), 0.0002 * 30 * kInch, 2e-7);
}

// Four ranges from the corners of a square of 2a, z before its middle: HᵀH is diagonal,
// 4a²/r², 4a²/r², 4z²/r² with r² = 2a² + z². Published: steps of 0.02 in.
TEST(Products, LincolnWandScattersByLessThanItsSteps) {
  const Field field = field_of("36-lincoln-wand");
  const double range = 0.02 * kInch / std::sqrt(12), a = 24 * kInch;
  for (const double z : {24 * kInch, 60 * kInch}) {
    const double sigma = range * std::sqrt(2 * a * a + z * z) *
                         std::sqrt(2 / (4 * a * a) + 1 / (4 * z * z));
    EXPECT_NEAR(value_at(field, {a, a, z}), sigma, 1e-4 * sigma);
  }
  for (const double value : field.value) EXPECT_LT(value, 0.02 * kInch);
}

}  // namespace
}  // namespace delos::test
