#include "report/tradeoff_section.h"

#include <stdexcept>
#include <vector>

#include "delos/text/format.h"
#include "delos/text/words.h"
#include "report/chart.h"
#include "report/words.h"

namespace delos::report {
namespace {

using Json = nlohmann::ordered_json;

/// One row of either document.
struct Point {
  double across, second, objective;  ///< limit and used, or devices and price
  bool kept, dominated;
};

std::vector<Point> points_of(const Json& document, bool of_limit) {
  std::vector<Point> points;
  for (const Json& p : document.at("points")) {
    if (p.at("objective").is_null()) continue;
    points.push_back({p.at(of_limit ? "limit" : "devices").get<double>(),
                      p.at(of_limit ? "used" : "price").get<double>(),
                      p.at("objective").get<double>(), p.at("kept").get<bool>(),
                      of_limit && p.at("dominated").get<bool>()});
  }
  return points;
}

Html section_of(const Json& document) {
  const bool of_limit = document.contains("limit");
  const std::string name = document.at("objective").at("name"),
                    unit = document.at("objective").at("unit");
  const std::string across =
      of_limit ? document.at("limit").at("constraint").get<std::string>() : "devices";
  const std::string across_unit =
      of_limit ? document.at("limit").at("unit").get<std::string>() : "1";
  const std::vector<Point> points = points_of(document, of_limit);
  Series kept{"all constraints kept", Stroke::line, {}},
      broken{"constraints not kept", Stroke::line, {}};
  std::vector<std::vector<Html>> rows;
  for (const Point& p : points) {
    (p.kept ? kept : broken)
        .points.push_back({of_limit && p.kept ? p.second : p.across, p.objective});
    rows.push_back({format_quantity(p.across, across_unit, 4),
                    format_quantity(p.second, of_limit ? across_unit : "1", 4),
                    format_quantity(p.objective, unit, 4),
                    !p.kept       ? element("span", {{"class", "bad"}}, "no")
                    : p.dominated ? Html("yes, but no better than a tighter limit")
                                  : Html("yes")});
  }
  Html content;
  if (!points.empty()) {
    Chart chart;
    chart.says = "The best " + name + " against " +
                 (of_limit ? across : std::string("the number of devices")) + ", " +
                 std::to_string(points.size()) + " points";
    chart.x_name = across;
    chart.x_unit = across_unit;
    chart.y_name = name;
    chart.y_unit = unit;
    for (const Series& series : {kept, broken})
      if (!series.points.empty()) chart.series.push_back(series);
    content += chart_figure(chart, "Each point is a search of its own.");
  }
  if (!of_limit) {
    const Json& cheapest = document.at("cheapest");
    content += element(
        "p", {{"class", "answer"}},
        cheapest.is_null()
            ? "None of these kits keeps all constraints."
            : "The cheapest kit that keeps all constraints has " +
                  std::to_string(cheapest.at("devices").get<std::size_t>()) +
                  " devices, at a price of " +
                  format_quantity(cheapest.at("price").get<double>(), "1") + ".");
  }
  content += table("Best designs",
                   {of_limit ? across + " at the limit" : std::string("devices"),
                    of_limit ? "used" : "price", name, "all constraints kept"},
                   rows);
  return section(of_limit ? "Accuracy against " + across
                          : std::string("Accuracy against the number of devices"),
                 content);
}

}  // namespace

Html tradeoff_section(const Json& document) {
  try {
    return section_of(document);
  } catch (const nlohmann::json::exception&) {
    throw std::invalid_argument("this isn't what delos tradeoff --json writes");
  }
}

Html consensus_section(const Consensus& found, std::size_t starts,
                       const std::vector<std::string>& values) {
  std::vector<std::vector<Html>> layouts, devices;
  for (std::size_t i = 0; i < found.layouts.size(); ++i)
    layouts.push_back({std::to_string(i + 1), values[i],
                       format_quantity(found.layouts[i].distance, "m")});
  for (const ConsensusDevice& d : found.devices)
    devices.push_back({d.name, to_string(d.settled),
                       format_quantity(100 * d.part_of_chance, "1", 2) + " %",
                       format_quantity(d.shift, "m"), format_quantity(d.turn, "rad"),
                       coordinates(d.at, 3) + " m"});
  Html content =
      table("Distinct layouts among the best designs of " + std::to_string(starts) +
                " starts; devices of one kind are interchangeable",
            {"layout", "objective", "from the best"}, layouts);
  content +=
      layouts.size() < 2
          ? element("p", "One layout says nothing of what is settled.")
          : table(
                "Settled: a device varies over these layouts less than a quarter as "
                "much as over random designs; free: more than three fifths",
                {"device", "pose", "varies", "moves by", "turns by", "in the best, at"},
                devices);
  return section("What the best layouts have in common", content);
}

}  // namespace delos::report
