#include "motion/motion_fit.h"

#include <cmath>
#include <cstdio>
#include <vector>

#include "delos/text/format.h"
#include "delos/text/units.h"

namespace delos::motion {
namespace {

/// Three digits are more than any record gives.
std::string digits(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

/// The frames that count of one axis.
std::vector<double> taken(const recordings::Track& track, Eigen::Index axis,
                          Eigen::Index first, Eigen::Index end, Eigen::Index stride) {
  std::vector<double> z;
  z.reserve(static_cast<std::size_t>((end - first) / stride + 1));
  for (Eigen::Index i = first; i < end; i += stride) z.push_back(track.at(i, axis));
  return z;
}

OrderFit over_axes(const std::array<std::array<ChainFit, kOrders>, 3>& axes,
                   std::size_t order, double count) {
  OrderFit fit;
  double box = 0, degrees = 0;
  for (std::size_t a = 0; a < 3; ++a) {
    fit.axes[a] = axes[a][order];
    fit.bayes += fit.axes[a].minus_2_log_likelihood;
    box += fit.axes[a].ljung_box;
    degrees += fit.axes[a].lags - 2;
  }
  fit.bayes += 6 * std::log(3 * count);
  fit.p_value = chi_squared_tail(box, degrees);
  return fit;
}

}  // namespace

std::variant<MotionFit, std::string> fit_motion(const recordings::Track& track,
                                                double period,
                                                const FitQuestion& question) {
  MotionFit fit;
  fit.track = track.name;
  const double wanted = question.interval > 0 ? question.interval / period : 1;
  const double whole = std::max(1.0, std::round(wanted));
  if (std::abs(wanted - whole) > 0.05 * whole)
    return "frames are " + format_quantity(period, "s") + " apart, of which " +
           format_quantity(question.interval, "s") +
           " isn't a multiple; choose one, such as " +
           format_quantity(period * whole, "s");
  const auto stride = static_cast<Eigen::Index>(whole);
  fit.dt = period * whole;
  const Eigen::Index frames = track.at.rows();
  const auto frame_at = [&](double seconds) {
    return static_cast<Eigen::Index>(std::clamp(std::ceil(seconds / period - 1e-9), 0.0,
                                                static_cast<double>(frames)));
  };
  const Eigen::Index first = frame_at(question.from),
                     end = question.to ? frame_at(*question.to) : frames;

  std::array<std::array<ChainFit, kOrders>, 3> axes;
  std::array<std::vector<double>, 3> z;
  std::size_t seen = 0, still = 0;
  for (std::size_t a = 0; a < 3; ++a) {
    z[a] = taken(track, static_cast<Eigen::Index>(a), first, end, stride);
    seen = 0;
    double low = INFINITY, high = -INFINITY;
    for (const double v : z[a]) {
      if (std::isnan(v)) continue;
      ++seen;
      low = std::min(low, v);
      high = std::max(high, v);
    }
    if (seen < static_cast<std::size_t>(kFewestFrames))
      return "only " + std::to_string(seen) + " frames of '" + track.name +
             "' count; at least " + std::to_string(kFewestFrames) +
             " are needed to tell one motion from another";
    if (!(high > low)) ++still;
  }
  if (still > 0)
    return "'" + track.name + "' has the same place in all frames along " +
           std::to_string(still) +
           " of its axes: a target that doesn't move, or a placeholder; nothing can be "
           "fitted to it";
  fit.frames = z[0].size();
  fit.gaps = z[0].size() - seen;
  for (std::size_t a = 0; a < 3; ++a) axes[a] = fit_chains(z[a], fit.dt);
  for (std::size_t k = 0; k < kOrders; ++k) {
    fit.orders[k] = over_axes(axes, k, static_cast<double>(seen));
    const bool white = fit.orders[k].p_value >= question.significance;
    const auto less = [&](int than) {
      return fit.orders[k].bayes < fit.orders[static_cast<std::size_t>(than)].bayes;
    };
    if (less(fit.likeliest)) fit.likeliest = static_cast<int>(k);
    if (white && (!fit.fits || less(fit.best))) fit.best = static_cast<int>(k);
    fit.fits = fit.fits || white;
  }
  if (!fit.fits) fit.best = fit.likeliest;
  const OrderFit& best = fit.orders[static_cast<std::size_t>(fit.best)];
  fit.still = true;
  for (const ChainFit& axis : best.axes)
    fit.still = fit.still && axis.edge == Edge::no_motion;
  return fit;
}

const char* type_of_order(int order) {
  return order == 1   ? "position"
         : order == 2 ? "position_velocity"
                      : "position_velocity_acceleration";
}

std::string motion_block(const MotionFit& fit, const std::string& source) {
  const OrderFit& best = fit.orders[static_cast<std::size_t>(fit.best)];
  const int power = 2 * fit.best + 1;
  const std::string unit = power == 1 ? "m²/s" : "m²/s^" + std::to_string(power);
  std::string text = "motion:  # " + source + ", '" + fit.track + "', every " +
                     format_quantity(fit.dt, "s") + "\n";
  if (!fit.fits)
    text +=
        "  # None of P, PV and PVA fits: the innovations of the likeliest aren't "
        "white.\n";
  text += std::string("  type: ") + type_of_order(fit.best + 1) + "\n  q: [";
  for (std::size_t a = 0; a < 3; ++a)
    text += (a ? ", " : "") + digits(best.axes[a].q.value);
  text += "]  # " + unit + "; 95 %: ";
  for (std::size_t a = 0; a < 3; ++a)
    text += (a ? ", " : "") + digits(best.axes[a].q.low) + " to " +
            digits(best.axes[a].q.high);
  return text + "\n";
}

}  // namespace delos::motion
