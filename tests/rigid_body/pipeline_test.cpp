// The stages before and behind the filter, each against what it is made from.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>
#include <random>
#include <stdexcept>

#include "delos/rigid_body/align.h"
#include "delos/rigid_body/comparison.h"
#include "delos/rigid_body/matching.h"
#include "delos/rigid_body/tracker.h"
#include "delos/rigid_body/window.h"

namespace delos::rigid_body {
namespace {

Eigen::Vector3d normal3(std::mt19937_64& random, double sigma) {
  std::normal_distribution<double> normal(0, sigma);
  const double x = normal(random), y = normal(random), z = normal(random);
  return {x, y, z};
}

BodyPose pose_in_view(std::mt19937_64& random) {
  return {turned_by(normal3(random, 1)),
          Eigen::Vector3d(0, 0, 1) + normal3(random, 0.08)};
}

std::vector<Eigen::Vector3d> placed(const BodyPose& pose) {
  std::vector<Eigen::Vector3d> all;
  for (const Eigen::Vector3d& b : marker_body()) all.push_back(pose.R * b + pose.t);
  return all;
}

TEST(RigCamera, LooksAtThePointAndHasItsSlope) {
  const Camera camera = looking_at({1, -2, 0.5}, {0.2, 0.1, 1});
  EXPECT_NEAR(camera.R_WC.determinant(), 1, 1e-14);
  EXPECT_LT((*image_of(camera, {0.2, 0.1, 1}) - camera.centre).norm(), 1e-10);
  // What is higher in the world is higher in the image: v falls.
  EXPECT_LT(image_of(camera, {0.2, 0.1, 1.1})->y(), camera.centre.y());
  Eigen::Matrix<double, 2, 3> slope;
  const Eigen::Vector3d p(0.3, 0, 1.1);
  ASSERT_TRUE(image_of(camera, p, &slope));
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d step = 1e-6 * Eigen::Vector3d::Unit(k);
    const Eigen::Vector2d by =
        (*image_of(camera, p + step) - *image_of(camera, p - step)) / 2e-6;
    EXPECT_LT((by - slope.col(k)).norm(), 1e-5);
  }
  EXPECT_FALSE(image_of(camera, {2, -4, 0}));  // behind
  EXPECT_FALSE(image_of(camera, {9, 0, 1}));   // beside
}

/// Without noise the point itself; with noise the scatter that (Σ Jᵀ J)⁻¹ σ² says.
TEST(Triangulation, FindsThePointAndScattersAsItsInformationSays) {
  const auto cameras = stereo_rig();
  const Eigen::Vector3d p(0.05, -0.1, 1.1);
  const auto seen = [&](std::mt19937_64* random) {
    std::vector<Sighting> all;
    for (std::size_t c = 0; c < cameras.size(); ++c) {
      Eigen::Vector2d uv = *image_of(cameras[c], p);
      if (random) uv += normal3(*random, 0.4).head<2>();
      all.push_back({c, uv});
    }
    return all;
  };
  EXPECT_LT((*triangulated(cameras, seen(nullptr), 1e-6) - p).norm(), 1e-11);
  Eigen::Matrix3d N = Eigen::Matrix3d::Zero();
  for (const Camera& camera : cameras) {
    Eigen::Matrix<double, 2, 3> J;
    ASSERT_TRUE(image_of(camera, p, &J));
    N += J.transpose() * J / 0.16;
  }
  std::mt19937_64 random(1);
  double nees = 0;
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector3d off = *triangulated(cameras, seen(&random), 3) - p;
    nees += off.dot(N * off);
  }
  EXPECT_NEAR(nees / 2000, 3, 5 * std::sqrt(6. / 2000));
  // Rays that miss each other, and rays that are one.
  std::vector<Sighting> two = seen(nullptr);
  two[1].uv.y() += 40;
  EXPECT_FALSE(triangulated(cameras, two, 3));
  EXPECT_FALSE(triangulated({cameras[0], cameras[0]}, seen(nullptr), 3));
}

TEST(Align, FindsThePoseAndNeverAReflection) {
  std::mt19937_64 random(2);
  const auto body = marker_body();
  for (int i = 0; i < 50; ++i) {
    const BodyPose pose = pose_in_view(random);
    auto world = placed(pose);
    const BodyPose exact = aligned(body, world);
    EXPECT_LT((exact.R - pose.R).norm() + (exact.t - pose.t).norm(), 1e-12);
    // Arun's closed form alone gives reflections of noise as large as the body
    // (Umeyama); and of three points, which are in a plane.
    for (Eigen::Vector3d& w : world) w += normal3(random, 0.1);
    EXPECT_NEAR(aligned(body, world).R.determinant(), 1, 1e-12);
    const BodyPose of_three =
        aligned(std::span(body).first(3), std::span(world).first(3));
    EXPECT_NEAR(of_three.R.determinant(), 1, 1e-12);
  }
}

/// The least squares: no pose nearby is nearer.
TEST(Align, IsTheNearestPose) {
  std::mt19937_64 random(3);
  const auto body = marker_body();
  auto world = placed(pose_in_view(random));
  for (Eigen::Vector3d& w : world) w += normal3(random, 0.01);
  const auto squares = [&](const BodyPose& pose) {
    double sum = 0;
    for (std::size_t i = 0; i < body.size(); ++i)
      sum += (pose.R * body[i] + pose.t - world[i]).squaredNorm();
    return sum;
  };
  const BodyPose best = aligned(body, world);
  for (int i = 0; i < 200; ++i)
    EXPECT_GT(squares({turned_by(normal3(random, 1e-3)) * best.R,
                       best.t + normal3(random, 1e-4)}),
              squares(best));
}

TEST(Align, RejectsFalseMatches) {
  std::mt19937_64 random(4);
  const auto body = marker_body();
  for (int i = 0; i < 30; ++i) {
    const BodyPose pose = pose_in_view(random);
    auto world = placed(pose);
    for (Eigen::Vector3d& w : world) w += normal3(random, 3e-4);
    world[1] += Eigen::Vector3d(0.03, 0, 0.02);
    world[4] = Eigen::Vector3d(0, 0.2, 1);
    const auto found = aligned_rejecting(body, world, 0.004);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->kept, (std::vector<std::size_t>{0, 2, 3}));
    EXPECT_LT((found->pose.t - pose.t).norm(), 2e-3);
    EXPECT_GT((aligned(body, world).t - pose.t).norm(), 5e-3);  // without rejection
  }
  const auto two = std::span(body).first(2);
  EXPECT_FALSE(aligned_rejecting(two, two, 1));
}

/// Among twenty false points, by distances alone, in any order.
TEST(Matching, FindsTheBodyInACloud) {
  std::mt19937_64 random(5);
  const auto body = marker_body();
  for (int i = 0; i < 30; ++i) {
    std::vector<Eigen::Vector3d> cloud;
    for (int k = 0; k < 20; ++k)
      cloud.push_back(Eigen::Vector3d(0, 0, 1) + normal3(random, 0.15));
    const auto world = placed(pose_in_view(random));
    std::vector<std::size_t> at;
    for (std::size_t m = 0; m < body.size(); ++m) {
      at.push_back((7 * m + static_cast<std::size_t>(i)) % cloud.size());
      cloud[at[m]] = world[m] + normal3(random, 3e-4);
    }
    // One marker is hidden.
    cloud[at[2]] += Eigen::Vector3d(0.5, 0, 0);
    const Matches matches = matched(body, cloud, 2e-3);
    ASSERT_EQ(matches.size(), body.size()) << i;
    for (std::size_t m = 0; m < body.size(); ++m) {
      if (m == 2) continue;
      EXPECT_EQ(matches[m], at[m]) << i;
    }
  }
}

TEST(Matching, TellsABodyFromItsMirrorImageAndHeedsWindows) {
  const auto body = marker_body();
  std::vector<Eigen::Vector3d> mirrored;
  for (const Eigen::Vector3d& b : body) mirrored.push_back({b.x(), b.y(), -b.z()});
  const Matches matches = matched(body, mirrored, 1e-3);
  // Three are their own mirror image; all five aren't.
  std::size_t found = 0;
  for (const auto& m : matches) found += m.has_value();
  EXPECT_LE(found, 3u);
  std::vector<std::vector<bool>> may(body.size(), std::vector<bool>(body.size(), true));
  for (std::vector<bool>& of : may) of[0] = false;
  const Matches without = matched(body, body, 1e-3, may);
  ASSERT_EQ(without.size(), body.size());
  EXPECT_FALSE(without[0]);
  EXPECT_EQ(without[1], std::size_t{1});
  EXPECT_TRUE(matched(body, std::span(body).first(2), 1e-3).empty());
  const std::vector<Eigen::Vector3d> many(3000, Eigen::Vector3d::Zero());
  EXPECT_THROW(static_cast<void>(matched(body, many, 1)), std::length_error);
}

/// Errors of refined poses by the covariance that goes with them: χ² of six degrees.
TEST(Refinement, IsAsSureAsItSays) {
  std::mt19937_64 random(6);
  const auto cameras = stereo_rig();
  const auto body = marker_body();
  double nees = 0;
  const int runs = 400;
  for (int i = 0; i < runs; ++i) {
    const BodyPose truth = pose_in_view(random);
    std::vector<MarkerImage> images;
    for (std::size_t m = 0; m < body.size(); ++m)
      for (std::size_t c = 0; c < 2; ++c) {
        const auto uv = image_of(cameras[c], truth.R * body[m] + truth.t);
        ASSERT_TRUE(uv);
        images.push_back({m, {c, *uv + normal3(random, 0.3).head<2>()}});
      }
    const BodyPose from{turned_by(normal3(random, 0.02)) * truth.R,
                        truth.t + normal3(random, 0.005)};
    const auto best = refined(from, body, cameras, images, 0.3);
    ASSERT_TRUE(best);
    Eigen::Matrix<double, 6, 1> off;
    off << truth.t - best->pose.t, turn_of(truth.R * best->pose.R.transpose());
    nees += off.dot(best->covariance.inverse() * off);
  }
  EXPECT_NEAR(nees / runs, 6, 5 * std::sqrt(12. / runs));
  std::vector<MarkerImage> one = {{0, {0, {300, 200}}}};
  EXPECT_FALSE(
      refined({Eigen::Matrix3d::Identity(), {0, 0, 1}}, body, cameras, one, 1));
}

TEST(Prediction, HasTheCovarianceOfDrawnStatesAndPoses) {
  BodyFilter filter({1e-4, 1e-5, 1e-3, 1e-6});
  const double dt = 0.02;
  const BodyState state{{0.9, -1.4, 2}, {0.3, 0.2, -0.4}, {1, -2, 1}};
  MeasuredPose last{{turned_by({0.3, 0.2, 0.1}), {0.1, 0.2, 1}}};
  last.covariance.diagonal() << 1e-6, 2e-6, 1e-6, 1e-5, 2e-5, 1e-5;
  for (int i = 0; i < 8; ++i) {
    const BodyPose after = moved(state, dt, last.pose);
    filter.frame(dt, virtual_points(last.pose, 0.1), virtual_points(after, 0.1));
    last.pose = after;
  }
  const MeasuredPose predicted = predicted_pose(filter, dt, last);
  const BodyFilter::Covariance P = filter.next_covariance(dt);
  const Eigen::SelfAdjointEigenSolver<BodyFilter::Covariance> root(P);
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  Eigen::Matrix<double, 6, 6> C = Eigen::Matrix<double, 6, 6>::Zero();
  const int draws = 4000;
  for (int i = 0; i < draws; ++i) {
    Eigen::Matrix<double, 9, 1> e;
    for (double& x : e) x = normal(random);
    e = (root.operatorSqrt() * e).eval();
    BodyState s = filter.next(dt);
    s.omega += e.head<3>();
    s.v += e.segment<3>(3);
    s.a += e.tail<3>();
    Eigen::Matrix<double, 6, 1> d;
    for (double& x : d) x = normal(random);
    d.array() *= last.covariance.diagonal().array().sqrt();
    const BodyPose from{turned_by(d.tail<3>()) * last.pose.R,
                        last.pose.t + d.head<3>()},
        is = moved(s, dt, from);
    Eigen::Matrix<double, 6, 1> off;
    off << is.t - predicted.pose.t, turn_of(is.R * predicted.pose.R.transpose());
    C += off * off.transpose() / draws;
  }
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j <= i; ++j) {
      const auto& p = predicted.covariance;
      EXPECT_NEAR(C(i, j), p(i, j),
                  5 * std::sqrt((p(i, i) * p(j, j) + p(i, j) * p(i, j)) / draws))
          << i << ", " << j;
    }
  // What is seen falls into the windows.
  const Camera camera = stereo_rig()[0];
  const auto window = search_window(camera, predicted, {0.05, 0.02, 0}, 0.3);
  ASSERT_TRUE(window);
  EXPECT_LT(window->distance(window->centre + Eigen::Vector2d(0.1, 0)), 0.2);
  EXPECT_NEAR(window->distance(window->centre + std::sqrt(window->covariance(0, 0)) *
                                                    Eigen::Vector2d::UnitX()),
              window->covariance(0, 0) * window->covariance.inverse()(0, 0), 1e-9);
}

/// Among reflections, from the first frame on; then in small windows.
TEST(Tracker, FollowsABodyAmongReflections) {
  for (const ComparedMotion& motion : compared_motions()) {
    TrackerOptions options;
    options.noise = {0.1, 0.01, 10, 1e-6};
    BodyTracker tracker(stereo_rig(), marker_body(), options);
    EXPECT_FALSE(tracker.predicted(0.01));
    double squares = 0, area = 0, dt = 1 / 60.;
    int by_windows = 0;
    for (int k = 0; k < 60; ++k) {
      const BodyPose truth = motion.at(k * dt, 0.3);
      const TrackedFrame frame =
          tracker.frame(dt, drawn_images(stereo_rig(), truth, {.reflections = 6},
                                         static_cast<std::uint64_t>(k)));
      ASSERT_TRUE(frame.measured) << motion.name << " " << k;
      EXPECT_GE(frame.markers, 3u);
      squares += (frame.measured->pose.t - truth.t).squaredNorm();
      EXPECT_LT(turn_of(frame.measured->pose.R * truth.R.transpose()).norm(), 0.05);
      by_windows += frame.by_windows;
      if (k >= 10) area += frame.window_area / 50;
    }
    EXPECT_LT(std::sqrt(squares / 60), 1e-3) << motion.name;
    EXPECT_GE(by_windows, 55) << motion.name;
    EXPECT_LT(area, 0.2) << motion.name;
    ASSERT_TRUE(tracker.predicted(dt));
    EXPECT_LT((tracker.predicted(dt)->t - motion.at(60 * dt, 0.3).t).norm(), 0.01)
        << motion.name;
  }
}

/// Nothing is seen for a while: it coasts, and finds the body again; for long: it
/// begins anew.
TEST(Tracker, CoastsAndFindsTheBodyAgain) {
  const ComparedMotion& motion = compared_motions().front();
  TrackerOptions options;
  options.noise = {0.1, 0.01, 10, 1e-6};
  BodyTracker tracker(stereo_rig(), marker_body(), options);
  const double dt = 1 / 60.;
  const auto at = [&](int k) {
    return drawn_images(stereo_rig(), motion.at(k * dt, 0), {},
                        static_cast<std::uint64_t>(k));
  };
  const std::vector<std::vector<Eigen::Vector2d>> nothing(2);
  for (int k = 0; k < 30; ++k) tracker.frame(dt, at(k));
  for (int k = 30; k < 33; ++k) EXPECT_FALSE(tracker.frame(dt, nothing).measured);
  ASSERT_TRUE(tracker.predicted(dt));
  // In these four frames it goes 7 cm.
  EXPECT_LT((tracker.predicted(dt)->t - motion.at(33 * dt, 0).t).norm(), 0.04);
  EXPECT_TRUE(tracker.frame(dt, at(33)).measured);
  for (int k = 34; k < 44; ++k) tracker.frame(dt, nothing);
  EXPECT_FALSE(tracker.predicted(dt));
  EXPECT_TRUE(tracker.frame(dt, at(44)).measured);
}

}  // namespace
}  // namespace delos::rigid_body
