#include "delos/text/units.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <numbers>
#include <random>

namespace delos {
namespace {

struct Good {
  const char* text;
  const char* unit;
  double value;
};

// Expected values by definition: 1 in = 0.0254 m, 1 ft = 0.3048 m, 1 deg = π/180 rad,
// 0 °C = 273.15 K.
using std::numbers::pi;
const Good kGoodQuantities[] = {
    {"0.5", "m", 0.5},
    {" -2 ", "m", -2},
    {"+3e-2", "m", 0.03},
    {".5", "1", 0.5},
    {"50 mm", "m", 0.05},
    {"50mm", "m", 0.05},
    {"104.85 cm", "m", 1.0485},  // rounded once: 104.85*0.01 isn't always the nearest
    {"1.1 um", "m", 1.1e-6},
    {"0.3 km", "m", 300},
    {"2 in", "m", 0.0508},
    {"10 ft", "m", 3.048},
    {"60 deg", "rad", pi / 3},
    {"-90 deg", "rad", -pi / 2},
    {"180°", "rad", pi},
    {"1 mrad", "rad", 1e-3},
    {"1.5 rad", "rad", 1.5},
    {"100 Hz", "1/s", 100},
    {"1.5 kHz", "1/s", 1500},
    {"25 1/s", "1/s", 25},
    {"5 ms", "s", 0.005},
    {"2 min", "s", 120},
    {"9.81 m/s^2", "m/s^2", 9.81},
    {"3 mm^2", "m^2", 3e-6},
    {"7 m^2/s^3", "m^2/s^3", 7},
    {"7 m2 s-3", "m^2/s^3", 7},
    {"36 km/h", "m/s", 10},
    {"30 deg/s", "rad/s", pi / 6},
    {"640 px", "px", 640},
    {"1 pixel", "px", 1},
    {"5 %", "1", 0.05},
    {"5%", "1", 0.05},
    {"20 degC", "K", 293.15},
    {"2 m rad/s", "m rad/s", 2},
    {"4 1/m^2", "1/m^2", 4},
};

TEST(ParseQuantity, ConvertsToSi) {
  for (const Good& good : kGoodQuantities) {
    const auto parsed = parse_quantity(good.text, good.unit);
    ASSERT_TRUE(std::holds_alternative<double>(parsed))
        << good.text << ": " << std::get<std::string>(parsed);
    EXPECT_DOUBLE_EQ(std::get<double>(parsed), good.value) << good.text;
  }
}

TEST(ParseQuantity, RoundsDecimalUnitsOnlyOnce) {
  // "x mm" is the double nearest to x/1000, as if the user had written it in metres.
  std::mt19937 random(1);
  for (int i = 0; i < 1000; ++i) {
    const std::string digits = std::to_string(random() % 1000000);
    EXPECT_EQ(std::get<double>(parse_quantity(digits + " mm", "m")),
              std::get<double>(parse_quantity(digits + "e-3", "m")))
        << digits;
  }
}

struct BadQuantity {
  const char* text;
  const char* unit;
  const char* problem;
};

const BadQuantity kBadQuantities[] = {
    {"8'2\"", "m", "'8'2\"' mixes feet and inches; write one of them, such as '98 in'"},
    {"8.5'", "m", "'8.5'' isn't a length; write '8.5 ft'"},
    {"8\"", "m", "'8\"' isn't a length; write '8 in'"},
    {"1200 px", "m",
     "'1200 px' is a number of pixels; expected a length such as '50 mm'; a focal "
     "length in pixels times the pitch is one in metres"},
    {"50 Hz", "m", "'50 Hz' is a frequency; expected a length such as '50 mm'"},
    {"50 mm", "1/s", "'50 mm' is a length; expected a frequency such as '100 Hz'"},
    {"2 s", "1/s", "'2 s' is a time; expected a frequency such as '100 Hz'"},
    {"60 deg", "1", "'60 deg' is an angle; expected a pure number such as '0.5'"},
    {"5 %", "rad", "'5 %' is a pure number; expected an angle such as '60 deg'"},
    {"2 rad/s", "1/s",
     "'2 rad/s' is a turn rate; expected a frequency such as '100 Hz'"},
    {"2 px", "1", "'2 px' is a number of pixels; expected a pure number such as '0.5'"},
    {"2 kg m/s", "m", "'2 kg m/s' is in kg m s^-1; expected a length such as '50 mm'"},
    {"2 s", "m^2/s^3", "'2 s' is a time; expected a number in m^2/s^3"},
    {"2 hz", "1/s",
     "unknown unit 'hz'; did you mean 'Hz'?; expected a frequency such as '100 Hz'"},
    {"2 florps", "m", "unknown unit 'florps'; expected a length such as '50 mm'"},
    {"2 3 m", "m", "unknown unit '3 m'; expected a length such as '50 mm'"},
    {"2 m 3", "m", "unknown unit 'm 3'; expected a length such as '50 mm'"},
    {"2 m*3", "m", "unknown unit 'm*3'; expected a length such as '50 mm'"},
    {"five", "m", "expected a length such as '50 mm', not 'five'"},
    {"yes", "1", "expected a pure number such as '0.5', not 'yes'"},
    {"", "m", "expected a length such as '50 mm', not ''"},
    {"-", "m", "expected a length such as '50 mm', not '-'"},
    {"m", "m", "expected a length such as '50 mm', not 'm'"},
    {"010", "m", "'010' has a leading zero; numbers are decimal, leave it out"},
    {"-007 mm", "m", "'-007 mm' has a leading zero; numbers are decimal, leave it out"},
    {"0x10", "1", "'0x10' isn't decimal; write the number in decimal notation"},
    {"0o17", "1", "'0o17' isn't decimal; write the number in decimal notation"},
    {"nan", "m", "'nan' isn't a finite number"},
    {"-inf", "m", "'-inf' isn't a finite number"},
    {".inf", "m", "'.inf' isn't a finite number"},
    {"Infinity m", "m", "'Infinity m' isn't a finite number"},
    {"1e999", "m", "'1e999' is beyond the range of a double"},
    {"1e308 km", "m", "'1e308 km' is beyond the range of a double"},
    {"2 m", "furlongs!", "'2 m' has a unit; write the number alone, in furlongs!"},
};

TEST(ParseQuantity, SaysWhatIsWrong) {
  for (const BadQuantity& bad : kBadQuantities) {
    const auto parsed = parse_quantity(bad.text, bad.unit);
    ASSERT_TRUE(std::holds_alternative<std::string>(parsed))
        << bad.text << " gave " << std::get<double>(parsed);
    EXPECT_EQ(std::get<std::string>(parsed), bad.problem);
  }
}

TEST(Shortest, ReadsBackAsTheSameDouble) {
  EXPECT_EQ(shortest(0.1), "0.1");
  EXPECT_EQ(shortest(50), "50");
  EXPECT_EQ(shortest(-0.0), "-0");
  std::mt19937_64 random(2);
  for (int i = 0; i < 2000; ++i) {
    const std::uint64_t bits = random();
    double value;
    static_assert(sizeof value == sizeof bits);
    std::memcpy(&value, &bits, sizeof value);
    if (!std::isfinite(value) || (value != 0 && !std::isnormal(value))) continue;
    EXPECT_EQ(std::get<double>(parse_quantity(shortest(value), "1")), value);
  }
}

}  // namespace
}  // namespace delos
