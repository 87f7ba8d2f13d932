// Who may know whom: explorer -> optimizers -> kernel <- plugins, within each of them
// downwards from room to room, and one room for each library.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <regex>
#include <set>
#include <string>

#include "sources.h"

namespace delos::test {
namespace {

bool starts(const std::string& text, const std::string& with) {
  return text.rfind(with, 0) == 0;
}

/// <vector>, but neither <unistd.h> nor <yaml-cpp/yaml.h>.
bool is_standard(const Include& i) {
  return !i.quoted && i.file.find_first_of("/.") == std::string::npos;
}

bool is_eigen(const Include& i) { return !i.quoted && starts(i.file, "Eigen/"); }

/// A file that exists in one of these folders of the root, or beside the source.
bool is_own(const Include& i, const Source& source,
            const std::vector<std::string>& folders) {
  const auto beside = (root() / source.path).parent_path() / i.file;
  if (i.quoted && std::filesystem::exists(beside)) return true;
  for (const std::string& folder : folders) {
    if (std::filesystem::exists(root() / folder / i.file)) return true;
  }
  return false;
}

TEST(Arrows, AreReadFromAllFiles) {
  // Enough to know that the folders are the right ones.
  EXPECT_GE(sources("kernel/include").size(), 20u);
  EXPECT_GE(sources("kernel/src").size(), 50u);
  EXPECT_GE(sources("plugins").size(), 3u);
  EXPECT_GE(sources("explorer").size(), 10u);
  EXPECT_GE(sources("optimizers").size(), 10u);
  EXPECT_GE(includes(sources("plugins").front()).size(), 1u);
}

/// The kernel's own files come from the kernel: none is reached in explorer or plugins.
TEST(Arrows, LeadFromTheKernelToNobody) {
  for (const Source& source : sources("kernel")) {
    for (const Include& i : includes(source)) {
      if (i.quoted) {
        EXPECT_TRUE(is_own(i, source, {"kernel/include", "kernel/src"}))
            << source.path << " includes " << i.file;
      }
      EXPECT_EQ(i.file.find(".."), std::string::npos) << source.path;
      for (const char* folder : {"explorer/", "optimizers/", "plugins/"})
        EXPECT_EQ(i.file.find(folder), std::string::npos) << source.path;
    }
  }
}

TEST(Arrows, LeadFromPublicHeadersToPublicHeaders) {
  const auto check = [](const std::string& room,
                        const std::vector<std::string>& folders) {
    for (const Source& source : sources(room)) {
      for (const Include& i : includes(source)) {
        const bool public_header = starts(i.file, "delos/") && is_own(i, {}, folders);
        // The loops, which run where they are included.
        const bool loop =
            i.file == "omp.h" && starts(source.path, "kernel/include/delos/parallel/");
        EXPECT_TRUE(public_header || is_standard(i) || is_eigen(i) || loop)
            << source.path << " includes " << i.file;
      }
    }
  };
  check("kernel/include", {"kernel/include"});
  check("optimizers/include", {"kernel/include", "optimizers/include"});
}

/// Searches use the kernel as anybody could, and know nothing of the program.
TEST(Arrows, LeadFromTheOptimizersToPublicHeaders) {
  for (const Source& source : sources("optimizers")) {
    for (const Include& i : includes(source)) {
      if (!i.quoted) continue;
      EXPECT_TRUE(
          is_own(i, source, {"kernel/include", "optimizers/include", "optimizers"}))
          << source.path << " includes " << i.file;
      EXPECT_EQ(i.file.find(".."), std::string::npos) << source.path;
      EXPECT_EQ(i.file.find("explorer/"), std::string::npos) << source.path;
    }
  }
}

TEST(Arrows, LeadFromPluginsToPublicHeaders) {
  for (const Source& source : sources("plugins")) {
    for (const Include& i : includes(source)) {
      const bool public_header =
          starts(i.file, "delos/") && is_own(i, {}, {"kernel/include"});
      const bool beside = i.quoted && !starts(i.file, "..") && is_own(i, source, {});
      EXPECT_TRUE(public_header || beside || is_standard(i) || is_eigen(i))
          << source.path << " includes " << i.file;
    }
  }
}

/// The program uses kernel and searches as anybody could: by their public headers.
TEST(Arrows, LeadFromTheExplorerToPublicHeaders) {
  for (const Source& source : sources("explorer")) {
    for (const Include& i : includes(source)) {
      if (!i.quoted) continue;
      EXPECT_TRUE(
          is_own(i, source, {"kernel/include", "optimizers/include", "explorer"}))
          << source.path << " includes " << i.file;
      EXPECT_EQ(i.file.find(".."), std::string::npos) << source.path;
    }
  }
}

/// The command line has options and words: what is asked of a scene is the session's,
/// so that pages and notebooks can ask it too.
TEST(Arrows, LeadFromTheCommandLineToTheSession) {
  for (const Source& source : sources("explorer/cli")) {
    for (const Include& i : includes(source)) {
      EXPECT_TRUE(!starts(i.file, "delos/") || starts(i.file, "delos/text/"))
          << source.path << " includes " << i.file;
    }
  }
}

/// The rooms of a library, lowest first: a source knows its own room and those below.
struct House {
  const char* folder;              ///< what is left out of a path before its room
  std::vector<std::string> rooms;  ///< a folder each
};

/// The room that a path below `folder` is in, as an index; nullopt where it is in none.
std::optional<std::size_t> room_of(const House& house, const std::string& path) {
  const std::string room = path.substr(0, path.find('/'));
  const auto found = std::find(house.rooms.begin(), house.rooms.end(), room);
  if (found == house.rooms.end()) return std::nullopt;
  return static_cast<std::size_t>(found - house.rooms.begin());
}

/// Every include of a source in `folder` leads to its own room or to one below.
void expect_downwards(const House& house, const std::string& prefix) {
  int read = 0;
  for (const Source& source : sources(house.folder)) {
    const std::string path = source.path.substr(std::string(house.folder).size() + 1);
    const auto room = room_of(house, path);
    if (path.find('/') == std::string::npos) continue;  // what all rooms share
    ASSERT_TRUE(room) << source.path << " is in a room that nobody listed";
    for (const Include& i : includes(source)) {
      if (!i.quoted) continue;
      const std::string file =
          starts(i.file, prefix) ? i.file.substr(prefix.size()) : i.file;
      const auto other = room_of(house, file);
      if (!other) continue;
      ++read;
      EXPECT_LE(*other, *room) << source.path << " includes " << i.file;
    }
  }
  EXPECT_GE(read, 20) << house.folder;
}

TEST(Arrows, LeadDownwardsFromRoomToRoomOfTheKernel) {
  const std::vector<std::string> rooms = {
      "text",     "parallel", "expression", "model",    "riccati",   "geometry",
      "sampling", "device",   "plugin",     "document", "scene",     "rig",
      "observe",  "layers",   "steady",     "field",    "simulation"};
  expect_downwards({"kernel/src", rooms}, "delos/");
  expect_downwards({"kernel/include/delos", rooms}, "delos/");
}

TEST(Arrows, LeadDownwardsFromRoomToRoomOfTheOptimizers) {
  expect_downwards({"optimizers",
                    {"include", "study", "nlopt", "problem", "crew", "search", "cover",
                     "selection", "tradeoff"}},
                   "");
}

TEST(Arrows, LeadDownwardsFromRoomToRoomOfTheExplorer) {
  expect_downwards(
      {"explorer",
       {"output", "recordings", "motion", "measured", "readings", "imports", "shapes",
        "session", "figures", "render", "bundle", "server", "report", "cli"}},
      "");
}

struct Home {
  const char* library;
  std::regex header;
  std::vector<std::string> folders;
};

TEST(Arrows, LeadToEachLibraryFromItsRoom) {
  const Home homes[] = {
      {"yaml-cpp",
       std::regex("yaml-cpp/.*"),
       {"kernel/src/document/", "explorer/imports/",
        "explorer/session/value_tree.cpp"}},
      {"pugixml", std::regex("pugixml.*"), {"explorer/imports/"}},
      {"toml++", std::regex("toml\\+\\+/.*"), {"explorer/imports/"}},
      {"Boost",
       std::regex("boost/.*"),
       {"kernel/src/plugin/", "kernel/src/expression/", "kernel/src/simulation/",
        "explorer/motion/", "explorer/readings/", "explorer/session/",
        "explorer/server/"}},
      {"CGAL", std::regex("CGAL/.*"), {"kernel/src/geometry/"}},
      {"Cairo",
       std::regex("(cairo/)?cairo.*"),
       {"explorer/output/", "explorer/render/"}},
      {"nlohmann",
       std::regex("nlohmann/.*"),
       {"explorer/", "kernel/src/geometry/mesh/"}},
      {"udunits", std::regex("(udunits2/)?udunits.*"), {"kernel/src/text/"}},
      {"OpenMP", std::regex("omp\\.h"), {"kernel/include/delos/parallel/"}},
      {"CLI11", std::regex("CLI/.*"), {"explorer/cli/"}},
      {"NLopt", std::regex("nlopt\\.h.*"), {"optimizers/nlopt/"}},
      {"SQLite", std::regex("sqlite.*"), {"optimizers/study/"}},
      {"MPI", std::regex("mpi\\.h"), {"optimizers/crew/mpi/"}},
      {"pybind11", std::regex("pybind11/.*"), {"python/"}},
  };
  std::vector<Source> all = sources("kernel");
  for (const char* folder : {"plugins", "optimizers", "explorer", "python"}) {
    for (Source& source : sources(folder)) all.push_back(std::move(source));
  }
  for (const Home& home : homes) {
    int uses = 0;
    for (const Source& source : all) {
      bool at_home = false;
      for (const std::string& folder : home.folders) {
        at_home = at_home || starts(source.path, folder);
      }
      for (const Include& i : includes(source)) {
        if (!std::regex_match(i.file, home.header)) continue;
        ++uses;
        EXPECT_TRUE(at_home) << source.path << " includes " << i.file;
      }
    }
    EXPECT_GT(uses, 0) << home.library << ": nobody includes it under this name";
  }
}

/// A new device is a new folder and nothing else, so the kernel names none, not even in
/// a comment. An id that is a plain word, such as imu, counts where it stands in
/// quotes, unless it is a word of scenes anyhow: a type of motion, a beacon's reach, or
/// of surfaces through points.
TEST(Kernel, NamesNoDevice) {
  const std::set<std::string> words = {"custom", "range", "linear"};
  const std::vector<Source> kernel = sources("kernel");
  int devices = 0;
  for (const auto& entry : std::filesystem::directory_iterator(root() / "plugins")) {
    if (!entry.is_directory()) continue;
    ++devices;
    const std::string id = entry.path().filename().string();
    if (words.contains(id)) continue;
    const bool plain = id.find('_') == std::string::npos;
    const std::regex name(plain ? "[\"']" + id + "[\"']" : "\\b" + id + "\\b");
    for (const Source& source : kernel) {
      EXPECT_FALSE(std::regex_search(source.text, name)) << source.path << ": " << id;
    }
  }
  EXPECT_GE(devices, 3);
}

}  // namespace
}  // namespace delos::test
