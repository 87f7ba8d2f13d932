#include "specs.h"

#include <map>
#include <ostream>

#include "delos/scene/definition.h"
#include "delos/text/words.h"

namespace delos::cli {

void add_spec_option(CLI::App& command, std::vector<std::string>& texts) {
  command
      .add_option("--spec", texts,
                  "Show which part of the samples meets this: 'coverage >= 3', "
                  "'eigmax <= 1 mm'; repeatable")
      ->type_name("METRIC<=VALUE")
      ->allow_extra_args(false);
}

std::vector<Spec> specs_of(const std::vector<std::string>& texts,
                           const LoadedScene& loaded) {
  std::vector<Spec> specs;
  for (const std::string& text : texts) {
    auto spec = parse_spec(text, known_metrics(loaded.scene));
    if (const auto* problem = std::get_if<std::string>(&spec))
      throw Failure{kUsage, "--spec '" + text + "': " + *problem};
    specs.push_back(std::get<Spec>(std::move(spec)));
    const Metric& metric = specs.back().metric;
    if (const std::string no = metric_problem(loaded.system, metric); !no.empty())
      throw Failure{kUsage, "--spec '" + text + "': " + no};
  }
  return specs;
}

std::vector<MetSpec> met_specs(const std::vector<Spec>& specs,
                               const LoadedScene& loaded, const Field& field,
                               const SceneOptions& options,
                               const Interrupt& interrupt) {
  std::map<std::string, Field> others;
  std::vector<MetSpec> all;
  for (const Spec& spec : specs) {
    const Field* of_metric = &field;
    if (spec.metric.name != field.metric) {
      const auto [at, is_new] = others.try_emplace(spec.metric.name);
      if (is_new) {
        LoadedScene other = loaded;
        other.metric = spec.metric;
        at->second = evaluate(other, field.samples, options, interrupt);
        at->second.weight = field.weight;
      }
      of_metric = &at->second;
    }
    all.push_back({spec, share_meeting(*of_metric, spec), !field.weight.empty()});
  }
  return all;
}

void print_specs(std::ostream& out, const std::vector<MetSpec>& all) {
  for (const auto& [spec, share, by_volume] : all)
    out << spec.text << ": " << percent(share.share)
        << (by_volume ? " of the volume, " : " of the samples, ") << share.met << " of "
        << share.samples << "\n";
}

Json specs_json(const std::vector<MetSpec>& all) {
  Json json = Json::array();
  for (const auto& [spec, share, by_volume] : all)
    json.push_back({{"spec", spec.text},
                    {"share", number(share.share)},
                    {"met", share.met},
                    {"samples", share.samples}});
  return json;
}

}  // namespace delos::cli
