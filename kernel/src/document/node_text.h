// Makes nodes of values, and YAML of nodes.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "document/yaml_tree.h"

namespace delos {

[[nodiscard]] Node to_node(double value);
[[nodiscard]] Node to_node(int value);
[[nodiscard]] Node to_node(const std::string& word);
[[nodiscard]] Node to_node(const std::vector<Eigen::Vector3d>& vectors);
[[nodiscard]] Node to_node(std::vector<Node> items);

/// A list of the names.
[[nodiscard]] Node names_node(const std::vector<std::string>& names);
/// A list of the vector's numbers.
[[nodiscard]] Node vector_node(const Eigen::Ref<const Eigen::VectorXd>& vector);
/// A list of the matrix's rows.
[[nodiscard]] Node matrix_node(const Eigen::Ref<const Eigen::MatrixXd>& matrix);

/// The tree as YAML; short parts stand on one line.
[[nodiscard]] std::string to_yaml(const Node& root);

}  // namespace delos
