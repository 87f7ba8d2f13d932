#include "scene/params.h"

#include <cmath>
#include <span>

#include "delos/text/units.h"
#include "document/node_text.h"

namespace delos {
namespace {

/// "-0.005 m"
std::string with_unit(double value, const ParamSpec& spec) {
  const std::string unit = spec.unit;
  return shortest(value) + (unit == "1" ? "" : ' ' + unit);
}

std::optional<double> bounded_number(Reader& reader, const Place& at,
                                     const ParamSpec& spec) {
  const bool angle = std::string_view(spec.unit) == "rad";
  const auto value = angle ? reader.angle(at) : reader.number(at, spec.unit);
  if (!value) return std::nullopt;
  if (*value < spec.lower) {
    reader.error(at, with_unit(*value, spec) + " is below the least value " +
                         with_unit(spec.lower, spec));
    return std::nullopt;
  }
  if (*value > spec.upper) {
    reader.error(at, with_unit(*value, spec) + " is above the greatest value " +
                         with_unit(spec.upper, spec));
    return std::nullopt;
  }
  return value;
}

std::vector<std::string> split_choices(std::string_view text) {
  std::vector<std::string> words;
  for (std::size_t begin = 0;;) {
    const std::size_t bar = std::min(text.find('|', begin), text.size());
    words.emplace_back(text.substr(begin, bar - begin));
    if (bar == text.size()) return words;
    begin = bar + 1;
  }
}

std::optional<ParamValue> read_vector(Reader& reader, const Place& at,
                                      const ParamSpec& spec) {
  if (!reader.expect(at, Node::Kind::list, "a list of numbers")) return std::nullopt;
  const auto& items = at.node().items;
  if (spec.length > 0 && items.size() != spec.length) {
    reader.error(at, "expected " + std::to_string(spec.length) + " numbers, not " +
                         std::to_string(items.size()));
    return std::nullopt;
  }
  const std::size_t before = reader.findings.errors();
  Eigen::MatrixXd vector(items.size(), 1);
  for (std::size_t i = 0; i < items.size(); ++i)
    if (const auto value =
            bounded_number(reader, Place(at, std::to_string(i), items[i]), spec))
      vector(static_cast<Eigen::Index>(i), 0) = *value;
  if (reader.findings.errors() != before) return std::nullopt;
  return vector;
}

bool is_column(const Node& node) {
  return node.kind == Node::Kind::list && !node.items.empty() &&
         std::all_of(node.items.begin(), node.items.end(),
                     [](const Node& item) { return item.kind == Node::Kind::scalar; });
}

std::optional<ParamValue> read_value(Reader& reader, const Place& at,
                                     const ParamSpec& spec) {
  switch (spec.kind) {
    case ParamKind::number:
      if (const auto value = bounded_number(reader, at, spec)) return *value;
      return std::nullopt;
    case ParamKind::choice: {
      const auto words = split_choices(spec.choices ? spec.choices : "");
      if (const auto index = reader.choice(at, std::span<const std::string>(words)))
        return words[*index];
      return std::nullopt;
    }
    case ParamKind::text:
      if (auto words = reader.word(at)) return std::move(*words);
      return std::nullopt;
    case ParamKind::vector:
      return read_vector(reader, at, spec);
    case ParamKind::matrix:
      // What write_params() makes of n×1: one number a row.
      if (is_column(at.node())) return read_vector(reader, at, spec);
      if (auto m = reader.matrix(at, [&](int, int) { return spec.unit; }))
        return std::move(*m);
      return std::nullopt;
  }
  return std::nullopt;
}

bool has_default(const ParamSpec& spec) {
  return spec.kind == ParamKind::number ? !std::isnan(spec.initial)
                                        : spec.text != nullptr;
}

/// The table's default, which is text for all but numbers.
std::optional<ParamValue> default_value(Reader& reader, const PluginInfo& info,
                                        const ParamSpec& spec) {
  if (spec.kind == ParamKind::number) return spec.initial;
  const int source = reader.findings.add_source(std::string("plugin ") + info.id);
  const auto node = parse_yaml(spec.text, source, false, reader.findings);
  if (!node) return std::nullopt;
  const Node root;
  return read_value(reader, Place(Place(root), spec.name, *node), spec);
}

/// A preset's parameters as a scene writes them; without one a mapping of none.
Node preset_params(Reader& reader, const DevicePreset* preset) {
  const Node none{Node::Kind::map, {}, {}, {}, {}};
  if (!preset) return none;
  const int source = reader.findings.add_source("preset " + std::string(preset->name));
  const std::string text = '{' + std::string(preset->params) + '}';
  return parse_yaml(text, source, false, reader.findings).value_or(none);
}

}  // namespace

void read_params(Reader& reader, const Place& device, const PluginInfo& info,
                 const DevicePreset* preset, ParamValues& out) {
  const std::span<const ParamSpec> table(info.params, info.n_params);
  const Node* given = device.node().find("params");
  const Node nothing{Node::Kind::map, device.node().mark, {}, {}, {}};
  const Node& node = given && given->kind != Node::Kind::null ? *given : nothing;
  const Place at(device, "params", node);
  if (!reader.expect(at, Node::Kind::map, "a mapping")) return;

  std::vector<std::string> known;
  for (const ParamSpec& spec : table) known.emplace_back(spec.name);
  for (const Node::Key& key : node.keys)
    if (std::find(known.begin(), known.end(), key.text) == known.end())
      reader.error_within(at, key.mark, key.text,
                          "unknown key" + suggestion(key.text, known));

  const Node published = preset_params(reader, preset);
  for (const ParamSpec& spec : table) {
    const Node* value = node.find(spec.name);
    if (!value) value = published.find(spec.name);
    std::optional<ParamValue> read;
    if (value)
      read = read_value(reader, Place(at, spec.name, *value), spec);
    else if (has_default(spec))
      read = default_value(reader, info, spec);
    else
      reader.error_within(at, node.mark, spec.name,
                          std::string("missing: ") + spec.help);
    if (read) out.set(spec.name, std::move(*read));
  }
}

Node write_params(const ParamValues& params) {
  Node map;
  map.kind = Node::Kind::map;
  for (const auto& [name, value] : params.all()) {
    map.keys.push_back({name, {}});
    if (const auto* number = std::get_if<double>(&value)) {
      map.items.push_back(to_node(*number));
    } else if (const auto* word = std::get_if<std::string>(&value)) {
      map.items.push_back(to_node(*word));
    } else {
      const auto& m = std::get<Eigen::MatrixXd>(value);
      map.items.push_back(m.cols() == 1 ? vector_node(m.col(0)) : matrix_node(m));
    }
  }
  return map;
}

}  // namespace delos
