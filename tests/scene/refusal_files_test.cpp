// Bad files: points and scenes that cannot be read.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "scene/load.h"

namespace delos::test {
namespace {

std::vector<std::string> findings_of_file(const std::string& name,
                                          const std::string& content) {
  const Folder folder;
  std::ofstream(folder / name, std::ios::binary) << content;
  Diagnostics diagnostics;
  EXPECT_FALSE(
      parse_scene(good_with("volume: {min: [0, 0, 0], max: [0.4, 0.4, 0.8], step: "
                            "0.04}",
                            "file: " + name),
                  folder / "scene.yaml", {}, plugins(), diagnostics));
  std::vector<std::string> findings;
  for (Diagnostic& d : diagnostics) {
    d.where.file = std::filesystem::path(d.where.file).filename();
    findings.push_back(to_string(d));
  }
  return findings;
}

TEST(RefusalOfPointFiles, IsLocatedInThem) {
  EXPECT_EQ(
      findings_of_file("a.ptl", "; heading\n0 0 0\n1 2\n1 2 3 4\n\n1 2 x\n1 nan 3\n"),
      (std::vector<std::string>{
          "a.ptl:3:3: error: expected three numbers x y z, found 2",
          "a.ptl:4:7: error: expected three numbers x y z, found 4",
          "a.ptl:6:5: error: 'x' isn't a number; rows are x y z in metres",
          "a.ptl:7:3: error: 'nan' isn't a finite number"}));
  EXPECT_EQ(
      findings_of_file("a.csv", "x,y,z\n1,2,3\nx,y,z\n1,,3\n1 m,2,3\n1,2,010\n"),
      (std::vector<std::string>{
          "a.csv:3:1: error: 'x' isn't a number; rows are x,y,z in metres",
          "a.csv:4:3: error: '' isn't a number; rows are x,y,z in metres",
          "a.csv:5:1: error: '1 m' isn't a number; rows are x,y,z in metres",
          "a.csv:6:5: error: '010' has a leading zero; numbers are decimal, leave it "
          "out"}));
}

// As spreadsheets write them where a comma is the decimal point, and as some editors
// do.
TEST(RefusalOfPointFiles, SaysWhatSemicolonsAre) {
  const std::string hint =
      "; ';' begins a comment: separate numbers by ',' and write decimals with a point";
  EXPECT_EQ(findings_of_file("a.csv", "0,1;0,2;0,3\n0.1;0.2;0.3\n"),
            (std::vector<std::string>{
                "a.csv:1:3: error: expected three numbers x,y,z, found 2" + hint,
                "a.csv:2:1: error: expected three numbers x,y,z, found 1" + hint}));
  // With a mark of the order of bytes, and in both orders without.
  for (const std::string& bytes :
       {std::string("\xFF\xFE"
                    "1\0,\0",
                    6),
        std::string("1\0,\0", 4), std::string("\0001\0,", 4)}) {
    const auto wide = findings_of_file("a.csv", bytes);
    ASSERT_EQ(wide.size(), 1u);
    EXPECT_TRUE(wide[0].ends_with("a.csv' is UTF-16; save it as UTF-8")) << wide[0];
  }
}

TEST(RefusalOfPointFiles, SaysHowDecimalsAreWritten) {
  const auto hint = [](const std::string& between) {
    return "; separate numbers by '" + between + "' and write decimals with a point";
  };
  EXPECT_EQ(
      findings_of_file("a.csv", "0,1 0,2 0,3\n\"0,1\",\"0,2\",\"0,3\"\n1,2,3,4\n"),
      (std::vector<std::string>{
          "a.csv:1:11: error: expected three numbers x,y,z, found 4" + hint(","),
          "a.csv:2:10: error: expected three numbers x,y,z, found 6" + hint(","),
          "a.csv:3:7: error: expected three numbers x,y,z, found 4"}));
  EXPECT_EQ(
      findings_of_file("a.ptl", "0,1 0,2 0,3\n0,1,2\n"),
      (std::vector<std::string>{
          "a.ptl:1:1: error: '0,1' isn't a number; rows are x y z in metres" +
              hint(" "),
          "a.ptl:2:1: error: expected three numbers x y z, found 1" + hint(" ")}));
}

TEST(RefusalOfPointFiles, StopsWhereTheFileIsOfAnotherKind) {
  std::string text;
  for (int i = 0; i < 100; ++i) text += "these are no numbers\n";
  const auto findings = findings_of_file("a.ptl", text);
  ASSERT_EQ(findings.size(), 21u);
  EXPECT_EQ(
      findings[20],
      "a.ptl:21: error: too many malformed rows; the rest of the file wasn't read");
}

TEST(RefusalOfPointFiles, WantsAtLeastOnePoint) {
  const auto findings = findings_of_file("a.csv", "x,y,z\n\n# nothing\n");
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].substr(0, 40), "scene.yaml:8:9: error: sample.file: the ");
}

TEST(RefusalOfFiles, NamesTheFile) {
  Diagnostics diagnostics;
  EXPECT_FALSE(load_scene("nowhere/scene.yaml", {}, plugins(), diagnostics));
  ASSERT_EQ(diagnostics.size(), 1u);
  EXPECT_EQ(to_string(diagnostics[0]),
            "nowhere/scene.yaml: error: the scene can't be read: No such file or "
            "directory");
  EXPECT_EQ(diagnostics[0].severity, Severity::error);
  EXPECT_FALSE(load_scene(".", {}, plugins(), diagnostics));
  EXPECT_EQ(to_string(diagnostics.at(1)),
            ".: error: the scene can't be read: it is a folder");
}

}  // namespace
}  // namespace delos::test
