#include "device/devices.h"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <cmath>
#include <set>
#include <sstream>
#include <stdexcept>

#include "delos/device/faults.h"

namespace delos::test {
namespace {

ParamValue value_of(const YAML::Node& node, ParamKind kind) {
  if (kind == ParamKind::number) return node.as<double>();
  if (kind == ParamKind::choice || kind == ParamKind::text)
    return node.as<std::string>();
  const bool rows = kind == ParamKind::matrix;
  Eigen::MatrixXd m(node.size(), rows ? node[0].size() : 1);
  for (int i = 0; i < m.rows(); ++i) {
    for (int j = 0; j < m.cols(); ++j) {
      m(i, j) = rows ? node[i][j].as<double>() : node[i].as<double>();
    }
  }
  return m;
}

}  // namespace

PluginRegistry& registry() {
  static PluginRegistry the_registry;
  return the_registry;
}

const PluginInfo* plugin(const std::string& id) {
  const PluginLoad& load = registry().find(id);
  EXPECT_NE(load.info, nullptr) << load.error;
  return load.info;
}

ParamValues values(const PluginInfo& info, const std::string& yaml) {
  const YAML::Node given = YAML::Load(yaml);
  ParamValues all;
  std::size_t used = 0;
  for (std::uint32_t i = 0; i < info.n_params; ++i) {
    const ParamSpec& spec = info.params[i];
    if (given[spec.name]) {
      all.set(spec.name, value_of(given[spec.name], spec.kind));
      ++used;
    } else if (spec.text) {
      all.set(spec.name, value_of(YAML::Load(spec.text), spec.kind));
    } else if (!std::isnan(spec.initial)) {
      all.set(spec.name, spec.initial);
    } else {
      throw std::runtime_error(std::string(info.id) + " needs a value for '" +
                               spec.name + "' in its example.yaml");
    }
  }
  if (used != given.size()) {
    throw std::runtime_error(std::string(info.id) + " lacks a parameter of " + yaml);
  }
  return all;
}

std::shared_ptr<const Device> device(const std::string& id, const std::string& yaml) {
  const PluginInfo* info = plugin(id);
  return info ? make_device(*info, values(*info, yaml)) : nullptr;
}

std::string refusal(const std::string& id, const std::string& yaml) {
  try {
    (void)device(id, yaml);
  } catch (const Unbuildable& e) {
    return e.what();
  }
  return "accepted";
}

std::vector<std::string> all_ids() {
  const std::vector<std::string> found = registry().ids();
  std::set<std::string> ids(found.begin(), found.end());
  std::istringstream built(DELOS_DEVICES);
  for (std::string id; std::getline(built, id, ',');) ids.insert(id);
  return {ids.begin(), ids.end()};
}

std::vector<std::string> examples(const std::string& id) {
  const auto file = std::filesystem::path(DELOS_PLUGIN_SOURCES) / id / "example.yaml";
  if (!std::filesystem::exists(file)) return {"{}"};
  std::vector<std::string> all;
  for (const YAML::Node& example : YAML::LoadFile(file))
    all.push_back(YAML::Dump(example));
  return all;
}

}  // namespace delos::test
