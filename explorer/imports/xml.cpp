// XML as values, by pugixml, which reads UTF-16 too and doesn't recurse.
#include <algorithm>
#include <pugixml.hpp>

#include "imports/value.h"

namespace delos::imports {
namespace {

class XmlWalk {
 public:
  XmlWalk(std::string_view text, Source& source) : text_(text), source_(source) {}

  bool element(const pugi::xml_node& node, Value& out, int depth) {
    place(node, out);
    if (depth > kDeepest || ++count_ > kMostValues) {
      source_.error(out, "elements are nested too deeply, or too many");
      return false;
    }
    out.kind = Value::Kind::map;
    for (const pugi::xml_attribute& a : node.attributes())
      add(out, a.name(), a.value());
    for (const pugi::xml_node& child : node.children()) {
      if (child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata) {
        add(out, "", child.value());
      } else if (child.type() == pugi::node_element) {
        out.members.emplace_back(child.name(), Value{});
        if (!element(child, out.members.back().second, depth + 1)) return false;
      }
    }
    return true;
  }

 private:
  void add(Value& to, const char* name, const char* text) {
    Value value;
    value.text = text;
    value.line = to.line;
    value.column = to.column;
    to.members.emplace_back(name, std::move(value));
    ++count_;
  }

  /// Elements come in the order of the text, so that lines are counted once.
  void place(const pugi::xml_node& node, Value& out) {
    const std::ptrdiff_t offset = node.offset_debug();
    if (offset < counted_ || static_cast<std::size_t>(offset) > text_.size()) return;
    for (; counted_ < offset; ++counted_)
      if (text_[static_cast<std::size_t>(counted_)] == '\n') {
        ++line_;
        line_start_ = counted_ + 1;
      }
    out.line = line_;
    out.column = static_cast<int>(offset - line_start_) + 1;
  }

  std::string_view text_;
  Source& source_;
  int count_ = 0, line_ = 1;
  std::ptrdiff_t counted_ = 0, line_start_ = 0;
};

}  // namespace

std::optional<Value> parse_xml(std::string_view text, Source& source) {
  pugi::xml_document document;
  const pugi::xml_parse_result result = document.load_buffer(text.data(), text.size());
  const bool one_byte = result.encoding == pugi::encoding_utf8;
  if (!result) {
    const auto offset = std::clamp<std::ptrdiff_t>(
        result.offset, 0, static_cast<std::ptrdiff_t>(text.size()));
    const auto line =
        one_byte ? 1 + std::count(text.begin(), text.begin() + offset, '\n') : 0;
    source.error(static_cast<int>(line), std::string("isn't whole XML: ") +
                                             result.description() +
                                             "; is the file cut off?");
    return std::nullopt;
  }
  // Offsets count the text after it was made UTF-8: other texts have no lines.
  XmlWalk walk(one_byte ? text : std::string_view(), source);
  Value root;
  root.kind = Value::Kind::map;
  root.members.emplace_back(document.document_element().name(), Value{});
  if (!walk.element(document.document_element(), root.members[0].second, 1))
    return std::nullopt;
  return root;
}

}  // namespace delos::imports
