// delos new-device: what it writes, and what it refuses. tests/plugin builds it.
#include <gtest/gtest.h>

#include "program.h"

namespace delos::test {
namespace {

TEST(NewDeviceCommand, WritesAProjectOfThatName) {
  const Folder folder;
  const Finished done = run({"new-device", "my_sensor", "mine"}, folder.path());
  EXPECT_EQ(done.code, 0) << done.err;
  const auto mine = folder.path() / "mine";
  EXPECT_NE(read_file(mine / "my_sensor.cpp")
                .find("DELOS_DEVICE_PLUGIN(MySensor, \"my_sensor\""),
            std::string::npos);
  for (const char* name :
       {"my_sensor.cpp", "CMakeLists.txt", "example.yaml", "scene.yaml", "README.md"}) {
    const std::string text = read_file(mine / name);
    EXPECT_NE(text, "") << name;
    EXPECT_EQ(text.find('@'), std::string::npos) << name;
    EXPECT_NE(done.out.find(std::string("mine/") + name + "\n"), std::string::npos);
  }
}

TEST(NewDeviceCommand, OverwritesNothing) {
  const Folder folder;
  ASSERT_EQ(run({"new-device", "my_sensor", "mine"}, folder.path()).code, 0);
  const Finished again = run({"new-device", "other", "mine"}, folder.path());
  EXPECT_EQ(again.code, 1);
  EXPECT_EQ(again.err,
            "delos: mine/CMakeLists.txt is there already; nothing was written\n");
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "mine/other.cpp"));
}

TEST(NewDeviceCommand, RefusesWhatIsNoId) {
  const Folder folder;
  for (const char* id : {"My", "9x", "a-b", "../x"}) {
    const Finished done = run({"new-device", id, "mine"}, folder.path());
    EXPECT_EQ(done.code, 1) << id;
    EXPECT_EQ(done.err, "delos: '" + std::string(id) +
                            "' isn't an id: small letters, digits and '_', a letter "
                            "first, such as my_sensor\n");
  }
  EXPECT_EQ(
      run({"new-device", "range", "mine"}, folder.path()).err,
      "delos: there is a device 'range' already; 'delos devices range' shows it\n");
}

}  // namespace
}  // namespace delos::test
