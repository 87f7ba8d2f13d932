#include "document/yaml_tree.h"

#include <yaml-cpp/depthguard.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/mark.h>
#include <yaml-cpp/parser.h>

#include <map>
#include <sstream>
#include <utility>

namespace delos {
namespace {

/// Bytes that anchors and aliases may add to a text; a few nested ones could otherwise
/// fill memory.
constexpr std::size_t kMostCopied = 100'000'000;

/// What YAML allows and scenes don't.
struct NotForScenes {
  YAML::Mark mark;
  const char* problem;
};

std::size_t bytes_of(const Node& node) {
  std::size_t bytes = sizeof node + node.text.size();
  for (const Node::Key& key : node.keys) bytes += sizeof key + key.text.size();
  for (const Node& item : node.items) bytes += bytes_of(item);
  return bytes;
}

/// Builds the tree from yaml-cpp's events, which say where every value is.
class Builder final : public YAML::EventHandler {
 public:
  void OnDocumentStart(const YAML::Mark& mark) override {
    if (documents_++ > 0) throw NotForScenes{mark, "a second document begins here"};
  }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    add(mark, make(Node::Kind::null, mark), anchor);
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    Node node = make(Node::Kind::scalar, mark);
    node.text = value;
    node.quoted = tag == "!";  // YAML's tag of what isn't plain
    add(mark, std::move(node), anchor);
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const auto found = anchors_.find(anchor);
    if (found == anchors_.end())
      throw NotForScenes{mark, "this alias stands for what it is part of"};
    Node copy = copied(mark, found->second);
    copy.mark = {0, mark.line + 1, mark.column + 1};
    add(mark, std::move(copy), 0);
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string&,
                       YAML::anchor_t anchor, YAML::EmitterStyle::value) override {
    open_.push_back({make(Node::Kind::list, mark), mark, anchor});
  }
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    open_.push_back({make(Node::Kind::map, mark), mark, anchor});
  }
  void OnMapEnd() override { close(); }

  Node root;

 private:
  struct Open {
    Node node;
    YAML::Mark mark;
    YAML::anchor_t anchor;
  };

  static Node make(Node::Kind kind, const YAML::Mark& mark) {
    Node node;
    node.kind = kind;
    node.mark = {0, mark.line + 1, mark.column + 1};
    return node;
  }

  Node copied(const YAML::Mark& mark, const Node& node) {
    copied_ += bytes_of(node);
    if (copied_ > kMostCopied)
      throw NotForScenes{mark, "anchors and aliases make this text too large"};
    return node;
  }

  void close() {
    Open done = std::move(open_.back());
    open_.pop_back();
    add(done.mark, std::move(done.node), done.anchor);
  }

  void add(const YAML::Mark& mark, Node node, YAML::anchor_t anchor) {
    if (anchor != 0) anchors_[anchor] = copied(mark, node);
    if (open_.empty()) {
      root = std::move(node);
      return;
    }
    Node& parent = open_.back().node;
    if (parent.kind == Node::Kind::map && parent.keys.size() == parent.items.size()) {
      if (node.kind != Node::Kind::scalar)
        throw NotForScenes{mark, "a key must be a word"};
      parent.keys.push_back({std::move(node.text), node.mark});
    } else {
      // What YAML calls the place of nothing is where the next thing begins.
      if (parent.kind == Node::Kind::map && node.kind == Node::Kind::null)
        node.mark = parent.keys.back().mark;
      parent.items.push_back(std::move(node));
    }
  }

  std::vector<Open> open_;
  std::map<YAML::anchor_t, Node> anchors_;
  std::size_t copied_ = 0;
  int documents_ = 0;
};

void stamp(Node& node, int source, bool located) {
  const auto fix = [&](Mark& mark) {
    mark = located ? Mark{source, mark.line, mark.column} : Mark{source, 0, 0};
  };
  fix(node.mark);
  for (Node::Key& key : node.keys) fix(key.mark);
  for (Node& item : node.items) stamp(item, source, located);
}

}  // namespace

const Node* Node::find(std::string_view key) const {
  for (std::size_t i = 0; i < keys.size(); ++i)
    if (keys[i].text == key) return &items[i];
  return nullptr;
}

Node* Node::find(std::string_view key) {
  return const_cast<Node*>(std::as_const(*this).find(key));
}

std::string member_name(const Node& member, std::size_t index) {
  const Node* name = member.find("name");
  if (name && name->kind == Node::Kind::scalar && !name->text.empty())
    return name->text;
  return std::to_string(index);
}

std::optional<Node> parse_yaml(std::string_view text, int source, bool located,
                               Findings& findings) {
  const auto fail = [&](const YAML::Mark& mark, const std::string& problem) {
    const bool known = located && !mark.is_null();
    findings.error({source, known ? mark.line + 1 : 0, known ? mark.column + 1 : 0}, {},
                   "not a readable YAML text: " + problem);
    return std::nullopt;
  };
  std::istringstream stream{std::string(text)};
  Builder builder;
  try {
    YAML::Parser parser(stream);
    while (parser.HandleNextDocument(builder)) {
    }
  } catch (const NotForScenes& e) {
    return fail(e.mark, e.problem);
  } catch (const YAML::DeepRecursion& e) {
    return fail(e.mark, "lists and mappings are nested too deeply");
  } catch (const YAML::Exception& e) {
    return fail(e.mark, e.msg);
  }
  stamp(builder.root, source, located);
  return std::move(builder.root);
}

}  // namespace delos
