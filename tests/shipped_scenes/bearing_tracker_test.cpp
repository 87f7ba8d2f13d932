// A detector's published bearings at nine sites: noise that is learnt on eight of them
// predicts how places scatter at the ninth. The table of docs/verification.md.
#include <Eigen/LU>
#include <filesystem>
#include <fstream>
#include <map>
#include <numbers>
#include <sstream>

#include "shipped_scenes/shipped.h"

namespace delos::test {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kHeading = 90 * kDegree;

using Bearings = Eigen::Vector4d;  // radians
using Site = std::pair<double, double>;

double wrapped(double angle) { return std::remainder(angle, 2 * std::numbers::pi); }

/// Measured numbers of a table of `columns` columns.
Eigen::MatrixXd table(const std::string& name, int columns) {
  std::ifstream in(std::string(DELOS_BEARINGS) + "/" + name);
  std::vector<double> numbers;
  for (std::string line; std::getline(in, line);) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream row(line);
    for (double number; row >> number;) numbers.push_back(number);
  }
  return Eigen::Map<
      Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
      numbers.data(), static_cast<Eigen::Index>(numbers.size()) / columns, columns);
}

const Eigen::MatrixXd& landmarks() {
  static const Eigen::MatrixXd all = table("landmark.csv", 2);
  return all;
}

Bearings bearings_at(const Eigen::Vector3d& pose) {
  Bearings all;
  for (int i = 0; i < 4; ++i)
    all(i) =
        wrapped(std::atan2(landmarks()(i, 1) - pose.y(), landmarks()(i, 0) - pose.x()) -
                pose.z());
  return all;
}

/// x, y and heading of one row by Gauss and Newton's method from the true pose, with
/// derivatives by differences.
Eigen::Vector3d located(const Bearings& read, Eigen::Vector3d pose) {
  for (int i = 0; i < 20; ++i) {
    constexpr double kStep = 1e-6;
    Eigen::Matrix<double, 4, 3> H;
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d by = kStep * Eigen::Vector3d::Unit(k);
      H.col(k) = (bearings_at(pose + by) - bearings_at(pose - by)).unaryExpr(&wrapped) /
                 (2 * kStep);
    }
    const Bearings off = (read - bearings_at(pose)).unaryExpr(&wrapped);
    pose += (H.transpose() * H).inverse() * H.transpose() * off;
  }
  return pose;
}

struct Measured {
  double bearing_variance = 0;  // mean of the four, rad²
  double place_variance = 0;    // of x and y together, m²
  double off = 0;               // of the mean place, m: bias, which is no scatter
};

Measured measured(double x, double y) {
  std::ostringstream name;
  name.setf(std::ios::fixed);
  name.precision(1);
  name << "X" << x << "Y" << y << ".csv";
  const Eigen::MatrixXd rows = table(name.str(), 4) * kDegree;
  const Eigen::Vector3d truth(x, y, kHeading);
  const auto n = static_cast<double>(rows.rows());
  Eigen::MatrixXd place(rows.rows(), 2), bearing(rows.rows(), 4);
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    const Bearings read = rows.row(i).transpose();
    place.row(i) = located(read, truth).head<2>().transpose();
    bearing.row(i) = (read - bearings_at(truth)).unaryExpr(&wrapped).transpose();
  }
  const auto variance = [&](const Eigen::MatrixXd& of) {
    return (of.rowwise() - of.colwise().mean()).squaredNorm() / (n - 1);
  };
  return {variance(bearing) / 4, variance(place),
          (place.colwise().mean().transpose() - truth.head<2>()).norm()};
}

std::map<Site, Measured> all_sites() {
  std::map<Site, Measured> all;
  for (const double x : {1.5, 3.0, 4.5})
    for (const double y : {1.5, 3.0, 4.5}) all[{x, y}] = measured(x, y);
  return all;
}

/// What Delos predicts of a place's scatter, m.
double predicted(const Site& site, double sigma) {
  std::ostringstream points, noise;
  points.precision(17);
  noise.precision(17);
  points << "{points: [[" << site.first << ", " << site.second << ", 0]]}";
  noise << sigma;
  const Field field = field_of(
      "18-floor-robot",
      {{"sample", points.str()}, {"devices.detector.params.sigma", noise.str()}});
  return field.value.at(0);
}

// The numbers: a script of its own that solves normal equations by hand.
TEST(BearingTracker, EightSitesPredictTheNinth) {
  const std::map<Site, Measured> sites = all_sites();
  const std::map<Site, std::pair<double, double>> expected = {
      // predicted, measured
      {{1.5, 1.5}, {92.7, 42.7}},  {{1.5, 3.0}, {92.7, 58.9}},
      {{1.5, 4.5}, {75.3, 133.7}}, {{3.0, 1.5}, {92.8, 67.4}},
      {{3.0, 3.0}, {93.3, 36.9}},  {{3.0, 4.5}, {85.6, 123.8}},
      {{4.5, 1.5}, {86.6, 87.0}},  {{4.5, 3.0}, {92.4, 60.8}},
      {{4.5, 4.5}, {89.5, 79.9}}};
  double of_predicted = 0, of_measured = 0;
  for (const auto& [site, here] : sites) {
    double others = 0;
    for (const auto& [other, there] : sites)
      if (other != site) others += there.bearing_variance / 8;
    const double scatter = predicted(site, std::sqrt(others));
    const auto [by_script, in_truth] = expected.at(site);
    EXPECT_NEAR(1000 * scatter, by_script, 0.06) << site.first << " " << site.second;
    EXPECT_NEAR(1000 * std::sqrt(here.place_variance), in_truth, 0.06);
    of_predicted += scatter * scatter / 9;
    of_measured += here.place_variance / 9;
  }
  // Together they are within a tenth; one by one the detector's noise differs.
  EXPECT_NEAR(1000 * std::sqrt(of_predicted), 89.2, 0.06);
  EXPECT_NEAR(1000 * std::sqrt(of_measured), 83.0, 0.06);
}

// With each site's own noise what is left are the formula's linearisation and the
// noise's distribution: within a fifth at every site, and 4 % together.
TEST(BearingTracker, PlacesScatterAsTheirOwnBearingsSay) {
  double of_predicted = 0, of_measured = 0;
  for (const auto& [site, here] : all_sites()) {
    const double scatter = predicted(site, std::sqrt(here.bearing_variance));
    of_predicted += scatter * scatter;
    of_measured += here.place_variance;
    EXPECT_NEAR(scatter / std::sqrt(here.place_variance), 1, 0.2)
        << site.first << " " << site.second;
    // Where readings are off in the mean, so are places, and no covariance says so.
    EXPECT_GT(here.off, 0.02);
  }
  EXPECT_NEAR(std::sqrt(of_predicted / of_measured), 1, 0.1);
}

}  // namespace
}  // namespace delos::test
