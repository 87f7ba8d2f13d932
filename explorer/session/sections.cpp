#include "session/sections.h"

#include <algorithm>
#include <cmath>

namespace delos::session {
namespace {

/// Samples along the two sides; a sliver has no more than others.
Eigen::Vector2i counts_of(const Section& section, std::size_t most) {
  const double u = section.u.norm(), v = section.v.norm();
  const double step = std::sqrt(u * v / static_cast<double>(most));
  const auto along = [&](double side) {
    const double most_along = static_cast<double>(most) / 2;
    return 1 + static_cast<int>(std::lround(std::clamp(side / step, 1.0, most_along)));
  };
  return {along(u), along(v)};
}

Samples samples_of(const std::vector<Section>& sections, std::size_t most) {
  std::vector<SampleSet> sets;
  for (const Section& s : sections)
    sets.push_back({"", PlaneSampling{s.origin, s.u, s.v, counts_of(s, most)}});
  return make_samples(sets);
}

}  // namespace

DrawnField draw_sections(const LoadedScene& loaded,
                         const std::vector<Section>& sections, std::size_t most,
                         const FieldOptions& options) {
  DrawnField drawn;
  drawn.field = evaluate_field(loaded.system, samples_of(sections, most),
                               loaded.scene.orientations, loaded.metric, options);
  drawn.summary = field_answer(loaded, drawn.field);
  drawn.mask = drawn_as(drawn.field);
  return drawn;
}

DrawnField draw_difference_sections(const LoadedScene& loaded, const Baseline& baseline,
                                    const std::vector<Section>& sections,
                                    std::size_t most, const FieldOptions& options) {
  // What is kept of the baseline is over the design's own samples.
  Baseline once{baseline.loaded, std::nullopt};
  return draw_difference_on(loaded, once, samples_of(sections, most), options);
}

}  // namespace delos::session
