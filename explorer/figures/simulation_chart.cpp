#include "figures/simulation_chart.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "figures/chart.h"

namespace delos::figures {
namespace {

/// σ over the position, or over what there is: the root of the pose block's trace.
double deviation(const StateVector& variances, int block) {
  return std::sqrt(variances.head(block).sum());
}

/// How filters settle at a place.
Chart settling(const Simulation& s, const StateLayout& layout) {
  const int block = layout.block();
  Chart chart;
  chart.says = "Standard deviations over time: measured, the filter's own, the bound's";
  chart.x_name = "time";
  chart.x_unit = "s";
  chart.y_name = layout.positions() > 0 ? "error of the position, 1σ"
                                        : "error of the pose block, 1σ";
  chart.y_unit = layout.units().front();
  chart.series = {{"measured", Stroke::curve, {}},
                  {"filter's own", Stroke::curve, {}},
                  {"predicted P∞", Stroke::curve, {}}};
  const StateMatrix& predicted = s.covariances.front().predicted;
  for (const SimulatedInstant& at : s.instants) {
    chart.series[0].points.push_back({at.t, deviation(at.square, block)});
    chart.series[1].points.push_back({at.t, deviation(at.filter, block)});
    chart.series[2].points.push_back({at.t, deviation(predicted.diagonal(), block)});
  }
  if (s.settled_after) chart.marks.push_back({*s.settled_after, "settled"});
  return chart;
}

/// The error of the first coordinate along a path, between tubes.
Chart tube(const Simulation& s, const StateLayout& layout) {
  Chart chart;
  const std::string name = layout.names().front();
  chart.says = "The error of " + name + " along the path between tubes of three sigmas";
  chart.x_name = "time";
  chart.x_unit = "s";
  chart.y_name = "error of " + name;
  chart.y_unit = layout.units().front();
  chart.series = {{"mean ± 3σ of the runs", Stroke::curve, {}},
                  {"± 3σ of P∞ there", Stroke::curve, {}},
                  {"± 3σ of the filter", Stroke::curve, {}}};
  const auto sides = [&](double sign) {
    for (const SimulatedInstant& at : s.instants) {
      const double scatter =
          std::sqrt(std::max(0.0, at.square(0) - at.mean(0) * at.mean(0)));
      chart.series[0].points.push_back({at.t, at.mean(0) + sign * 3 * scatter});
      if (std::isfinite(at.predicted(0)))
        chart.series[1].points.push_back({at.t, sign * 3 * std::sqrt(at.predicted(0))});
      chart.series[2].points.push_back({at.t, sign * 3 * std::sqrt(at.filter(0))});
    }
  };
  // There and back, so that each tube is one outline.
  sides(1);
  std::vector<std::ptrdiff_t> back;
  for (const Series& series : chart.series)
    back.push_back(static_cast<std::ptrdiff_t>(series.points.size()));
  sides(-1);
  for (std::size_t i = 0; i < chart.series.size(); ++i)
    std::reverse(chart.series[i].points.begin() + back[i],
                 chart.series[i].points.end());
  return chart;
}

}  // namespace

std::string simulation_chart(const Simulation& simulation, const StateLayout& layout) {
  const bool along = simulation.instants.front().predicted.size() > 0;
  const Chart chart = along ? tube(simulation, layout) : settling(simulation, layout);
  return chart_drawing(chart).str() + "\n";
}

}  // namespace delos::figures
