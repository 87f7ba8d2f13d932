// What a search is told: the keys of `variables`, `objective`, `constraints` and
// `selection`.
#pragma once

#include "delos/scene/scene.h"
#include "document/keys.h"

namespace delos {

// Each needs the rest of the scene, whose findings are none.
void read_variables(Reader& reader, const Place& at, Scene& scene);
void read_objective(Reader& reader, const Place& at, Scene& scene);
void read_constraints(Reader& reader, const Place& at, Scene& scene);
void read_selection(Reader& reader, const Place& at, Scene& scene);

/// A metric of the scene, by its name; nullopt, with a finding, where there is none.
[[nodiscard]] std::optional<std::string> read_metric_name(Reader& reader,
                                                          const Place& at,
                                                          const Scene& scene);

/// The devices that a name, or a list of them, with * for any part, means; empty, with
/// a finding, where there are none.
[[nodiscard]] std::vector<std::string> read_device_names(Reader& reader,
                                                         const Place& at,
                                                         const Scene& scene);

/// What an objective withstands. `scene` is the rest of it.
void read_robust(Reader& reader, const Place& at, const Scene& scene, Robustness& out);

// nullopt where there is nothing to write.
[[nodiscard]] std::optional<Node> write_robust(const Robustness& robust);
[[nodiscard]] std::optional<Node> write_variables(const Scene& scene);
[[nodiscard]] std::optional<Node> write_objective(const Scene& scene);
[[nodiscard]] std::optional<Node> write_constraints(const Scene& scene);
[[nodiscard]] std::optional<Node> write_selection(const Scene& scene);

// What they may look like.
[[nodiscard]] Shape variable_shape();
[[nodiscard]] Shape constraint_shape();
[[nodiscard]] std::vector<Shape> objective_forms();
[[nodiscard]] std::vector<KeyShape> robust_keys();
[[nodiscard]] std::vector<KeyShape> selection_keys();

}  // namespace delos
