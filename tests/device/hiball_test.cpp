// The HiBall's views and the noise of its photodiodes.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <stdexcept>

#include "../../plugins/hiball/photodiode.h"
#include "device/devices.h"
#include "device/look.h"

namespace delos::test {
namespace {

using Eigen::Vector3d;

// Allen (2007), Appendix C: the listing's parameters; rie, current and the temperature
// are derived from its check value, see the plugin's README.
const hiball::Photodiode kListing{.feedback = 2e5,
                                  .interelectrode = 7500,
                                  .voltage_noise = 4.5e-9,
                                  .current_noise = 6e-13,
                                  .bandwidth = 1.6e5,
                                  .temperature = 300,
                                  .current = 5.361239747e-6,
                                  .gap = 2e-5};

double noise(hiball::Sum sum, double light, double x, double angle, double distance) {
  return hiball::position_noise(kListing, sum, hiball::window_gain(kListing, light), x,
                                std::cos(angle * kDegree), distance);
}

// From an independent evaluation of the listing's strings in extended precision; the
// first is the one value that the dissertation prints.
TEST(Photodiode, GivesTheListingsValues) {
  using hiball::Sum, hiball::window_gain;
  EXPECT_NEAR(noise(Sum::linear, 100e-6, 0.5, 60, 3), 0.001751273, 5e-10);
  EXPECT_NEAR(noise(Sum::linear, 630e-6, 0.5, 0, 1), 4.219e-5, 5e-9);
  EXPECT_NEAR(noise(Sum::linear, 21e-6, 0.5, 0, 1), 2.257e-4, 5e-8);
  EXPECT_NEAR(window_gain(kListing, 100e-6), 140.716226, 1e-6);
  EXPECT_NEAR(window_gain(kListing, 630e-6), 56.299118, 1e-6);
  EXPECT_NEAR(window_gain(kListing, 20e-6), 308.263537, 1e-6);
}

// White noise of unit density, averaged over T: two windows of variance 1/(2T) each,
// which the listing's autocorrelation doubles. The filter's memory of 2 µs is nothing
// to 10 ms.
TEST(Photodiode, LongWindowsAverageWhiteNoise) {
  const double light = 10e-3;
  EXPECT_NEAR(hiball::window_gain(kListing, light), std::sqrt(2 / light),
              0.01 * std::sqrt(2 / light));
}

// At the middle both ends have the same noise, and 2NS + 2NS against √2 · 2NS.
TEST(Photodiode, IndependentNoisesAddBySquares) {
  const double linear = noise(hiball::Sum::linear, 1e-4, 0, 0, 2);
  EXPECT_NEAR(noise(hiball::Sum::independent, 1e-4, 0, 0, 2), linear / std::sqrt(2.0),
              1e-12 * linear);
}

TEST(Photodiode, GetsWorseWithDistanceAndAngle) {
  double last = 0;
  for (double d = 0.5; d < 6; d *= 1.1) {
    const double now = noise(hiball::Sum::linear, 1e-4, 0.3, 20, d);
    EXPECT_GT(now, last);
    last = now;
  }
  EXPECT_GT(noise(hiball::Sum::linear, 1e-4, 0.3, 50, 2),
            noise(hiball::Sum::linear, 1e-4, 0.3, 20, 2));
}

/// Names of a device's views.
std::set<std::string> views(const std::string& yaml) {
  const auto hiball = device("hiball", yaml);
  std::set<std::string> names;
  for (int i = 0; i < hiball->views(); ++i) names.insert(hiball->view_name(i));
  EXPECT_EQ(names.size(), static_cast<std::size_t>(hiball->views()));
  return names;
}

// Faces of a regular dodecahedron are vertices of an icosahedron, (0, ±1, ±φ) and its
// cyclic permutations. Six of them lie in a closed half space whose middle is one of
// them; those that share an edge, 2 apart, are adjacent.
TEST(HiBall, HasTheViewsOfADodecahedron) {
  const double phi = std::numbers::phi;
  std::vector<Vector3d> faces;
  for (const double a : {-1.0, 1.0}) {
    for (const double b : {-phi, phi}) {
      faces.emplace_back(0, a, b);
      faces.emplace_back(a, b, 0);
      faces.emplace_back(b, 0, a);
    }
  }
  const Vector3d up = faces.front();
  std::vector<Vector3d> upper;
  for (const Vector3d& f : faces) {
    if (f.dot(up) > 0) upper.push_back(f);
  }
  ASSERT_EQ(upper.size(), 6u);
  std::size_t adjacent = upper.size();
  for (const Vector3d& a : upper) {
    for (const Vector3d& b : upper) adjacent += std::abs((a - b).norm() - 2) < 1e-9;
  }
  EXPECT_EQ(adjacent, 26u);
  EXPECT_EQ(views("{}").size(), adjacent);
  EXPECT_EQ(views("{views: primary}").size(), 6u);
  EXPECT_EQ(views("{views: all_pairs}").size(), 36u);
}

// Around the middle one at tilt t, three stand 120° apart: cos² t + sin² t cos 120° =
// −0.2 of each other with tan t = 2, which is 101.5°, while each is 63.4° from the
// middle.
TEST(HiBall, WithFourHasFourTenOrSixteenViews) {
  const double cosine = 0.2 + 0.8 * std::cos(120 * kDegree);
  EXPECT_GT(std::acos(cosine), 100 * kDegree);
  EXPECT_EQ(views("{layout: four, views: primary}").size(), 4u);
  EXPECT_EQ(views("{layout: four, views: adjacent}").size(), 4u + 2 * 3);
  EXPECT_EQ(views("{layout: four, views: all_pairs}").size(), 4u * 4);
}

bool sees(const Device& device, int view, const Vector3d& p) {
  Observation out;
  Target target;
  target.p_ST = p;
  return device.observe_view(view, target, out);
}

/// Degrees that a view sees, from edge to edge, from its axis towards ±`side`.
double field_of_view(const Device& device, int view, const Vector3d& side) {
  const ViewCone cone = device.view_cone(view);
  double total = 0;
  for (const double sign : {-1.0, 1.0}) {
    double seen = 0, unseen = 45 * kDegree;
    while (unseen - seen > 1e-9) {
      const double angle = (seen + unseen) / 2;
      const Vector3d way = std::cos(angle) * cone.axis + sign * std::sin(angle) * side;
      (sees(device, view, cone.apex + 1000 * way) ? seen : unseen) = angle;
    }
    total += seen / kDegree;
  }
  return total;
}

// A primary view sees 6° by 6°. A secondary view looks 31.7° off the photodiode's axis,
// half of the 63.4° between two axes, over a chord of f cos 31.7°: the square half
// width f tan 3° then spans 6.0° one way, foreshortened, and 7.0° the other. Welch et
// al. (2001) and Allen (2007), §5.1.1 state 6 lenses, 26 views and 6°.
TEST(HiBall, HasTheFieldsOfViewOfItsGeometry) {
  const auto hiball = device("hiball", "{}");
  const double f = 0.0382, half = f * std::tan(3 * kDegree);
  const double off = std::atan(2.0) / 2, chord = f * std::cos(off);
  int primary = 0, secondary = 0;
  for (int view = 0; view < hiball->views(); ++view) {
    const std::string name = hiball->view_name(view);
    const ViewCone cone = hiball->view_cone(view);
    const bool own = name.front() == 'p' && name[11] == name.back();
    if (own) {
      ++primary;
      const Vector3d side = cone.axis.unitOrthogonal();
      // Any direction of a square: from 6° through the middles of its sides to the
      // corners.
      EXPECT_GE(field_of_view(*hiball, view, side), 6 - 1e-6);
      EXPECT_LE(field_of_view(*hiball, view, side), 8.5);
      EXPECT_NEAR(cone.half_angle, std::atan(std::sqrt(2.0) * half / f), 1e-8);
      continue;
    }
    ++secondary;
    // The plane of both axes holds the foreshortened side where the square is aligned
    // with it, which it is for the views of the middle lens.
    if (name[11] == '0' || name.back() != '0') continue;
    const Vector3d across = Vector3d::UnitZ().cross(cone.axis).normalized();
    EXPECT_NEAR(field_of_view(*hiball, view, across),
                2 * std::atan(half / chord) / kDegree, 1e-5);
    EXPECT_NEAR(field_of_view(*hiball, view, across), 7.06, 0.01);
    const Vector3d along = cone.axis.cross(across);
    EXPECT_NEAR(field_of_view(*hiball, view, along), 6.0, 0.05);
  }
  EXPECT_EQ(primary, 6);
  EXPECT_EQ(secondary, 20);
}

TEST(HiBall, FollowsTheLightsNoise) {
  const auto hiball = device("hiball", "{noise: photodiode, light: 1e-4}");
  const auto published =
      device("hiball", "{noise: photodiode, light: 1e-4, reading: published}");
  Target target;
  target.p_ST = {0.05, -0.02, 2.5};
  target.n_ST = {0, 0.6, -0.8};
  Observation out, as_published;
  ASSERT_TRUE(hiball->observe_view(0, target, out));
  ASSERT_TRUE(published->observe_view(0, target, as_published));
  const Vector3d lens(0, 0, 0.0191), way = lens - target.p_ST;
  const double gain = hiball::window_gain(kListing, 1e-4);
  for (const int row : {0, 1}) {
    const double x =
        hiball::position_noise(kListing, hiball::Sum::linear, gain, out.z(row),
                               target.n_ST.dot(way.normalized()), way.norm());
    EXPECT_NEAR(out.R(row, row), x * x, 1e-12 * x * x);
    EXPECT_NEAR(as_published.R(row, row), x, 1e-12 * x);
  }
  target.n_ST = {0, 0, 1};  // it shines the other way
  EXPECT_FALSE(hiball->observe_view(0, target, out));
}

TEST(HiBall, RefusesLayoutsThatCannotBe) {
  const auto problem = [](const std::string& yaml) -> std::string {
    try {
      device("hiball", yaml);
    } catch (const std::exception& e) {
      return e.what();
    }
    return "";
  };
  EXPECT_EQ(problem("{layout: custom, axes: [[0, 0, 1], [1, 0, 0], [0, 0, 2]]}"),
            "axes 0 and 2 are the same; two lenses can't stand in one place");
  EXPECT_EQ(problem("{layout: custom, axes: [[0, 0, 0]]}"),
            "axes: axis 0 has length zero, which is no direction");
  EXPECT_EQ(problem("{layout: custom, axes: [[0, 1]]}"),
            "axes must be rows of three numbers, [[x, y, z], …]");
}

// Opposite lenses: a photodiode would stand in its lens, which is no view.
TEST(HiBall, LeavesOutOppositePairs) {
  EXPECT_EQ(views("{layout: custom, axes: [[0, 0, 1], [0, 0, -1]], views: all_pairs}"),
            (std::set<std::string>{"photodiode 0 through lens 0",
                                   "photodiode 1 through lens 1"}));
}

}  // namespace
}  // namespace delos::test
