#include "report/words.h"

#include <variant>

#include "delos/model/metric.h"
#include "delos/scene/definition.h"
#include "delos/text/format.h"
#include "delos/text/words.h"

namespace delos::report {
namespace {

std::string are(const std::vector<std::string>& devices) {
  return listed(devices) + (devices.size() == 1 ? " is " : " are ");
}

std::string metres(double value) { return format_quantity(value, "m"); }

struct Words {
  const Scene& scene;

  std::string operator()(const KeepInside& k) const {
    std::string text =
        are(k.devices) + (k.outside ? "outside of " : "within ") + k.region;
    if (k.margin != 0) text += ", with " + metres(k.margin) + " to spare";
    return text;
  }
  std::string operator()(const KeepApart& k) const {
    return "any two of " + are(k.devices) + "at least " + metres(k.distance) + " apart";
  }
  std::string operator()(const KeepTilt& k) const {
    return are(k.devices) + "at most " + format_quantity(k.angle, "rad") +
           " away from the direction " + coordinates(k.from, 3);
  }
  std::string operator()(const KeepClear& k) const {
    return are(k.devices) + "at least " + metres(k.distance) +
           " from the line between " + coordinates(k.from, 3) + " and " +
           coordinates(k.to, 3);
  }
  std::string operator()(const KeepSum& k) const {
    std::string text;
    std::size_t shown = 0;
    for (const auto& [path, factor] : k.factors) {
      if (++shown > 4) break;
      text += (text.empty() ? "" : " + ") + format_quantity(factor, "1") + " · " + path;
    }
    if (shown > 4) text += " + …";
    return text + " is at most " + format_quantity(k.limit, "1");
  }
  std::string operator()(const KeepMetric& k) const {
    const auto metric = std::get<Metric>(parse_metric(k.metric, known_metrics(scene)));
    return metric.name + " is at " + (metric.larger_is_better ? "least " : "most ") +
           format_quantity(k.limit, metric.unit) + " at every sample" +
           (k.in.empty() ? "" : " of " + k.in);
  }
};

}  // namespace

std::string constraint_words(const ConstraintEntry& entry, const Scene& scene) {
  return std::visit(Words{scene}, entry.what);
}

}  // namespace delos::report
