#include "session/motion_fields.h"

#include <algorithm>
#include <cmath>

#include "session/scene_field.h"

namespace delos::session {
namespace {

/// What has no finite value is worst, whichever way is better.
double worse(double a, double b, bool larger_is_better) {
  if (!std::isfinite(a)) return a;
  if (!std::isfinite(b)) return b;
  return larger_is_better ? std::min(a, b) : std::max(a, b);
}

}  // namespace

Field envelope_of(const std::vector<MotionField>& fields) {
  Field worst = fields.front().field;
  for (std::size_t i = 1; i < fields.size(); ++i) {
    const Field& other = fields[i].field;
    for (std::size_t s = 0; s < worst.value.size(); ++s) {
      worst.value[s] = worse(worst.value[s], other.value[s], worst.larger_is_better);
      worst.observable[s] = worst.observable[s] && other.observable[s];
      worst.lost[s] = std::max(worst.lost[s], other.lost[s]);
    }
    worst.evaluations += other.evaluations;
    worst.seconds += other.seconds;
    worst.cancelled = worst.cancelled || other.cancelled;
    worst.evaluated = std::min(worst.evaluated, other.evaluated);
  }
  return worst;
}

Json motion_fields_json(const LoadedScene& loaded, const Field& envelope,
                        const std::vector<MotionField>& fields) {
  Json json = field_answer(loaded, envelope);
  json["motions"] = Json::array();
  for (const MotionField& of : fields) {
    Json one = field_answer(loaded, of.field);
    one["motion"] = of.name;
    json["motions"].push_back(std::move(one));
  }
  return json;
}

}  // namespace delos::session
