// The JSON schema of scenes, against a validator of others' making; and that the tables
// of keys, which it is made of, read and write every key that they name.
#include "session/schema.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include "delos/scene/scene_shape.h"
#include "scene/load.h"
#include "scene/schema.h"

namespace delos::test {
namespace {

using session::Json;

/// A scene's text, and where it reads its files.
struct Text {
  std::string text;
  std::filesystem::path file;
};

std::string text_in(const std::filesystem::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The scenes of the repository, and some of keys that those have no need for.
std::vector<Text> all_scenes() {
  std::vector<Text> scenes;
  for (const char* folder : {DELOS_SCENES, DELOS_RARE_KEYS})
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
      if (entry.path().extension() == ".yaml")
        scenes.push_back({text_in(entry.path()), entry.path()});
  return scenes;
}

PluginRegistry& all_plugins() {
  static PluginRegistry registry({DELOS_PLUGINS, DELOS_TEST_PLUGINS});
  return registry;
}

/// What a table calls a key: where its rows are, and the key.
using KeyId = std::pair<std::vector<KeyShape> (*)(), std::string>;

/// Every key that a value of this shape may have, and those that are in them.
void every_key(const std::string& path, const Shape& shape,
               std::map<KeyId, std::string>& out) {
  if (shape.kind == Shape::Kind::list || shape.kind == Shape::Kind::table)
    return every_key(path, shape.item(), out);
  if (shape.kind == Shape::Kind::either)
    for (const Shape& form : shape.forms()) every_key(path, form, out);
  if (shape.kind != Shape::Kind::map) return;
  for (const KeyShape& key : shape.keys())
    if (out.try_emplace({shape.keys, key.name}, path + "." + key.name).second)
      every_key(path + "." + key.name, key.shape, out);
}

/// The keys that a value has of those that its shape knows.
void used_keys(const Shape& shape, const Json& value, std::set<KeyId>& out) {
  if (shape.kind == Shape::Kind::either)
    for (const Shape& form : shape.forms()) used_keys(form, value, out);
  if (shape.kind == Shape::Kind::list && value.is_array())
    for (const Json& item : value) used_keys(shape.item(), item, out);
  if (shape.kind == Shape::Kind::table && value.is_object())
    for (const Json& item : value) used_keys(shape.item(), item, out);
  if (shape.kind != Shape::Kind::map || !value.is_object()) return;
  for (const KeyShape& key : shape.keys())
    if (value.contains(key.name)) {
      out.insert({shape.keys, key.name});
      used_keys(key.shape, value[key.name], out);
    }
}

TEST(Schema, AcceptsEveryScene) {
  const Json schema = session::scene_schema(all_plugins());
  for (const Text& scene : all_scenes())
    EXPECT_EQ(schema_problem(schema, json_of_yaml(scene.text)), "") << scene.file;
}

TEST(Schema, KnowsThePluginsParameters) {
  const auto problem = [](const std::string& from, const std::string& to) {
    return schema_problem(json_of_yaml(good_with(from, to)));
  };
  EXPECT_EQ(problem("r: 5 mm", "r: 5 mm"), "");
  EXPECT_NE(problem("r: 5 mm", "raduis: 5 mm"), "");
  EXPECT_NE(problem("r: 5 mm", "r: [5 mm]"), "");
  EXPECT_NE(problem("r: 5 mm", "r: -5 mm"), "");
  EXPECT_NE(problem("r: 5 mm", "r: 5 mm, shape: triangular"), "");
  EXPECT_EQ(problem("r: 5 mm", "r: 5 mm, shape: hexagonal"), "");
  EXPECT_NE(problem("    params: {r: 5 mm}\n", ""), "");
}

// Text to scene to text to scene: the same scene, from the same tables.
TEST(KeyTables, ReadAndWriteEveryKeyAlike) {
  std::map<KeyId, std::string> unused;
  every_key("", scene_shape(), unused);
  ASSERT_GT(unused.size(), 150u);
  for (const Text& text : all_scenes()) {
    std::set<KeyId> used;
    used_keys(scene_shape(), json_of_yaml(text.text), used);
    for (const KeyId& key : used) unused.erase(key);
    Diagnostics diagnostics;
    const auto read = [&](const std::string& yaml) {
      return parse_scene(yaml, text.file, {}, all_plugins(), diagnostics);
    };
    const auto scene = read(text.text);
    ASSERT_TRUE(scene) << text.file << text.text << to_string(diagnostics.front());
    const std::string written = write_scene(*scene);
    const auto again = read(written);
    EXPECT_EQ(again, scene) << written;
    EXPECT_EQ(write_scene(*again), written);
  }
  for (const auto& [key, path] : unused) ADD_FAILURE() << path << " is in no scene";
}

}  // namespace
}  // namespace delos::test
