#include "document/extends.h"

#include <algorithm>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "document/file_text.h"
#include "document/override.h"

namespace delos {
namespace {

/// A chain of bases that is longer has lost its way.
constexpr std::size_t kMostBases = 16;

/// Take a key out of a map.
std::optional<Node> take(Node& map, std::string_view key) {
  for (std::size_t i = 0; i < map.keys.size(); ++i) {
    if (map.keys[i].text != key) continue;
    Node value = std::move(map.items[i]);
    const auto at = static_cast<std::ptrdiff_t>(i);
    map.keys.erase(map.keys.begin() + at);
    map.items.erase(map.items.begin() + at);
    return value;
  }
  return std::nullopt;
}

class Resolver {
 public:
  explicit Resolver(Reader& reader) : reader_(reader) {}

  /// @param from the folder of the scene that is resolved, relative to the reader's
  std::optional<Node> operator()(Node scene, const std::filesystem::path& from) {
    check_duplicate_keys(reader_, Place(scene));
    if (scene.kind != Node::Kind::map) return scene;
    const std::optional<Node> base_name = take(scene, "extends");
    const std::optional<Node> changes = take(scene, "set");
    if (!base_name) {
      if (changes)
        return fail(changes->mark, "set",
                    "goes with 'extends'; here, write the values");
      return scene;
    }
    if (base_name->kind != Node::Kind::scalar)
      return fail(base_name->mark, "extends", "expected the name of a scene file");
    const std::filesystem::path name = (from / base_name->text).lexically_normal();
    std::optional<Node> base = read(name, base_name->mark);
    if (!base) return std::nullopt;
    for (std::size_t i = 0; i < scene.keys.size(); ++i) {
      take(*base, scene.keys[i].text);
      base->keys.push_back(scene.keys[i]);
      base->items.push_back(std::move(scene.items[i]));
    }
    base->mark = scene.mark;
    if (changes) change(*base, *changes);
    return base;
  }

 private:
  std::optional<Node> fail(Mark mark, const char* key, std::string problem) {
    reader_.findings.error(mark, key, std::move(problem));
    return std::nullopt;
  }

  /// The tree of a base, itself resolved.
  std::optional<Node> read(const std::filesystem::path& name, Mark mark) {
    const std::filesystem::path file = reader_.folder / name;
    std::error_code ignored;  // what can't be resolved can't be read either
    const std::filesystem::path whole =
        std::filesystem::weakly_canonical(file, ignored);
    if (std::find(chain_.begin(), chain_.end(), whole) != chain_.end())
      return fail(mark, "extends", "'" + name.string() + "' extends this scene again");
    chain_.push_back(whole);
    if (chain_.size() > kMostBases)
      return fail(mark, "extends", "more than 16 scenes in a row");
    std::string why;
    const std::optional<std::string> text = file_text(file, why);
    if (!text)
      return fail(mark, "extends",
                  "there is no readable scene '" + file.string() + "': " + why);
    const int source = reader_.findings.add_source(file.string());
    reader_.folder_of_source[source] = name.parent_path();
    std::optional<Node> tree = parse_yaml(*text, source, true, reader_.findings);
    if (!tree) return std::nullopt;
    if (tree->kind != Node::Kind::map)
      return fail(mark, "extends", "'" + name.string() + "' isn't a scene");
    return (*this)(std::move(*tree), name.parent_path());
  }

  void change(Node& scene, const Node& changes) {
    if (changes.kind != Node::Kind::map) {
      fail(changes.mark, "set", "expected a mapping of paths to values");
      return;
    }
    for (std::size_t i = 0; i < changes.keys.size(); ++i) {
      replace_value(scene, changes.keys[i].text, changes.items[i], changes.keys[i].mark,
                    reader_.findings);
    }
  }

  Reader& reader_;
  std::vector<std::filesystem::path> chain_;
};

}  // namespace

std::optional<Node> resolve_extends(Node scene, Reader& reader) {
  return Resolver(reader)(std::move(scene), {});
}

}  // namespace delos
