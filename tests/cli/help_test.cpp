// delos --help: what a newcomer reads first.
#include <gtest/gtest.h>

#include "program.h"

namespace delos::test {
namespace {

const std::vector<std::string> kCommands = {
    "field",      "point",    "compare",         "check",       "devices",
    "new-device", "simulate", "optimize",        "study",       "tradeoff",
    "report",     "demo",     "explore",         "sample-time", "fit-motion",
    "motions",    "noise",    "power",           "shutter",     "import",
    "export",     "render",   "compare-measured"};

TEST(Help, ListsEveryCommandAndTheExitCodes) {
  const Finished done = run({"--help"});
  EXPECT_EQ(done.code, 0);
  EXPECT_EQ(done.err, "");
  for (const std::string& command : kCommands) {
    EXPECT_NE(done.out.find("\n  " + command + " "), std::string::npos) << command;
  }
  EXPECT_NE(
      done.out.find("0 done, 1 scene, plugin or output at fault, 2 usage, 3 cancelled"),
      std::string::npos);
}

/// Each command's help ends with a line that can be typed.
TEST(Help, ShowsAnExampleOfEachCommand) {
  for (const std::string& command : kCommands) {
    const Finished done = run({command, "--help"});
    EXPECT_EQ(done.code, 0) << command;
    const std::size_t examples = done.out.find("Example");
    ASSERT_NE(examples, std::string::npos) << command;
    EXPECT_NE(done.out.find("\n  delos " + command, examples), std::string::npos)
        << done.out;
  }
}

TEST(Help, TellsTheVersion) {
  const Finished done = run({"--version"});
  EXPECT_EQ(done.code, 0);
  EXPECT_EQ(done.out.rfind("delos ", 0), 0u);
}

/// Fast and drawn, with what to try next.
TEST(Demo, EvaluatesTheLaboratory) {
  const Folder folder;
  const Finished done = run({"demo", "--out", "lab.png"}, folder.path());
  EXPECT_EQ(done.code, 0) << done.err;
  // The scene's own counts: points that two cameras or more see.
  EXPECT_NE(done.out.find("10296 samples, 10181 observable, "), std::string::npos);
  EXPECT_NE(done.out.find("The picture: lab.png\n"), std::string::npos);
  EXPECT_NE(done.out.find("delos point ", done.out.find("Try next: ")),
            std::string::npos);
  EXPECT_EQ(read_file(folder.path() / "lab.png").substr(1, 3), "PNG");
  // Not a terminal, hence no escape codes.
  EXPECT_EQ(done.out.find('\033'), std::string::npos);
}

}  // namespace
}  // namespace delos::test
