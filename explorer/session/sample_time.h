// How long a device should sample: at one reading, and in P∞.
//
// Source of the method: Welch, Allen, Ilie, Bishop (2007), and Allen (2007), §6.2,
// §7.3.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "session/json.h"
#include "session/loaded_scene.h"

namespace delos::session {

/// The motion that is weighed against the noise of a reading.
enum class MotionTerm {
  exact,          ///< ExposureModel::exact over the sample time
  instantaneous,  ///< ExposureModel::instantaneous over the sample time
  averaged,       ///< ExposureModel::averaged over the sample time
  integrated,     ///< ExposureModel::integrated over the sample time
  update,         ///< ExposureModel::instantaneous over the whole update, δt
  blur,           ///< the way at a given speed in the worst direction, as a deviation
};

struct SampleTimeQuestion {
  std::vector<double> times;  ///< τ, seconds, ascending, > 0; where curves are drawn
  MotionTerm motion = MotionTerm::exact;
  double speed = 0;         ///< of blur, m/s
  bool deviations = false;  ///< standard deviations are added, not variances
  std::string device;       ///< the only one that is asked about; empty: all that have
                            ///< noise_over_time
};

/// R, HQHᵀ and their sum of one row that a device measures, along the times: variances
/// in the device's unit squared, or, where asked for, standard deviations.
struct SampleTimeRow {
  std::string device;
  std::size_t row = 0;   ///< of the device's, from 0
  std::size_t rows = 0;  ///< that it has there; of many, this one informs most
  std::vector<double> noise = {}, motion = {}, sum = {};
  double best = 0, least = 0;            ///< where the sum is least, and how much it is
  std::optional<double> crossover = {};  ///< where noise and motion are equal
  bool at_end = false;                   ///< the sum falls up to an end of the times
  std::size_t best_drawn = 0;            ///< the least of those drawn
  double metric_at_best = 0;             ///< P∞'s, all asked about sampling so long
  std::optional<double> metric_at_crossover = {};
};

/// The best sample time where the motion is so many times as vivid.
struct SampleTimeOfMotion {
  double factor = 1;  ///< of q
  double best = 0;    ///< of P∞, seconds
  double rule = 0;    ///< of the sum of the row that informs most, seconds
};

struct SampleTimeAnswer {
  SampleTimeQuestion question;
  Eigen::Vector3d at;  ///< metres
  std::vector<SampleTimeRow> rows;
  std::vector<double> metric;  ///< P∞'s along the times; NaN where it can't be had
  double best = 0, least = 0;  ///< where P∞'s metric is best, and what it is
  bool at_end = false;
  std::vector<SampleTimeOfMotion> of_motion;
};

/// Ask at one point, with all devices that are asked about sampling equally long.
/// @throws std::invalid_argument a sentence: nothing to ask about, or it can't be
/// solved
[[nodiscard]] SampleTimeAnswer answer_sample_time(const LoadedScene& loaded,
                                                  const Eigen::Vector3d& at,
                                                  const SampleTimeQuestion& question,
                                                  PluginRegistry& plugins);

/// A range of sample times that has the usual ones of the devices well inside, up to
/// the longest that fits: a hundred in equal proportions.
/// @throws std::invalid_argument as answer_sample_time()
[[nodiscard]] std::vector<double> usual_times(const Scene& scene,
                                              const std::string& device);

[[nodiscard]] const char* to_string(MotionTerm term);

[[nodiscard]] Json sample_time_json(const std::vector<SampleTimeAnswer>& answers,
                                    const LoadedScene& loaded);

}  // namespace delos::session
