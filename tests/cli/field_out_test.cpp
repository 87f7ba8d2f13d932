// delos field --out: files by suffix.
#include <gtest/gtest.h>

#include <algorithm>

#include "program.h"

namespace delos::test {
namespace {

TEST(FieldOut, WritesEachFormatAndSaysSo) {
  const Folder folder;
  const std::vector<std::pair<std::string, std::string>> formats = {
      {"f.vti", "<?xml"},
      {"f.vtp", "<?xml"},
      {"f.csv", "x,y,z,value,observable\n0,0,0,"},
      {"f.json", "{\n"},
      {"f.png", "\x89PNG\r\n\x1a\n"}};  // the signature of PNG
  std::vector<std::string> words = {"field", scene("01-acoustic")};
  for (const auto& [name, _] : formats) words.insert(words.end(), {"--out", name});
  const Finished done = run(words, folder.path());
  ASSERT_EQ(done.code, 0) << done.err;
  for (const auto& [name, start] : formats) {
    EXPECT_EQ(read_file(folder.path() / name).substr(0, start.size()), start) << name;
    EXPECT_NE(done.out.find("wrote " + name + "\n"), std::string::npos) << done.out;
  }
  // Nothing but them: no temporary file is left.
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 5);
}

TEST(FieldOut, KeepsStdoutForTheDocument) {
  const Folder folder;
  const Finished done =
      run({"field", scene("01-acoustic"), "--json", "--out", "f.csv"}, folder.path());
  EXPECT_EQ(done.json()["samples"], 25578);
  const std::string table = read_file(folder.path() / "f.csv");
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 1 + 25578);
}

/// The .json file is the contract's document with the samples.
TEST(FieldOut, AgreesWithTheStatistics) {
  const Folder folder;
  const Json said =
      run({"field", scene("02-eight-cameras"), "--json", "--out", "f.json"},
          folder.path())
          .json();
  const Json file = Json::parse(read_file(folder.path() / "f.json"));
  EXPECT_EQ(file["max"], said["max"]);
  ASSERT_EQ(file["values"].size(), 2541u);
  int seen = 0;
  double least = 1e300, greatest = 0;
  for (const Json& row : file["values"]) {
    EXPECT_EQ(row[3].is_null(), row[4] == 0);
    if (row[3].is_null()) continue;
    ++seen;
    least = std::min(least, row[3].get<double>());
    greatest = std::max(greatest, row[3].get<double>());
  }
  EXPECT_EQ(seen, said["observable"]);
  EXPECT_EQ(least, said["min"]["value"]);
  EXPECT_EQ(greatest, said["max"]["value"]);
}

/// Same input, same bytes.
TEST(FieldOut, HasTheSameBytesOnAnyNumberOfThreads) {
  for (const char* name : {"01-acoustic", "02-eight-cameras", "03-hybrid"}) {
    const Folder folder;
    for (const std::string threads : {"1", "8"}) {
      ASSERT_EQ(run({"field", scene(name), "--threads", threads, "--out",
                     threads + ".csv", "--out", threads + ".vti"},
                    folder.path())
                    .code,
                0);
    }
    for (const std::string suffix : {".csv", ".vti"}) {
      const std::string one = read_file(folder.path() / ("1" + suffix));
      EXPECT_FALSE(one.empty());
      // Not EXPECT_EQ: it would print both.
      EXPECT_TRUE(one == read_file(folder.path() / ("8" + suffix))) << name << suffix;
    }
  }
}

struct Refused {
  std::string file, set, message;
};

/// Refused before the evaluation, and nothing is written.
TEST(FieldOut, RefusesWhatCannotBeWritten) {
  const std::string kPoint = "sample={points: [[0, 0, 0]]}";
  const Refused table[] = {
      {"f.foo", "metric=eigmax",
       "f.foo: '.foo' isn't a format that can be written; known are .vti .vtu .vtp "
       ".csv "
       ".json .png"},
      {"field", "metric=eigmax",
       "field: no suffix to tell the format by; known are .vti .vtu .vtp .csv .json "
       ".png"},
      {"f.vti", kPoint,
       "f.vti: .vti holds a volume and these samples aren't one; .vtp takes any "
       "points"},
      {"f.png", kPoint,
       "f.png: a .png shows a volume or a plane and these samples are scattered; .vtp "
       "and .csv take any points"},
  };
  for (const Refused& row : table) {
    const Folder folder;
    const Finished done = run(
        {"field", scene("01-acoustic"), "--set", row.set, "--out", row.file, "--json"},
        folder.path());
    EXPECT_EQ(done.code, 2);
    EXPECT_EQ(done.out, "");
    EXPECT_EQ(done.err, "delos: " + row.message + "\n");
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  }
}

TEST(FieldOut, RefusesAFolderThatIsMissing) {
  const Folder folder;
  const Finished done = run(
      {"field", scene("01-acoustic"), "--out", "nowhere/f.csv", "--out", "good.csv"},
      folder.path());
  EXPECT_EQ(done.code, 2);
  EXPECT_NE(done.err.find("nowhere"), std::string::npos) << done.err;
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace delos::test
