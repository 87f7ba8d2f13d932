#include "delos/text/format.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace delos {
namespace {

struct Case {
  double si;
  const char* unit;
  int digits;
  const char* text;
};

// Expected texts by hand; 0.00908 rad is 0.5202 deg.
TEST(FormatQuantity, SaysWhatPeopleSay) {
  const Case cases[] = {
      {0.0817, "m", 3, "81.7 mm"},
      {0.00908, "rad", 3, "0.52 deg"},
      {0.0012, "s", 3, "1.2 ms"},
      {0, "m", 3, "0 m"},
      {1, "m", 3, "1 m"},
      {-0.05, "m", 3, "-50 mm"},
      {2.5e-6, "m", 3, "2.5 µm"},
      {3e-9, "s", 3, "3 ns"},
      {2e-10, "m", 3, "0.2 nm"},
      {1234, "m", 3, "1.23 km"},
      {1234, "s", 3, "1230 s"},
      {2400, "Hz", 3, "2.4 kHz"},
      {0.5, "Hz", 3, "0.5 Hz"},
      {0.002, "m/s", 3, "2 mm/s"},
      {1, "rad/s", 3, "57.3 deg/s"},
      {1.234e-5, "m^2", 3, "12.3 mm^2"},
      {3.7e-9, "m^2", 3, "0.0037 mm^2"},
      {0.5, "m^2", 3, "0.5 m^2"},
      {2, "m^2", 3, "2 m^2"},
      {0.25, "m²", 3, "0.25 m²"},
      {7, "px", 3, "7 px"},
      {4, "1", 3, "4"},
      {4, "", 3, "4"},
      {50, "1/s", 3, "50 1/s"},
      {0.123456789, "m", 6, "123.457 mm"},
  };
  for (const Case& c : cases)
    EXPECT_EQ(format_quantity(c.si, c.unit, c.digits), c.text) << c.si << " " << c.unit;
}

TEST(FormatQuantity, ChangesUnitAfterRounding) {
  EXPECT_EQ(format_quantity(0.9996, "m"), "1 m");
  EXPECT_EQ(format_quantity(0.9994, "m"), "999 mm");
  EXPECT_EQ(format_quantity(9.996e-4, "s"), "1 ms");
}

TEST(FormatQuantity, HasWordsForWhatIsNotFinite) {
  EXPECT_EQ(format_quantity(std::numeric_limits<double>::infinity(), "m"), "∞");
  EXPECT_EQ(format_quantity(-std::numeric_limits<double>::infinity(), "m"), "-∞");
  EXPECT_EQ(format_quantity(std::nan(""), "m"), "undefined");
}

TEST(DisplayUnit, ScalesBackToSi) {
  EXPECT_EQ(display_unit(0.02, "m").name, "mm");
  EXPECT_EQ(display_unit(0.02, "m").factor, 1000);
  EXPECT_EQ(display_unit(1, "1").name, "");
  EXPECT_DOUBLE_EQ(display_unit(1, "rad").factor, 57.29577951308232);
}

}  // namespace
}  // namespace delos
