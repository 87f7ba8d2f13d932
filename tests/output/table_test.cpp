// CSV and JSON: every number back, and nothing that a parser would choke on.
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>

#include "output/fields.h"
#include "output/write.h"

namespace delos {
namespace {

using Json = nlohmann::ordered_json;

/// Doubles that are hard to print: no short decimal form, subnormal, huge, negative
/// zero.
Field hard_numbers() {
  Field field = scattered({0.1, 1.0 / 3, 5e-324, 1.7976931348623157e308, -0.0,
                           123456789012345680.0, kBlind, std::nan(""), -2.5e-7});
  field.samples.points[1] = {0.1 + 0.2, -1e-300, 1e21};
  return field;
}

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

void expect_no_infinity(const std::string& text) {
  for (const char* word : {"nan", "NaN", "inf", "Inf"})
    EXPECT_EQ(text.find(word), std::string::npos) << word;
}

TEST(Csv, ReadsBackBitForBit) {
  const Folder folder;
  const Field field = hard_numbers();
  ASSERT_EQ(write_field(field, folder / "f.csv"), "");
  const std::string bytes = bytes_of(folder / "f.csv");
  expect_no_infinity(bytes);
  EXPECT_EQ(bytes.find('\r'), std::string::npos);

  std::istringstream lines(bytes);
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "x,y,z,value,observable");
  for (std::size_t i = 0; i < field.value.size(); ++i) {
    ASSERT_TRUE(std::getline(lines, line)) << i;
    std::vector<std::string> cells(1);
    for (const char c : line) {
      if (c == ',')
        cells.emplace_back();
      else
        cells.back() += c;
    }
    ASSERT_EQ(cells.size(), 5u) << line;
    for (int k = 0; k < 3; ++k) {
      EXPECT_TRUE(
          same_bits(std::strtod(cells[k].c_str(), nullptr), field.samples.points[i][k]))
          << line;
    }
    if (std::isfinite(field.value[i]))
      EXPECT_TRUE(same_bits(std::strtod(cells[3].c_str(), nullptr), field.value[i]))
          << line;
    else
      EXPECT_EQ(cells[3], "");
    EXPECT_EQ(cells[4], field.observable[i] != 0 ? "1" : "0");
  }
  EXPECT_FALSE(std::getline(lines, line));
}

TEST(Csv, UsesTheShortestText) {
  const Folder folder;
  ASSERT_EQ(write_field(scattered({0.1}), folder / "f.csv"), "");
  EXPECT_EQ(bytes_of(folder / "f.csv"), "x,y,z,value,observable\n0,0.5,-0.25,0.1,1\n");
}

TEST(Json, HoldsEveryValue) {
  const Folder folder;
  const Field field = hard_numbers();
  ASSERT_EQ(write_field(field, folder / "f.json"), "");
  const std::string bytes = bytes_of(folder / "f.json");
  expect_no_infinity(bytes);
  const Json json = Json::parse(bytes);
  EXPECT_EQ(json["columns"], Json({"x", "y", "z", "value", "observable"}));
  ASSERT_EQ(json["values"].size(), field.value.size());
  for (std::size_t i = 0; i < field.value.size(); ++i) {
    const Json& row = json["values"][i];
    ASSERT_EQ(row.size(), 5u);
    for (int k = 0; k < 3; ++k)
      EXPECT_TRUE(same_bits(row[k].get<double>(), field.samples.points[i][k])) << row;
    EXPECT_EQ(row[3].is_null(), !std::isfinite(field.value[i]));
    if (std::isfinite(field.value[i])) {
      EXPECT_EQ(row[3].get<double>(), field.value[i]) << row;
    }
    EXPECT_EQ(row[4], field.observable[i]);
  }
}

TEST(Json, StartsWithTheMembersOfTheSummary) {
  const Folder folder;
  const Field field = scattered({1, kBlind, 3});
  ASSERT_EQ(write_field(field, folder / "f.json"), "");
  Json json = Json::parse(bytes_of(folder / "f.json"));
  json.erase("columns");
  json.erase("values");
  EXPECT_EQ(json, Json::parse(field_json(field)));
}

TEST(Json, OfNoSamplesIsADocument) {
  const Folder folder;
  ASSERT_EQ(write_field(empty_field(), folder / "f.json"), "");
  EXPECT_TRUE(Json::parse(bytes_of(folder / "f.json"))["values"].empty());
}

std::vector<std::string> names(const Json& object) {
  std::vector<std::string> list;
  for (const auto& [key, value] : object.items()) list.push_back(key);
  return list;
}

TEST(FieldJson, HasTheMembersOfTheContractInOrder) {
  Field field = scattered({1, kBlind, 3});
  field.evaluations = 12;
  field.threads = 2;
  field.seconds = 0.5;
  const std::string text = field_json(field);
  EXPECT_EQ(text.substr(text.size() - 3), "\n}\n");
  EXPECT_EQ(text.substr(0, 14), "{\n  \"scene\": \"");
  const Json json = Json::parse(text);
  EXPECT_EQ(names(json), (std::vector<std::string>{
                             "scene", "metric", "fusion", "covariance", "samples",
                             "observable", "finite", "one_short", "min", "max", "mean",
                             "median", "p95", "evaluations", "threads", "seconds"}));
  EXPECT_EQ(json["scene"], "test");
  EXPECT_EQ(json["metric"], Json({{"name", "eigmax"}, {"unit", "m"}}));
  EXPECT_EQ(json["samples"], 3);
  EXPECT_EQ(json["observable"], 2);
  EXPECT_EQ(json["finite"], 2);
  EXPECT_EQ(json["min"]["value"], 1);
  EXPECT_EQ(json["max"]["value"], 3);
  EXPECT_EQ(json["max"]["at"], Json({2.0, 0.5, -0.25}));
  EXPECT_EQ(json["mean"], 2);
  EXPECT_EQ(json["evaluations"], 12);
  EXPECT_EQ(json["threads"], 2);
  EXPECT_EQ(json["seconds"], 0.5);
}

TEST(FieldJson, SaysNullWhereNothingIsFinite) {
  const Json json = Json::parse(field_json(scattered({kBlind, std::nan("")})));
  for (const char* name : {"min", "max", "mean", "median", "p95"})
    EXPECT_TRUE(json[name].is_null()) << name;
  EXPECT_EQ(json["samples"], 2);
}

TEST(FieldJson, TellsPartsApartWhereThereAreSeveral) {
  Field field = scattered({1, 2});
  add_part(field, {"shelf", 0, 0, ScatteredShape{}}, {{9, 9, 9}}, {kBlind});
  const Json json = Json::parse(field_json(field));
  ASSERT_EQ(json["parts"].size(), 2u);
  EXPECT_EQ(json["parts"][0]["max"]["value"], 2);
  EXPECT_EQ(json["parts"][1]["name"], "shelf");
  EXPECT_EQ(json["parts"][1]["samples"], 1);
  EXPECT_TRUE(json["parts"][1]["min"].is_null());
  EXPECT_EQ(json["finite"], 2);
}

TEST(FieldJson, SurvivesAnySceneName) {
  Field field = scattered({1});
  field.scene = "quote \" slash \\ line\n bad \xff\xfe byte";
  EXPECT_NO_THROW({
    const std::string scene = Json::parse(field_json(field))["scene"];
    EXPECT_EQ(scene, "quote \" slash \\ line\n bad \uFFFD\uFFFD byte");
  });
}

}  // namespace
}  // namespace delos
