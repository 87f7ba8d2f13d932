// delos devices: the plugins and their parameter tables.
#include <gtest/gtest.h>

#include "program.h"

namespace delos::test {
namespace {

TEST(DevicesCommand, ListsEveryDeviceOnALine) {
  const Finished done = run({"devices"});
  EXPECT_EQ(done.code, 0) << done.err;
  for (const char* id : {"acoustic_range ", "linear ", "pinhole_camera "}) {
    EXPECT_NE(("\n" + done.out).find("\n" + std::string(id)), std::string::npos) << id;
  }
  const Json all = run({"devices", "--json"}).json();
  EXPECT_GE(all.size(), 3u);
  EXPECT_EQ(all[0]["id"], "accelerometer");  // sorted
}

/// Numbers from plugins/pinhole_camera/README.md and its source.
TEST(DevicesCommand, ShowsATableAsJson) {
  const Json camera = run({"devices", "pinhole_camera", "--json"}).json();
  EXPECT_EQ(camera["id"], "pinhole_camera");
  const Json& params = camera["params"];
  ASSERT_EQ(params.size(), 8u);
  EXPECT_EQ(params[0]["name"], "focal");
  EXPECT_EQ(params[0]["unit"], "m");
  EXPECT_EQ(params[0]["scale"], "log");
  EXPECT_TRUE(params[0]["default"].is_null());
  EXPECT_EQ(params[3]["name"], "near");
  EXPECT_EQ(params[3]["default"], 0.05);
  EXPECT_TRUE(params[3]["upper"].is_null());
  EXPECT_EQ(params[5]["choices"], "pixels|distance");
}

TEST(DevicesCommand, ShowsTheSameTableAsMarkdown) {
  const Json camera = run({"devices", "pinhole_camera", "--json"}).json();
  const Finished table = run({"devices", "pinhole_camera", "--markdown"});
  EXPECT_EQ(table.code, 0);
  EXPECT_EQ(table.out.rfind("### `pinhole_camera` ", 0), 0u);
  EXPECT_NE(table.out.find("\n| parameter | kind | unit | default | range | meaning |\n"
                           "|---|---|---|---|---|---|\n"),
            std::string::npos);
  for (const Json& p : camera["params"]) {
    const std::string row = "\n| `" + p["name"].get<std::string>() + "` | " +
                            p["kind"].get<std::string>() + " | " +
                            p["unit"].get<std::string>() + " | ";
    const std::size_t at = table.out.find(row);
    ASSERT_NE(at, std::string::npos) << row;
    const std::string line =
        table.out.substr(at + 1, table.out.find('\n', at + 1) - at);
    EXPECT_NE(line.find(" | " + p["help"].get<std::string>() + " |\n"),
              std::string::npos)
        << line;
    // Six cells have seven bars; one inside a cell is escaped.
    int bars = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
      bars += line[i] == '|' && (i == 0 || line[i - 1] != '\\');
    }
    EXPECT_EQ(bars, 7) << line;
  }
}

TEST(DevicesCommand, SuggestsTheDeviceThatWasMeant) {
  const Finished done = run({"devices", "pinhole_camara"});
  EXPECT_EQ(done.code, 1);
  EXPECT_EQ(done.out, "");
  EXPECT_EQ(done.err.rfind("delos: there is no plugin 'pinhole_camara' in ", 0), 0u);
  EXPECT_NE(done.err.find("; did you mean 'pinhole_camera'?\n"), std::string::npos)
      << done.err;
}

TEST(DevicesCommand, SaysWhereAPluginBelongs) {
  const Finished done = run({"devices", "sonar"});
  EXPECT_EQ(done.code, 1);
  EXPECT_NE(
      done.err.find("; put its library there, or its folder into DELOS_PLUGIN_PATH\n"),
      std::string::npos)
      << done.err;
}

/// A folder given by hand is searched first, and a broken library is reported beside
/// the ones that work.
TEST(DevicesCommand, ReportsABrokenLibrary) {
  const Folder folder;
  folder.write("sonar.so", "This is a text.\n");
  const Finished done =
      run({"devices", "--json", "--plugin-dir", folder.path().string()});
  EXPECT_EQ(done.code, 1);
  EXPECT_NE(done.err.find("sonar"), std::string::npos) << done.err;
  EXPECT_GE(done.json().size(), 3u);
}

TEST(DevicesCommand, HasOneFormatAtATime) {
  EXPECT_EQ(run({"devices", "--json", "--markdown"}).code, 2);
}

}  // namespace
}  // namespace delos::test
