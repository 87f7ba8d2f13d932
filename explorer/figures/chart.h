// Line charts as SVG.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "figures/html.h"

namespace delos::figures {

/// How the points of a series are drawn.
enum class Stroke {
  line,   ///< from point to point, each with a disc
  curve,  ///< from point to point
  steps,  ///< level up to the next point
  dots,   ///< each by itself, faintly
};

struct Series {
  std::string name;
  Stroke stroke = Stroke::line;
  std::vector<std::array<double, 2>> points;  ///< x, and y in SI; y finite
};

/// Something that happened at x.
struct ChartMark {
  double x;
  std::string label;
};

struct Chart {
  std::string says;  ///< what a reader sees, in a sentence: the alternative text
  std::string x_name, y_name;
  std::string x_unit = "1", y_unit = "1";  ///< SI
  std::vector<Series> series;
  std::vector<ChartMark> marks;
};

/// The chart by itself; a logarithmic y axis where its values span more than a factor
/// of 5.
/// @pre some series has a point
[[nodiscard]] Html chart_drawing(const Chart& chart);
/// The same with a caption.
[[nodiscard]] Html chart_figure(const Chart& chart, const Html& caption);

}  // namespace delos::figures
