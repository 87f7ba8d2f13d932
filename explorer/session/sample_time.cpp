#include "session/sample_time.h"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "delos/device/faults.h"
#include "delos/field/evaluate.h"
#include "delos/layers/layers.h"
#include "delos/model/infinity.h"
#include "delos/scene/definition.h"

namespace delos::session {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kFewRows = 6;

/// The devices that are asked about: indices.
std::vector<std::size_t> asked_about(const Scene& scene, const std::string& device) {
  std::vector<std::size_t> devices;
  for (std::size_t i = 0; i < scene.devices.size(); ++i) {
    const DeviceEntry& entry = scene.devices[i];
    if (device.empty() ? entry.noise_over_time.has_value() : entry.name == device)
      devices.push_back(i);
  }
  if (devices.empty())
    throw std::invalid_argument(
        device.empty() ? "no device says how its noise falls with the time that it "
                         "samples; give one 'noise_over_time', or name it by --device"
                       : "there is no device '" + device + "'");
  return devices;
}

/// Stacked devices report together, whatever they sample for.
/// @throws std::invalid_argument they would part
void check_rates(Scene scene, const std::vector<std::size_t>& devices,
                 const std::vector<double>& times) {
  if (definition_of(scene).fusion != Fusion::stacked) return;
  for (const double time : {times.front(), times.back()}) {
    for (const std::size_t i : devices) scene.devices[i].exposure = time;
    const double rate = rate_of(scene.devices.front());
    for (const DeviceEntry& entry : scene.devices)
      if (std::abs(rate_of(entry) - rate) > 1e-9 * rate)
        throw std::invalid_argument("stacked fusion needs one rate, but " + entry.name +
                                    " and " + scene.devices.front().name +
                                    " would have different ones; let all devices with "
                                    "`timing` change together, "
                                    "or use fusion: periodic");
  }
}

double noise_of(const DeviceEntry& entry, double time) {
  return entry.noise_over_time ? noise_ratio(*entry.noise_over_time, time) : 1;
}

double update_of(const DeviceEntry& entry, double time) {
  return entry.timing ? period_of(*entry.timing, time) : 1 / entry.rate;
}

/// One row of a device, as functions of the sample time.
struct RowCurves {
  const DeviceEntry& entry;
  const SampleTimeQuestion& question;
  int order;
  double noise_now;    // R / ratio: of a ratio of one
  double spread;       // h q hᵀ
  double sensitivity;  // |h| along the positions

  [[nodiscard]] double noise(double time) const {
    const double R = noise_now * noise_of(entry, time);
    return question.deviations ? std::sqrt(R) : R;
  }
  [[nodiscard]] double motion(double time) const {
    const double V = [&] {
      const auto of = [&](ExposureModel model, double over) {
        return spread * motion_variance(model, order, over);
      };
      switch (question.motion) {
        case MotionTerm::exact:
          break;
        case MotionTerm::instantaneous:
          return of(ExposureModel::instantaneous, time);
        case MotionTerm::averaged:
          return of(ExposureModel::averaged, time);
        case MotionTerm::integrated:
          return of(ExposureModel::integrated, time);
        case MotionTerm::update:
          return of(ExposureModel::instantaneous, update_of(entry, time));
        case MotionTerm::blur: {
          const double way = sensitivity * question.speed * time;
          return way * way;
        }
      }
      return of(ExposureModel::exact, time);
    }();
    return question.deviations ? std::sqrt(V) : V;
  }
  [[nodiscard]] double sum(double time) const { return noise(time) + motion(time); }
};

/// The least of a function of the time between the drawn times beside its least drawn.
struct Least {
  double at, value;
  bool end;
  std::size_t drawn;
};

template <class F>
Least least_of(const std::vector<double>& times, const std::vector<double>& values,
               const F& f) {
  std::size_t i = 0;
  for (std::size_t j = 1; j < values.size(); ++j)
    if (values[j] < values[i] || std::isnan(values[i])) i = j;
  const std::size_t before = i == 0 ? 0 : i - 1,
                    after = std::min(i + 1, times.size() - 1);
  constexpr int kBits = 30;  // of a variable that a minimum depends on quadratically
  const auto [log_time, value] = boost::math::tools::brent_find_minima(
      [&](double x) { return f(std::exp(x)); }, std::log(times[before]),
      std::log(times[after]), kBits);
  const bool end = i == 0 || i + 1 == times.size();
  if (values[i] <= value) return {times[i], values[i], end, i};
  return {std::exp(log_time), value, false, i};
}

std::optional<double> crossover_of(const RowCurves& curves,
                                   const std::vector<double>& times) {
  const auto above = [&](double t) { return curves.noise(t) > curves.motion(t); };
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    if (!above(times[i]) || above(times[i + 1])) continue;
    double low = times[i], high = times[i + 1];
    for (int halvings = 0; halvings < 60; ++halvings) {
      const double middle = std::sqrt(low * high);
      (above(middle) ? low : high) = middle;
    }
    return low;
  }
  return std::nullopt;
}

/// P∞'s metric at a point as a function of the sample time.
class MetricOverTime {
 public:
  MetricOverTime(const LoadedScene& loaded, const Eigen::Vector3d& at,
                 const std::vector<std::size_t>& devices, double q_factor,
                 PluginRegistry& plugins)
      : loaded_(loaded), scene_(loaded.scene), devices_(devices), plugins_(plugins) {
    std::get<ChainMotion>(scene_.motion.dynamics).q *= q_factor;
    point_.points = {at};
    point_.parts = {{"", 0, 1, ScatteredShape{}}};
  }

  /// NaN where it can't be had.
  [[nodiscard]] double operator()(double time) const {
    for (const std::size_t i : devices_) scene_.devices[i].exposure = time;
    try {
      const System system = build_system(scene_, plugins_, &loaded_.system);
      FieldOptions options;
      options.threads = 1;
      options.find_inside = false;
      const double value =
          evaluate_field(system, point_, {}, loaded_.metric, options).value.front();
      return std::isfinite(value) ? value : kNothing;
    } catch (const Unbuildable&) {
      return kNothing;
    }
  }
  /// The same, as what is to be small.
  [[nodiscard]] double cost(double time) const {
    const double value = (*this)(time);
    if (std::isnan(value)) return std::numeric_limits<double>::max();
    return loaded_.metric.larger_is_better ? -value : value;
  }

 private:
  const LoadedScene& loaded_;
  mutable Scene scene_;
  const std::vector<std::size_t>& devices_;
  PluginRegistry& plugins_;
  Samples point_;
};

std::vector<double> drawn(const std::vector<double>& times, const auto& f) {
  std::vector<double> values;
  for (const double t : times) values.push_back(f(t));
  return values;
}

/// The curves of every row that the devices measure, or, of a device with many, of the
/// one that informs most.
std::vector<std::pair<SampleTimeRow, RowCurves>> rows_at(
    const LoadedScene& loaded, const Eigen::Vector3d& at,
    const std::vector<std::size_t>& devices, const SampleTimeQuestion& question) {
  const WhitenedRows all =
      whitened_rows(loaded.system, {Eigen::Matrix3d::Identity(), at});
  const auto& q = std::get<ChainMotion>(loaded.scene.motion.dynamics).q;
  const Eigen::Index d = q.rows();
  std::vector<std::pair<SampleTimeRow, RowCurves>> found;
  for (const std::size_t i : devices) {
    const DeviceEntry& entry = loaded.scene.devices[i];
    std::vector<std::pair<SampleTimeRow, RowCurves>> own;
    std::size_t most = 0;
    double information = -1;
    for (Eigen::Index r = 0; r < all.rows.rows(); ++r) {
      const auto index = static_cast<std::size_t>(r);
      if (all.device[index] != static_cast<int>(i)) continue;
      const double R = all.variance[index];
      const Eigen::RowVectorXd h =
          all.rows.row(r).head(d) * std::sqrt(R / all.share[index]);
      const double spread = h * q * h.transpose();
      own.emplace_back(
          SampleTimeRow{entry.name, own.size()},
          RowCurves{entry, question, loaded.scene.motion.layout.order,
                    R / noise_of(entry, entry.exposure), spread,
                    h.head(loaded.scene.motion.layout.positions()).norm()});
      if (spread / R <= information) continue;
      information = spread / R;
      most = own.size() - 1;
    }
    const std::size_t count = own.size();
    if (count > kFewRows) {
      std::vector<std::pair<SampleTimeRow, RowCurves>> one{own[most]};
      own.swap(one);
    }
    for (auto& [row, curves] : own) {
      row.rows = count;
      found.emplace_back(row, curves);
    }
  }
  if (found.empty())
    throw std::invalid_argument("none of these devices measures anything there");
  return found;
}

}  // namespace

const char* to_string(MotionTerm term) {
  switch (term) {
    case MotionTerm::exact:
      return "exact";
    case MotionTerm::instantaneous:
      return "instantaneous";
    case MotionTerm::averaged:
      return "averaged";
    case MotionTerm::integrated:
      return "integrated";
    case MotionTerm::update:
      return "update";
    case MotionTerm::blur:
      return "blur";
  }
  return "";
}

std::vector<double> usual_times(const Scene& scene, const std::string& device) {
  double longest = kInfinity, usual = kInfinity;
  for (const std::size_t i : asked_about(scene, device)) {
    const DeviceEntry& entry = scene.devices[i];
    if (!entry.timing) longest = std::min(longest, 1 / entry.rate);
    const double at = entry.noise_over_time ? entry.noise_over_time->at : 0;
    for (const double known : {entry.exposure, at})
      if (known > 0) usual = std::min(usual, known);
  }
  if (std::isinf(usual)) usual = std::isinf(longest) ? 1e-3 : longest;
  const double from = std::min(usual, longest) / 30, to = std::min(30 * usual, longest);
  std::vector<double> times(100);
  for (std::size_t i = 0; i < times.size(); ++i)
    times[i] = from * std::pow(to / from, static_cast<double>(i) / 99);
  return times;
}

SampleTimeAnswer answer_sample_time(const LoadedScene& loaded,
                                    const Eigen::Vector3d& at,
                                    const SampleTimeQuestion& question,
                                    PluginRegistry& plugins) {
  if (!loaded.scene.motion.is_chain())
    throw std::invalid_argument(
        "sample times are weighed for position, position_velocity and "
        "position_velocity_acceleration motion");
  const std::vector<std::size_t> devices = asked_about(loaded.scene, question.device);
  SampleTimeAnswer answer;
  check_rates(loaded.scene, devices, question.times);
  answer.question = question;
  answer.at = at;
  const std::vector<double>& times = question.times;

  const auto rows = rows_at(loaded, at, devices, question);

  const MetricOverTime metric(loaded, at, devices, 1, plugins);
  const auto cost = [](const MetricOverTime& of) {
    return [&of](double t) { return of.cost(t); };
  };
  answer.metric = drawn(times, metric);
  const Least best = least_of(times, drawn(times, cost(metric)), cost(metric));
  answer.best = best.at;
  answer.least = metric(best.at);
  answer.at_end = best.end;

  const RowCurves* informs_most = &rows.front().second;
  double most = -1;
  for (const auto& measured : rows) {
    SampleTimeRow out = measured.first;
    const RowCurves& curves = measured.second;
    out.noise = drawn(times, [&](double t) { return curves.noise(t); });
    out.motion = drawn(times, [&](double t) { return curves.motion(t); });
    out.sum = drawn(times, [&](double t) { return curves.sum(t); });
    const Least least =
        least_of(times, out.sum, [&](double t) { return curves.sum(t); });
    out.best = least.at;
    out.least = least.value;
    out.at_end = least.end;
    out.best_drawn = least.drawn;
    out.crossover = crossover_of(curves, times);
    out.metric_at_best = metric(out.best);
    if (out.crossover) out.metric_at_crossover = metric(*out.crossover);
    answer.rows.push_back(out);
    if (curves.spread / curves.noise_now <= most) continue;
    most = curves.spread / curves.noise_now;
    informs_most = &curves;
  }

  for (const double factor : {0.01, 0.1, 1.0, 10.0, 100.0}) {
    const MetricOverTime of(loaded, at, devices, factor, plugins);
    RowCurves curves = *informs_most;
    curves.spread *= factor;
    curves.sensitivity *= std::sqrt(factor);
    const auto sum = [&](double t) { return curves.sum(t); };
    answer.of_motion.push_back({factor,
                                least_of(times, drawn(times, cost(of)), cost(of)).at,
                                least_of(times, drawn(times, sum), sum).at});
  }
  return answer;
}

Json sample_time_json(const std::vector<SampleTimeAnswer>& answers,
                      const LoadedScene& loaded) {
  const auto list = [](const std::vector<double>& values) {
    Json all = Json::array();
    for (const double v : values) all.push_back(number(v));
    return all;
  };
  const auto maybe = [](const std::optional<double>& value) {
    return value ? number(*value) : Json();
  };
  Json json{{"scene", loaded.scene.name},
            {"fusion", to_string(loaded.system.fusion)},
            {"covariance", to_string(loaded.system.covariance)},
            {"metric", loaded.metric.name},
            {"unit", loaded.metric.unit},
            {"points", Json::array()}};
  for (const SampleTimeAnswer& answer : answers) {
    Json point{{"at", numbers(answer.at)},
               {"motion", to_string(answer.question.motion)},
               {"sum_of", answer.question.deviations ? "deviations" : "variances"},
               {"times", list(answer.question.times)},
               {"rows", Json::array()}};
    for (const SampleTimeRow& row : answer.rows)
      point["rows"].push_back(
          {{"device", row.device},
           {"row", row.row},
           {"rows", row.rows},
           {"noise", list(row.noise)},
           {"motion", list(row.motion)},
           {"sum", list(row.sum)},
           {"optimum", number(row.best)},
           {"least", number(row.least)},
           {"at_end", row.at_end},
           {"best_drawn", row.best_drawn},
           {"crossover", maybe(row.crossover)},
           {"metric_at_optimum", number(row.metric_at_best)},
           {"metric_at_crossover", maybe(row.metric_at_crossover)}});
    point["metric"] = {{"values", list(answer.metric)},
                       {"optimum", number(answer.best)},
                       {"value", number(answer.least)},
                       {"at_end", answer.at_end}};
    point["of_motion"] = Json::array();
    for (const SampleTimeOfMotion& of : answer.of_motion)
      point["of_motion"].push_back({{"q_factor", of.factor},
                                    {"optimum", number(of.best)},
                                    {"rule", number(of.rule)}});
    json["points"].push_back(point);
  }
  return json;
}

}  // namespace delos::session
