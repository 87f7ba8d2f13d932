#include "specs.h"

#include <ostream>

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

std::vector<Spec> asked_specs(const std::vector<std::string>& texts,
                              const LoadedScene& loaded) {
  return read_option([&] { return session::specs_of(texts, loaded); });
}

std::vector<MetSpec> met_specs(const std::vector<Spec>& specs,
                               const LoadedScene& loaded, const Field& field,
                               const SceneOptions& options,
                               const Interrupt& interrupt) {
  Progress progress(loaded.scene.name);
  try {
    return session::met_specs(specs, loaded, field,
                              field_options(options, interrupt, progress));
  } catch (const std::invalid_argument& error) {
    throw unsolvable(options, error);
  }
}

void print_specs(std::ostream& out, const std::vector<MetSpec>& all) {
  for (const auto& [spec, share, by_volume] : all)
    out << spec.text << ": " << percent(share.share)
        << (by_volume ? " of the volume, " : " of the samples, ") << share.met << " of "
        << share.samples << "\n";
}

}  // namespace delos::cli
