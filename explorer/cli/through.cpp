#include "through.h"

#include "delos/text/format.h"
#include "delos/text/words.h"
#include "output/picture_words.h"
#include "quantity.h"
#include "session/named.h"

namespace delos::cli {

void add_through_options(CLI::App& command, const std::string& name,
                         ThroughOptions& options) {
  CLI::Option* method = command.add_option(
      "--" + name, options.method,
      "A surface through scattered samples by natural-neighbour, linear, nearest, "
      "inverse-distance or minimum-curvature");
  if (!options.method.empty()) method->capture_default_str();
  command
      .add_option("--over", options.over,
                  "Of that surface: over the plane across x, y or z")
      ->capture_default_str();
  command
      .add_option("--power", options.power,
                  "Of inverse-distance: weights fall with this power of the distance")
      ->check(CLI::Range(0.1, 20.0))
      ->capture_default_str();
  command.add_option("--radius", options.radius,
                     "Of inverse-distance: farther points have no weight; '1 m'");
}

session::Through through_of(const ThroughOptions& options, const std::string& name) {
  session::Through through;
  through.how.method = read_option(
      [&] { return session::scattered_method_named(options.method, name.c_str()); });
  through.axis = read_option([&] { return session::axis_named(options.over, "over"); });
  through.relief = quantity_from_0(options.relief, "m", "--relief");
  through.how.power = options.power;
  if (!options.radius.empty())
    through.how.radius = quantity_above_0(options.radius, "m", "--radius");
  return through;
}

std::string through_words(const session::Json& through, const std::string& unit) {
  std::string words = "surface through " + counted(through["samples"], "sample") +
                      " by " + through["method"].get<std::string>();
  if (!through["min"].is_null())
    words += ": " + format_quantity(through["min"], unit) + " to " +
             format_quantity(through["max"], unit);
  if (through["blind"] > 0)
    words += ", " + share_text(through["blind"], through["places"]) + " of it blind";
  return words;
}

}  // namespace delos::cli
