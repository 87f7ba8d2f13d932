#include "delos/plugin/registry.h"

#include <gtest/gtest.h>
#include <link.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include "delos/device/faults.h"
#include "support/folder.h"

namespace delos {
namespace {

namespace fs = std::filesystem;

const fs::path kFolder = DELOS_BAD_PLUGINS;

/// The error of a plugin of the bad folder, without the path that it starts with.
std::string error_of(const std::string& id) {
  PluginRegistry plugins({kFolder});
  const PluginLoad& load = plugins.find(id);
  EXPECT_EQ(load.info == nullptr, !load.error.empty()) << load.error;
  EXPECT_EQ(load.path, kFolder / (id + ".so"));
  const std::string start = load.path.string() + " ";
  if (!load.error.starts_with(start)) return load.error;
  return load.error.substr(start.size());
}

TEST(PluginRegistry, OpensAGoodPlugin) {
  PluginRegistry plugins({kFolder});
  const PluginLoad& load = plugins.find("good");
  ASSERT_TRUE(load.info) << load.error;
  EXPECT_STREQ(load.info->id, "good");
  EXPECT_EQ(load.path, kFolder / "good.so");

  ParamValues params;
  params.set("scale", 2.0);
  Observation out;
  ASSERT_TRUE(make_device(*load.info, params)
                  ->observe(Target{.p_ST = {1, 2, 3}, .state = {}}, out));
  EXPECT_EQ(out.z, Eigen::Vector3d(2, 4, 6));
}

TEST(PluginRegistry, OpensAStrippedPlugin) { EXPECT_EQ(error_of("stripped"), ""); }

TEST(PluginRegistry, KeepsItsAnswer) {
  PluginRegistry plugins({kFolder});
  const PluginLoad* good = &plugins.find("good");
  (void)plugins.all();
  EXPECT_EQ(&plugins.find("good"), good);
}

TEST(PluginRegistry, MayBeAskedByManyThreads) {
  constexpr int kThreads = 8, kIds = 24;
  for (int round = 0; round < 20; ++round) {
    PluginRegistry plugins({kFolder});
    std::atomic<int> ready = 0, wrong = 0;
    std::vector<std::thread> threads;
    for (int t = 0; t < kThreads; ++t) {
      threads.emplace_back([&] {
        ++ready;
        while (ready < kThreads) {
        }
        for (int i = 0; i < kIds; ++i) {
          // No path: nothing is opened, so that they meet in what is kept.
          const std::string id = "/" + std::to_string(i);
          const PluginLoad& load = plugins.find(id);
          if (load.error.find("'" + id + "'") == std::string::npos) ++wrong;
        }
      });
    }
    for (std::thread& thread : threads) thread.join();
    ASSERT_EQ(wrong, 0);
    ASSERT_EQ(plugins.all().size(), plugins.ids().size());
  }
}

TEST(PluginRegistry, DevicesOutliveIt) {
  std::shared_ptr<const Device> device;
  {
    PluginRegistry plugins({kFolder});
    ParamValues params;
    params.set("scale", 1.0);
    device = make_device(*plugins.find("good").info, params);
  }
  Observation out;
  EXPECT_TRUE(device->observe(Target{}, out));
}

TEST(BadPlugin, WrongEpoch) {
  EXPECT_EQ(error_of("wrong_epoch"),
            "was built with another plugin contract (kAbiEpoch " +
                std::to_string(kAbiEpoch + 1) + ", the kernel has " +
                std::to_string(kAbiEpoch) + "); rebuild it with the kernel's headers");
}

TEST(BadPlugin, WrongStampSize) {
  EXPECT_EQ(
      error_of("wrong_stamp_size"),
      "was built with another plugin stamp (sizeof(AbiStamp) 68, the kernel has 64); "
      "rebuild it with the kernel's headers");
}

TEST(BadPlugin, WrongAlignment) {
  if (EIGEN_MAX_ALIGN_BYTES != 16 || !fs::exists(kFolder / "wrong_alignment.so")) {
    GTEST_SKIP() << "needs an x86-64 kernel built without -march or -mavx";
  }
  EXPECT_EQ(
      error_of("wrong_alignment"),
      "was built with other -m flags (EIGEN_MAX_ALIGN_BYTES 32, the kernel has 16); "
      "rebuild it without -march/-mavx");
}

TEST(BadPlugin, MissingSymbolIsSeenBeforeAnyOfItsCodeRuns) {
  ASSERT_EQ(unsetenv("DELOS_TEST_MISSING_SYMBOL_RAN"), 0);
  EXPECT_EQ(error_of("missing_symbol"),
            "has no symbol delos_plugin; end its source with DELOS_DEVICE_PLUGIN");
  EXPECT_EQ(std::getenv("DELOS_TEST_MISSING_SYMBOL_RAN"), nullptr);
}

TEST(BadPlugin, NotALibrary) {
  const char* message =
      "is not a shared library; rebuild it with delos_add_device() or remove it";
  EXPECT_EQ(error_of("not_a_library"), message);
  EXPECT_EQ(error_of("empty"), message);
}

TEST(BadPlugin, CutShort) {
  // A download or a build that broke off, at every quarter and within the header.
  const test::Folder folder;
  const auto size = fs::file_size(kFolder / "good.so");
  for (const auto kept : {size * 3 / 4, size / 2, size / 4, std::uintmax_t{40}}) {
    const fs::path file = folder / ("cut" + std::to_string(kept) + ".so");
    fs::copy_file(kFolder / "good.so", file);
    fs::resize_file(file, kept);
    EXPECT_EQ(PluginRegistry({folder.path()}).find(file.stem().string()).error,
              file.string() +
                  " is not a shared library; rebuild it with delos_add_device() or "
                  "remove it");
  }
}

TEST(BadPlugin, Garbled) {
  // Its table of symbols claims 2⁶² bytes, which must be neither read nor reserved.
  std::ifstream good(kFolder / "good.so", std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(good), {}};
  ElfW(Ehdr) header;
  std::memcpy(&header, bytes.data(), sizeof header);
  for (int i = 0; i < header.e_shnum; ++i) {
    char* place = bytes.data() + header.e_shoff + i * sizeof(ElfW(Shdr));
    ElfW(Shdr) section;
    std::memcpy(&section, place, sizeof section);
    if (section.sh_type != SHT_DYNSYM) continue;
    section.sh_size = std::uint64_t{1} << 62;
    std::memcpy(place, &section, sizeof section);
  }
  const test::Folder folder;
  const fs::path file = folder.write("garbled.so", bytes);
  EXPECT_EQ(PluginRegistry({file.parent_path()}).find("garbled").error,
            file.string() +
                " is not a shared library; rebuild it with "
                "delos_add_device() or remove it");
}

TEST(BadPlugin, Unreadable) {
  EXPECT_EQ(
      error_of("dangling"),
      "cannot be read (No such file or directory); check that it exists and may be "
      "read");
}

TEST(BadPlugin, UnresolvedSymbol) {
  const std::string error = error_of("unresolved");
  const std::string library = (kFolder / "unresolved.so").string();
  EXPECT_EQ(error, "cannot be opened (" + library +
                       ": undefined symbol: delos_test_no_such_function); rebuild it "
                       "against this kernel, or install what it needs");
}

TEST(BadPlugin, SaysNothingOfItself) {
  EXPECT_EQ(error_of("no_info"),
            "says nothing of itself; end its source with DELOS_DEVICE_PLUGIN");
}

TEST(BadPlugin, WrongId) {
  EXPECT_EQ(
      error_of("wrong_id"),
      "calls itself 'another'; name the file another.so or the plugin 'wrong_id'");
}

TEST(BadPlugin, ThrowsInCreate) {
  PluginRegistry plugins({kFolder});
  const PluginLoad& load = plugins.find("throws_in_create");
  ASSERT_TRUE(load.info) << load.error;
  try {
    (void)make_device(*load.info, {});
    FAIL() << "made a device";
  } catch (const Unbuildable& e) {
    EXPECT_STREQ(e.what(), "scale clashes with itself");
  }
}

TEST(PluginRegistry, NotFoundNamesTheFoldersAndTheNearestId) {
  PluginRegistry plugins({"/no/such/folder", kFolder});
  const std::string start =
      "' in /no/such/folder (no such folder), " + kFolder.string() + "; ";
  EXPECT_EQ(plugins.find("goood").error,
            "there is no plugin 'goood" + start + "did you mean 'good'?");
  EXPECT_EQ(plugins.find("barometer").error,
            "there is no plugin 'barometer" + start +
                "put its library there, or its folder into DELOS_PLUGIN_PATH");
  EXPECT_EQ(plugins.find("barometer").path, "");
}

TEST(PluginRegistry, AnIdIsNoPath) {
  PluginRegistry plugins({kFolder / "folder"});
  fs::create_directories(kFolder / "folder");
  EXPECT_EQ(plugins.find("../good").info, nullptr);
  EXPECT_EQ(plugins.find("../good").path, "");
  EXPECT_EQ(plugins.find("").info, nullptr);
}

TEST(PluginRegistry, BadOnesDontDisturbTheOthers) {
  PluginRegistry plugins({kFolder});
  std::vector<std::string> ids, usable;
  for (const PluginLoad& load : plugins.all()) {
    ids.push_back(load.path.stem());
    EXPECT_EQ(load.info == nullptr, !load.error.empty());
    if (load.info) usable.push_back(load.info->id);
  }
  EXPECT_EQ(ids, plugins.ids());
  EXPECT_TRUE(std::is_sorted(ids.begin(), ids.end()));
  EXPECT_EQ(usable, (std::vector<std::string>{"good", "stripped", "throws_in_create"}));
}

TEST(PluginRegistry, TakesTheFirstFolderThatHasIt) {
  const test::Folder first;
  first.write("good.so", "A broken one hides the good one behind it.\n");
  fs::create_directories(first / "folder.so");
  first.write("notes.txt", "Not a plugin.\n");
  PluginRegistry plugins({first.path(), kFolder});
  EXPECT_EQ(plugins.find("good").path, first / "good.so");
  EXPECT_EQ(plugins.find("stripped").path, kFolder / "stripped.so");
  EXPECT_EQ(PluginRegistry({first.path()}).ids(), std::vector<std::string>{"good"});
}

TEST(PluginFolders, ExtraThenEnvironmentThenBesideTheKernel) {
  setenv("DELOS_PLUGIN_PATH", "/one:/two::/three", 1);
  const std::vector<fs::path> folders = plugin_folders({"/extra"});
  unsetenv("DELOS_PLUGIN_PATH");
  ASSERT_EQ(folders.size(), 5u);
  EXPECT_EQ(std::vector<fs::path>(folders.begin(), folders.end() - 1),
            (std::vector<fs::path>{"/extra", "/one", "/two", "/three"}));
  EXPECT_EQ(folders.back().filename(), "delos");
  EXPECT_TRUE(fs::exists(folders.back().parent_path() / "libdelos_kernel.so"));
  EXPECT_EQ(plugin_folders(), std::vector<fs::path>{folders.back()});
}

TEST(Stamp, NamesTheFirstFieldThatDiffers) {
  EXPECT_EQ(stamp_difference(this_abi()), "");
  const auto differing = [](std::uint32_t AbiStamp::*field, std::uint32_t value) {
    AbiStamp stamp = this_abi();
    stamp.*field = value;
    return stamp_difference(stamp);
  };
  const auto now = [](std::uint32_t value) { return std::to_string(value); };
  const AbiStamp kernel = this_abi();
  EXPECT_EQ(differing(&AbiStamp::cxx_abi, 1002),
            "was built with another C++ ABI (__GXX_ABI_VERSION 1002, the kernel has " +
                now(kernel.cxx_abi) + "); rebuild it with the kernel's compiler");
  EXPECT_EQ(differing(&AbiStamp::libstdcxx, 7),
            "was built with another libstdc++ mode (_GLIBCXX_USE_CXX11_ABI + 2 "
            "_GLIBCXX_DEBUG 7, the kernel has " +
                now(kernel.libstdcxx) +
                "); rebuild it with the kernel's -D_GLIBCXX flags");
  EXPECT_EQ(differing(&AbiStamp::eigen, 30309),
            "was built with another Eigen (version 30309, the kernel has " +
                now(kernel.eigen) + "); rebuild it with that Eigen");
  EXPECT_EQ(differing(&AbiStamp::eigen_align, 0),
            "was built with other -m flags (EIGEN_MAX_ALIGN_BYTES 0, the kernel has " +
                now(kernel.eigen_align) +
                "); rebuild it with the kernel's -march/-mavx");
  EXPECT_EQ(differing(&AbiStamp::target, 1),
            "was built with another Target (sizeof(Target) 1, the kernel has " +
                now(sizeof(Target)) +
                "); rebuild it with the kernel's headers and flags");
  EXPECT_EQ(
      differing(&AbiStamp::observation, 1),
      "was built with another Observation (sizeof(Observation) 1, the kernel has " +
          now(sizeof(Observation)) +
          "); rebuild it with the kernel's headers and flags");
  EXPECT_EQ(differing(&AbiStamp::param_spec, 1),
            "was built with another ParamSpec (sizeof(ParamSpec) 1, the kernel has " +
                now(sizeof(ParamSpec)) +
                "); rebuild it with the kernel's headers and flags");

  // What answers for many points, beacons and searches are passed in.
  const std::pair<std::uint32_t AbiStamp::*, std::string> kShapes[] = {
      {&AbiStamp::point_lanes, "PointLanes"},   {&AbiStamp::row_lanes, "RowLanes"},
      {&AbiStamp::beacon_lanes, "BeaconLanes"}, {&AbiStamp::smooth_rows, "SmoothRows"},
      {&AbiStamp::view_cone, "ViewCone"},       {&AbiStamp::own_state, "OwnState"}};
  for (const auto& [field, type] : kShapes) {
    EXPECT_EQ(differing(field, 1),
              "was built with another " + type + " (sizeof(" + type +
                  ") 1, the kernel has " + now(kernel.*field) +
                  "); rebuild it with the kernel's headers and flags");
  }
  EXPECT_EQ(differing(&AbiStamp::lanes, 32),
            "was built with another number of lanes (kLanes 32, the kernel has 64); "
            "rebuild it with the kernel's headers");

  AbiStamp both = this_abi();
  both.epoch += 1;
  both.eigen_align += 16;
  EXPECT_NE(stamp_difference(both).find("kAbiEpoch"), std::string::npos);
}

class Blind final : public Device {
 public:
  bool observe(const Target&, Observation&) const override { return false; }
};

int destroyed = 0;

TEST(MakeDevice, EndsADeviceWhereItWasMade) {
  PluginInfo info{};
  info.id = "blind";
  info.create = [](const ParamValues&) -> Device* { return new Blind; };
  info.destroy = [](Device* device) {
    ++destroyed;
    delete device;
  };
  { const auto device = make_device(info, {}); }
  EXPECT_EQ(destroyed, 1);
}

TEST(MakeDevice, RefusesNoDevice) {
  PluginInfo info{};
  info.id = "blind";
  info.create = [](const ParamValues&) -> Device* { return nullptr; };
  try {
    (void)make_device(info, {});
    FAIL() << "made a device";
  } catch (const Unbuildable& e) {
    EXPECT_STREQ(e.what(), "plugin 'blind' created no device");
  }
}

}  // namespace
}  // namespace delos
