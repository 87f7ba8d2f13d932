#include "document/node_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "delos/text/units.h"

namespace delos {
namespace {

/// What stands on one line with its key.
constexpr std::size_t kFlowWidth = 72;

bool is_plain(const std::string& text) {
  constexpr std::array kNull = {"null", "Null", "NULL"};
  if (text.empty() || text.back() == ' ') return false;
  if (std::find(kNull.begin(), kNull.end(), text) != kNull.end()) return false;
  const auto letter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
  };
  const auto numeral = [](char c) {
    return (c >= '0' && c <= '9') || c == '.' || c == '-';
  };
  // A sign alone, "-" or "---", means something else in YAML.
  const bool begins_well =
      letter(text[0]) || (text[0] >= '0' && text[0] <= '9') ||
      (text[0] == '-' && text.size() > 1 && text[1] >= '0' && text[1] <= '9');
  return begins_well && std::all_of(text.begin(), text.end(), [&](char c) {
           return letter(c) || numeral(c) || c == '+' || c == '/' || c == ' ';
         });
}

std::string scalar_text(const std::string& text) {
  if (is_plain(text)) return text;
  constexpr const char* kHex = "0123456789abcdef";
  std::string quoted = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      quoted += '\\';
      quoted += c;
    } else if (byte < 0x20 || byte == 0x7f) {
      quoted += "\\x";
      quoted += kHex[byte >> 4];
      quoted += kHex[byte & 15];
    } else {
      quoted += c;
    }
  }
  return quoted + '"';
}

void append_flow(const Node& node, std::string& out) {
  if (node.kind == Node::Kind::null) out += "null";
  if (node.kind == Node::Kind::scalar) out += scalar_text(node.text);
  if (node.kind != Node::Kind::list && node.kind != Node::Kind::map) return;
  const bool map = node.kind == Node::Kind::map;
  out += map ? '{' : '[';
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    if (i > 0) out += ", ";
    if (map) out += scalar_text(node.keys[i].text) + ": ";
    append_flow(node.items[i], out);
  }
  out += map ? '}' : ']';
}

bool holds_maps(const Node& node) {
  return node.kind == Node::Kind::list &&
         std::any_of(node.items.begin(), node.items.end(),
                     [](const Node& n) { return n.kind == Node::Kind::map; });
}

/// A collection that stands on lines of its own, each indented by that many blanks.
void append_block(const Node& node, std::size_t indent, bool begun, std::string& out) {
  const bool map = node.kind == Node::Kind::map;
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    const Node& item = node.items[i];
    if (i > 0 || !begun) out.append(indent, ' ');
    out += map ? scalar_text(node.keys[i].text) + ':' : "-";
    std::string flow;
    append_flow(item, flow);
    const bool collection =
        item.kind == Node::Kind::list || item.kind == Node::Kind::map;
    const bool block = collection && !item.items.empty() &&
                       (holds_maps(item) || flow.size() > kFlowWidth ||
                        (!map && item.kind == Node::Kind::map));
    if (!block) {
      out += ' ' + flow + '\n';
    } else if (map) {
      out += '\n';
      append_block(item, indent + 2, false, out);
    } else {
      out += ' ';
      append_block(item, indent + 2, true, out);
    }
  }
}

Node scalar_node(std::string text) {
  Node node;
  node.kind = Node::Kind::scalar;
  node.text = std::move(text);
  return node;
}

}  // namespace

Node to_node(double value) { return scalar_node(shortest(value)); }
Node to_node(int value) { return scalar_node(std::to_string(value)); }
Node to_node(const std::string& word) { return scalar_node(word); }

Node to_node(std::vector<Node> items) {
  Node node;
  node.kind = Node::Kind::list;
  node.items = std::move(items);
  return node;
}

Node to_node(const std::vector<Eigen::Vector3d>& vectors) {
  std::vector<Node> items;
  items.reserve(vectors.size());
  for (const Eigen::Vector3d& v : vectors) items.push_back(vector_node(v));
  return to_node(std::move(items));
}

Node names_node(const std::vector<std::string>& names) {
  std::vector<Node> items;
  for (const std::string& name : names) items.push_back(to_node(name));
  return to_node(std::move(items));
}

Node vector_node(const Eigen::Ref<const Eigen::VectorXd>& vector) {
  std::vector<Node> items;
  for (const double value : vector) items.push_back(to_node(value));
  return to_node(std::move(items));
}

Node matrix_node(const Eigen::Ref<const Eigen::MatrixXd>& matrix) {
  std::vector<Node> rows;
  for (Eigen::Index i = 0; i < matrix.rows(); ++i)
    rows.push_back(vector_node(matrix.row(i).transpose()));
  return to_node(std::move(rows));
}

std::string to_yaml(const Node& root) {
  std::string text;
  append_block(root, 0, false, text);
  return text;
}

}  // namespace delos
