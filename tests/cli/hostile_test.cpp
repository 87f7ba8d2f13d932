// What isn't a file, names that terminals obey, output that is lost.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "program.h"

namespace delos::test {
namespace {

const std::string kScene = R"(delos: 1
motion: {type: position_velocity, q: [0.4, 0.4, 0.4]}
sample: {points: [[1, 1, 1]]}
devices:
  - {name: a, type: uwb_range, rate: 10 Hz, at: [0, 0, 0], params: {sigma: 10 cm}}
  - {name: b, type: uwb_range, rate: 10 Hz, at: [4, 0, 1], params: {sigma: 10 cm}}
  - {name: c, type: uwb_range, rate: 10 Hz, at: [0, 4, 2], params: {sigma: 10 cm}}
variables: [{path: devices.a.at.x, lower: -1, upper: 1}]
)";

std::string with(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

TEST(Output, ThatIsLostIsSaid) {
  const Folder folder;
  const std::string file = folder.write("room.yaml", kScene).string();
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{"field", file},
                                             {"field", file, "--json"},
                                             {"point", file, "--at", "1,1,1"},
                                             {"compare", file, file},
                                             {"check", file},
                                             {"devices"},
                                             {"devices", "linear", "--json"},
                                             {"optimize", file, "--evaluations", "3"},
                                             {"--help"},
                                             {"--version"}}) {
    const Finished done = run(words, {}, "/dev/full");
    EXPECT_EQ(done.code, 1) << words[0];
    EXPECT_NE(done.err.find("delos: the output can't be written"), std::string::npos)
        << words[0] << done.err;
  }
}

TEST(WhatIsNoFile, IsNotRead) {
  const Folder folder;
  ASSERT_EQ(mkfifo((folder.path() / "pipe.yaml").c_str(), 0600), 0);
  ASSERT_EQ(mkfifo((folder.path() / "pipe.off").c_str(), 0600), 0);
  ASSERT_EQ(mkfifo((folder.path() / "pipe.so").c_str(), 0600), 0);
  std::filesystem::create_symlink("/dev/zero", folder.path() / "zero.csv");
  const auto check = [&](const std::string& name, const std::string& text) {
    folder.write(name, text);
    return run({"check", name, "--plugin-dir", "."}, folder.path()).err;
  };
  EXPECT_EQ(run({"check", "pipe.yaml"}, folder.path()).err,
            "pipe.yaml: error: the scene can't be read: it isn't a file\n");
  EXPECT_EQ(run({"check", "/dev/zero"}).err,
            "/dev/zero: error: the scene can't be read: it isn't a file\n");
  EXPECT_EQ(
      check("base.yaml", "extends: pipe.yaml\n"),
      "base.yaml:1:10: error: extends: there is no readable scene 'pipe.yaml': it "
      "isn't a file\n");
  EXPECT_EQ(check("points.yaml", with(kScene, "points: [[1, 1, 1]]", "file: zero.csv")),
            "points.yaml:3:16: error: sample.file: there is no readable file "
            "'zero.csv': it isn't a file\n");
  EXPECT_EQ(check("mesh.yaml", kScene + "occluders: [{mesh: pipe.off}]\n"),
            "mesh.yaml:9:20: error: occluders.0.mesh: pipe.off: isn't a file\n");
  EXPECT_EQ(
      check("plugin.yaml", with(kScene, "type: uwb_range", "type: pipe")),
      "plugin.yaml:5:21: error: devices.a.type: ./pipe.so is not a shared library; "
      "rebuild it with delos_add_device() or remove it\n");
}

TEST(WhatIsNoFile, IsWrittenToAndNotReplaced) {
  const Folder folder;
  const std::string scene = folder.write("room.yaml", kScene).string();
  const auto pipe = folder.path() / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::filesystem::create_symlink("pipe", folder.path() / "out.csv");
  std::string received;
  std::thread reader([&] { received = read_file(pipe); });
  const Finished done = run({"field", scene, "--out", "out.csv"}, folder.path());
  reader.join();
  EXPECT_EQ(done.code, 0) << done.err;
  EXPECT_TRUE(received.starts_with("x,y,z,value,observable\n1,1,1,")) << received;
  EXPECT_TRUE(std::filesystem::is_fifo(pipe));
}

TEST(Names, ThatTerminalsObeyAreRefusedAndNotPrinted) {
  const Folder folder;
  for (const char* escape : {"\\e[31m", "\\x9b31m", "\\x07"}) {
    const auto title = folder.write(
        "title.yaml", with(kScene, "delos: 1\n",
                           std::string("delos: 1\nname: \"red ") + escape + "\"\n"));
    const auto device = folder.write(
        "device.yaml",
        with(kScene, "name: a", std::string("name: \"red ") + escape + "\""));
    for (const auto& file : {title, device}) {
      const Finished done = run({"field", file.string()});
      EXPECT_EQ(done.code, 1) << escape;
      EXPECT_NE(done.err.find("holds a control character"), std::string::npos)
          << done.err;
      EXPECT_EQ(done.out, "");
      EXPECT_TRUE(std::none_of(done.err.begin(), done.err.end(), [](char c) {
        return static_cast<unsigned char>(c) < ' ' && c != '\n';
      })) << escape;
      EXPECT_EQ(done.err.find("\xC2\x9B"), std::string::npos) << escape;
    }
  }
}

TEST(Names, ThatAreNotUtf8BecomeSoInJson) {
  const Folder folder;
  const auto file =
      folder.write("latin.yaml", with(kScene, "name: b", "name: caf\xE9"));
  const Finished point = run({"point", file.string(), "--at", "1,1,1", "--json"});
  EXPECT_EQ(point.code, 0) << point.err;
  EXPECT_EQ(point.json()["devices"][1]["name"], "caf\uFFFD");
}

TEST(Devices, WantATypeAndAFolder) {
  const Folder folder;
  const auto file =
      folder.write("empty.yaml", with(kScene, "type: uwb_range", "type: \"\""));
  const Finished done = run({"check", "empty.yaml"}, folder.path());
  EXPECT_EQ(done.code, 1);
  EXPECT_EQ(
      done.err,
      "empty.yaml:5:21: error: devices.a.type: is empty; 'delos devices' lists the "
      "plugins\n");
  const Finished devices = run({"devices", "--plugin-dir", "/no/such/folder"});
  EXPECT_EQ(devices.code, 1);
  EXPECT_EQ(devices.err,
            "delos: --plugin-dir /no/such/folder: No such file or directory\n");
}

TEST(Slices, ThatMissTheFieldAreRefused) {
  const Folder folder;
  const auto file = folder.write(
      "room.yaml", with(kScene, "points: [[1, 1, 1]]",
                        "volume: {min: [0, 0, 0], max: [1, 1, 0.8], step: 0.2}"));
  const auto cut = [&](const char* z) {
    return run({"field", file.string(), "--slice", z, "--out", "a.png"}, folder.path());
  };
  EXPECT_EQ(cut("5").err,
            "delos: --slice '5': the field reaches from z = 0 m to 800 mm\n");
  EXPECT_EQ(cut("5").code, 2);
  EXPECT_EQ(cut("80 cm").code, 0);
}

TEST(Nesting, ThatIsTooDeepIsSaid) {
  const Folder folder;
  folder.write("deep.yaml", "x: " + std::string(600, '['));
  const Finished done = run({"check", "deep.yaml"}, folder.path());
  EXPECT_EQ(done.code, 1);
  EXPECT_NE(done.err.find("not a readable YAML text: lists and mappings are nested too "
                          "deeply\n"),
            std::string::npos)
      << done.err;
}

// Each anchor stands for what it is in, which is kept once a level: 400 levels of
// 20,000 numbers were 750 MB.
TEST(Anchors, AreNotCopiedWithoutEnd) {
  const Folder folder;
  std::string text = "x: ";
  for (int level = 0; level < 400; ++level) text += "&a" + std::to_string(level) + " [";
  for (int i = 0; i < 20000; ++i) text += "1,";
  text += std::string(400, ']') + "\n";
  folder.write("anchors.yaml", text);
  const Finished done = run({"check", "anchors.yaml"}, folder.path());
  EXPECT_EQ(done.code, 1);
  EXPECT_NE(done.err.find("anchors and aliases make this text too large"),
            std::string::npos)
      << done.err.substr(0, 500);
}

/// Characters that a terminal shows, of which UTF-8 takes several bytes.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  }));
}

// One variable of micrometres beside one of metres: "->" stands below "->".
TEST(Columns, StandBelowEachOther) {
  const Folder folder;
  std::string text = with(kScene, "at: [4, 0, 1]", "at: [4, 0, 5 um]");
  text = with(text, "upper: 1}",
              "upper: 1}, {path: devices.b.at.z, lower: 1 um, upper: 9 um}");
  const auto file = folder.write("room.yaml", text);
  const Finished done = run({"optimize", file.string(), "--evaluations", "3"});
  std::vector<std::size_t> arrows;
  for (std::size_t line = 0; line < done.out.size();) {
    const std::size_t end = std::min(done.out.find('\n', line), done.out.size());
    const std::string row = done.out.substr(line, end - line);
    if (row.starts_with("  devices."))
      arrows.push_back(width_of(row.substr(0, row.find("->"))));
    line = end + 1;
  }
  ASSERT_EQ(arrows.size(), 2u) << done.out << done.err;
  EXPECT_NE(done.out.find("µm"), std::string::npos) << done.out;
  EXPECT_EQ(arrows[0], arrows[1]) << done.out;
}

}  // namespace
}  // namespace delos::test
