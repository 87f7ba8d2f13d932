// Fields that are kept: what is read is what was written, and what is damaged is
// refused.
#include "session/stored_field.h"

#include <gtest/gtest.h>

#include <fstream>
#include <random>
#include <sstream>

#include "output/write.h"
#include "session/comparison.h"
#include "session/refusal.h"
#include "session/scene_field.h"
#include "support/folder.h"

namespace delos::session {
namespace {

using test::Folder;

struct Kept {
  Field field;
  std::vector<Marker> devices;
};

/// A scene's field on few samples.
Kept field_of(const std::string& scene, const std::vector<Override>& changes) {
  PluginRegistry plugins({DELOS_PLUGINS});
  const LoadedScene loaded = load(
      {std::filesystem::path(DELOS_SCENES) / (scene + ".yaml"), {}, changes}, plugins);
  return {evaluate_scene(loaded, FieldOptions()).field,
          markers_of(loaded.scene, loaded.system)};
}

Kept acoustic() { return field_of("01-acoustic", {{"sample.volume.step", "0.1"}}); }

std::string bytes_of_file(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

StoredField read_back(const std::filesystem::path& file) {
  auto read = read_field(file);
  if (const auto* problem = std::get_if<std::string>(&read)) {
    ADD_FAILURE() << *problem;
    return {};
  }
  return std::get<StoredField>(std::move(read));
}

void expect_kept(const Kept& kept) {
  const Folder folder;
  ASSERT_EQ(store_field(kept.field, kept.devices, folder / "a.field"), "");
  const StoredField read = read_back(folder / "a.field");
  EXPECT_EQ(field_json(read.field), field_json(kept.field));
  EXPECT_EQ(read.field.value, kept.field.value);
  ASSERT_EQ(store_field(read.field, read.devices, folder / "b.field"), "");
  EXPECT_EQ(bytes_of_file(folder / "a.field"), bytes_of_file(folder / "b.field"));
  PictureOptions picture;
  picture.devices = kept.devices;
  for (const char* name : {"x.csv", "x.png"}) {
    if (!writable(kept.field.samples, name).empty()) continue;
    ASSERT_EQ(write_field(kept.field, folder / name, picture), "");
    const std::string before = bytes_of_file(folder / name);
    picture.devices = read.devices;
    ASSERT_EQ(write_field(read.field, folder / name, picture), "");
    EXPECT_EQ(bytes_of_file(folder / name), before) << name;
  }
}

TEST(StoredField, IsTheFieldToTheLastBit) { expect_kept(acoustic()); }

TEST(StoredField, KeepsTheVolumeOfAnAdaptiveOne) {
  const Kept kept =
      field_of("06-furnished-lab", {{"sample.volume.adaptive.depth", "2"}});
  ASSERT_TRUE(kept.field.spread);
  expect_kept(kept);
}

TEST(StoredField, KeepsAPath) {
  const Kept kept = field_of("17-crowded-room", {});
  expect_kept(kept);
}

TEST(StoredField, IsComparedAsItsSceneIs) {
  const Kept a = acoustic();
  const Kept b = field_of(
      "01-acoustic", {{"sample.volume.step", "0.1"}, {"devices.s1.params.r", "0.01"}});
  const ComparisonAnswer answer = compare_stored({a.field, b.field});
  const Comparison expected = compare_fields(a.field, b.field);
  ASSERT_EQ(answer.differences.size(), 1u);
  EXPECT_EQ(answer.differences[0].mean, expected.mean);
  EXPECT_EQ(answer.differences[0].difference.value, expected.difference.value);
  const Kept elsewhere = field_of("01-acoustic", {{"sample.volume.step", "0.2"}});
  EXPECT_THROW((void)compare_stored({a.field, elsewhere.field}), Refusal);
  const Kept other =
      field_of("01-acoustic", {{"sample.volume.step", "0.1"}, {"metric", "sigma_z"}});
  EXPECT_THROW((void)compare_stored({a.field, other.field}), Refusal);
}

/// Cut anywhere, or with any byte changed, a file is read as something in order or
/// refused with a sentence; it never crashes.
TEST(StoredField, OutlivesDamage) {
  const Folder folder;
  const Kept kept = acoustic();
  ASSERT_EQ(store_field(kept.field, kept.devices, folder / "whole.field"), "");
  const std::string whole = bytes_of_file(folder / "whole.field");
  std::mt19937 random(5);
  const auto damaged = [&](const std::string& bytes) {
    std::ofstream(folder / "damaged.field", std::ios::binary) << bytes;
    const auto read = read_field(folder / "damaged.field");
    if (const auto* problem = std::get_if<std::string>(&read)) {
      EXPECT_NE(problem->find("damaged.field can't be read as a field: "),
                std::string::npos);
      return false;
    }
    (void)field_json(std::get<StoredField>(read).field);
    return true;
  };
  for (int k = 0; k < 60; ++k)
    EXPECT_FALSE(damaged(whole.substr(0, random() % whole.size())));
  for (int k = 0; k < 300; ++k) {
    std::string changed = whole;
    // Half of them where lengths and names stand, before the arrays.
    changed[random() % (k % 2 ? whole.size() : 400)] = static_cast<char>(random());
    (void)damaged(changed);
  }
  EXPECT_FALSE(damaged(""));
  EXPECT_TRUE(
      std::holds_alternative<std::string>(read_field(folder / "nowhere.field")));
}

}  // namespace
}  // namespace delos::session
