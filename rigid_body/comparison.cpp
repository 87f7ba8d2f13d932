#include "delos/rigid_body/comparison.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "delos/rigid_body/apart.h"
#include "delos/rigid_body/refine.h"
#include "delos/rigid_body/tracker.h"

namespace delos::rigid_body {
namespace {

double wave(double hertz, double t, double phase) {
  return std::sin(2 * std::numbers::pi * hertz * t + phase);
}

const Eigen::Vector3d kMiddle(0, 0, 1), kJoint(0, 0, 0.75);

BodyPose swinging(double t, double phase) {
  BodyPose pose;
  pose.R = turned_by({0.8 * wave(0.8, t, phase), 0, 0.4 * wave(0.5, t, 2 * phase)});
  pose.t = kJoint + pose.R * Eigen::Vector3d(0, 0, 0.3);
  return pose;
}

BodyPose looking(double t, double phase) {
  BodyPose pose;
  pose.R = turned_by({0, 0, 0.7 * wave(0.5, t, phase)}) *
           turned_by({0.25 * wave(0.9, t, 3 * phase), 0, 0});
  pose.t = kMiddle + Eigen::Vector3d(0.25 * wave(0.3, t, 2 * phase), 0,
                                     0.02 * wave(1.8, t, phase));
  return pose;
}

BodyPose spinning(double t, double phase) {
  BodyPose pose;
  pose.R = turned_by((4 * t + phase) * Eigen::Vector3d(0.3, 0.5, 0.8).normalized());
  pose.t =
      kMiddle + 0.2 * Eigen::Vector3d(wave(0.4, t, phase), wave(0.4, t, phase + 1.57),
                                      0.3 * wave(0.7, t, phase));
  return pose;
}

BodyPose shaking(double t, double phase) {
  const auto mix = [&](double a, double b, double c, double shift) {
    return (wave(a, t, phase + shift) + wave(b, t, 2 * phase + shift) +
            wave(c, t, 3 * phase - shift)) /
           3;
  };
  BodyPose pose;
  pose.R = turned_by(0.3 * Eigen::Vector3d(mix(1.1, 2.3, 3.7, 0), mix(0.9, 2.9, 3.3, 1),
                                           mix(1.3, 2.1, 3.1, 2)));
  pose.t =
      kMiddle + 0.06 * Eigen::Vector3d(mix(0.7, 1.9, 3.5, 3), mix(1.2, 2.2, 2.7, 4),
                                       mix(0.8, 1.7, 2.6, 5));
  return pose;
}

Eigen::Vector3d drawn3(std::mt19937_64& random, double sigma) {
  std::normal_distribution<double> normal(0, sigma);
  const double x = normal(random), y = normal(random), z = normal(random);
  return {x, y, z};
}

/// ω of a motion in W, and the acceleration of its origin, by central differences.
void inertial_truth(const ComparedMotion& motion, double t, double phase,
                    Eigen::Vector3d& omega, Eigen::Vector3d& acceleration) {
  const double h = 1e-3;
  const BodyPose before = motion.at(t - h, phase), now = motion.at(t, phase),
                 after = motion.at(t + h, phase);
  omega = turn_of(after.R * before.R.transpose()) / (2 * h);
  acceleration = (after.t - 2 * now.t + before.t) / (h * h);
}

/// A formulation that takes in frames.
class Predictor {
 public:
  Predictor(const MeasuredRun& run, Formulation formulation, bool inertial,
            const Tuning& tuning)
      : run_(run), formulation_(formulation), inertial_(inertial) {
    for (std::size_t i = 0; i < 5; ++i) variance_[i] = std::pow(10, tuning.log10[i]);
    apart_ =
        ApartFilter({variance_[0], variance_[1], variance_[2], run.turn, run.place});
    // Three points at an arm L with the variance σ² know 3/σ² of a place and 2L²/σ² of
    // a turn about any axis: as much as the pose if
    const double point = 3 * run.place;
    arm_ = std::sqrt(point / (2 * run.turn));
    joint_ = BodyFilter({variance_[0], variance_[1], variance_[2], point});
  }

  /// Where frame k, just taken in, has the body a lag later.
  BodyPose take(std::size_t k) {
    const BodyPose& now = run_.measured[k];
    if (k == 0 || formulation_ == Formulation::none) return now;
    const BodyPose& before = run_.measured[k - 1];
    if (formulation_ == Formulation::apart) {
      apart_.frame(run_.dt, before, now);
      if (inertial_) {
        apart_.gyroscope(run_.omega[k], variance_[3]);
        apart_.accelerometer(run_.acceleration[k], variance_[4]);
      }
      return apart_.moved(run_.dt, run_.lag, now);
    }
    const auto centred = [&](const BodyPose& pose, const BodyPose& about) -> BodyPose {
      if (formulation_ == Formulation::joint) return {pose.R, pose.t - run_.origin};
      return {pose.R, pose.t - about.t};
    };
    joint_.frame(run_.dt, virtual_points(centred(before, before), arm_),
                 virtual_points(centred(now, before), arm_));
    if (inertial_) {
      joint_.gyroscope(run_.omega[k], variance_[3]);
      joint_.accelerometer(run_.dt, centred(now, before).t, run_.acceleration[k],
                           variance_[4]);
    }
    BodyPose shown = moved(joint_.next(run_.dt), run_.lag, centred(now, now));
    shown.t += formulation_ == Formulation::joint ? run_.origin : now.t;
    return shown;
  }

 private:
  const MeasuredRun& run_;
  Formulation formulation_;
  bool inertial_;
  double variance_[5], arm_ = 0;
  ApartFilter apart_;
  BodyFilter joint_;
};

}  // namespace

const std::vector<ComparedMotion>& compared_motions() {
  static const std::vector<ComparedMotion> all = {
      {"swing", "from a joint 30 cm away, ±46° at 0.8 Hz and ±23° at 0.5 Hz", swinging},
      {"swing, origin at the joint", "the same", swinging, kJoint},
      {"look about", "yaw ±40° at 0.5 Hz, pitch ±14° at 0.9 Hz; ±25 cm aside at 0.3 Hz",
       looking},
      {"spin", "4 rad/s about itself, on a round of 20 cm at 0.4 Hz", spinning},
      {"shake", "about ±10° and ±3 cm of sines from 0.7 to 3.7 Hz", shaking},
  };
  return all;
}

std::vector<Camera> stereo_rig() {
  return {looking_at({-1.1, -1.1, 1.4}, kMiddle),
          looking_at({1.1, -1.1, 1.4}, kMiddle)};
}

std::vector<Eigen::Vector3d> marker_body() {
  return {{0.07, 0, 0},
          {-0.05, 0.05, 0},
          {-0.03, -0.07, 0.01},
          {0, 0.02, 0.08},
          {0.04, 0.06, -0.05}};
}

std::vector<std::vector<Eigen::Vector2d>> drawn_images(
    const std::vector<Camera>& cameras, const BodyPose& pose, const ReadingNoise& noise,
    std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal(0, noise.image);
  std::uniform_real_distribution<double> even(0, 1);
  std::vector<std::vector<Eigen::Vector2d>> images(cameras.size());
  for (std::size_t c = 0; c < cameras.size(); ++c) {
    for (const Eigen::Vector3d& marker : marker_body()) {
      const auto uv = image_of(cameras[c], pose.R * marker + pose.t);
      const double du = normal(random), dv = normal(random);
      if (uv) images[c].push_back(*uv + Eigen::Vector2d(du, dv));
    }
    for (int i = 0; i < noise.reflections; ++i) {
      const double u = even(random), v = even(random);
      images[c].push_back(cameras[c].size.cwiseProduct(Eigen::Vector2d(u, v)));
    }
    for (std::size_t i = images[c].size(); i > 1; --i)
      std::swap(
          images[c][i - 1],
          images[c][static_cast<std::size_t>(even(random) * static_cast<double>(i))]);
  }
  return images;
}

MeasuredRun measured_run(const ComparedMotion& motion, double rate, double lag,
                         double seconds, std::uint64_t seed,
                         const ReadingNoise& noise) {
  const std::vector<Camera> cameras = stereo_rig();
  std::mt19937_64 random(seed);
  const double phase =
      2 * std::numbers::pi * std::uniform_real_distribution<double>(0, 1)(random);
  MeasuredRun run{1 / rate, lag, {}, {}, {}, {}, 0, 0, 0, motion.origin};
  // In seconds: of what a hand may do in a frame.
  TrackerOptions options;
  options.sigma = noise.image;
  options.noise = {0.1, 0.01, 10, 1e-6};
  BodyTracker tracker(cameras, marker_body(), options);
  for (int k = 0; k < static_cast<int>(seconds * rate); ++k) {
    const double t = k * run.dt;
    const std::uint64_t frame_seed = random();
    const TrackedFrame frame = tracker.frame(
        run.dt, drawn_images(cameras, motion.at(t, phase), noise, frame_seed));
    Eigen::Vector3d omega, acceleration;
    inertial_truth(motion, t, phase, omega, acceleration);
    omega += drawn3(random, noise.gyroscope);
    acceleration += drawn3(random, noise.accelerometer);
    if (!frame.measured) {
      ++run.lost;
      continue;
    }
    run.measured.push_back(frame.measured->pose);
    run.shown.push_back(motion.at(t + lag, phase));
    run.omega.push_back(omega);
    run.acceleration.push_back(acceleration);
    run.place += frame.measured->covariance.topLeftCorner<3, 3>().trace() / 3;
    run.turn += frame.measured->covariance.bottomRightCorner<3, 3>().trace() / 3;
  }
  const auto frames =
      static_cast<double>(std::max<std::size_t>(1, run.measured.size()));
  run.place /= frames;
  run.turn /= frames;
  return run;
}

const char* to_string(Formulation formulation) {
  switch (formulation) {
    case Formulation::none:
      return "no filter";
    case Formulation::apart:
      return "apart";
    case Formulation::joint:
      return "joint";
    case Formulation::joint_about_body:
      return "joint, about the body";
  }
  return "";
}

double pixel_error(const MeasuredRun& run, Formulation formulation, bool inertial,
                   const Tuning& tuning) {
  Camera display = looking_at(kMiddle + Eigen::Vector3d(0, -1.2, 0.2), kMiddle);
  display.focal = 1000;
  display.centre = display.size = {1e4, 1e4};  // all is shown, far off as it may be
  display.size *= 2;
  Predictor predictor(run, formulation, inertial, tuning);
  const auto first = static_cast<std::size_t>(std::ceil(0.5 / run.dt));
  double squares = 0;
  std::size_t count = 0;
  for (std::size_t k = 0; k < run.measured.size(); ++k) {
    const BodyPose shown = predictor.take(k);
    if (k < first) continue;
    for (int corner = 0; corner < 8; ++corner) {
      const Eigen::Vector3d b =
          0.15 * Eigen::Vector3d(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1,
                                 corner & 4 ? 1 : -1);
      const auto is = image_of(display, run.shown[k].R * b + run.shown[k].t),
                 seems = image_of(display, shown.R * b + shown.t);
      if (!is) continue;
      squares += seems ? (*seems - *is).squaredNorm() : 1e8;
      ++count;
    }
  }
  return std::sqrt(squares / static_cast<double>(count));
}

Tuning tuned(const std::vector<MeasuredRun>& runs, Formulation formulation,
             bool inertial) {
  const auto cost = [&](const Tuning& tuning) {
    double squares = 0;
    for (const MeasuredRun& run : runs)
      squares += std::pow(pixel_error(run, formulation, inertial, tuning), 2);
    return squares;
  };
  Tuning best;
  if (formulation == Formulation::none) return best;
  double least = cost(best);
  for (double step = 1; step >= 0.25; step /= 2) {
    for (bool moves = true; moves;) {
      moves = false;
      for (std::size_t i = 0; i < (inertial ? 5u : 3u); ++i)
        for (const double way : {step, -step}) {
          Tuning other = best;
          other.log10[i] += way;
          if (other.log10[i] < -12 || other.log10[i] > 6) continue;
          const double is = cost(other);
          if (!(is < least * (1 - 1e-6))) continue;
          least = is;
          best = other;
          moves = true;
        }
    }
  }
  return best;
}

}  // namespace delos::rigid_body
