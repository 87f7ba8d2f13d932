// What a search may take for a bad design, and what it may not.
#include <gtest/gtest.h>

#include <cmath>
#include <new>
#include <vector>

#include "delos/device/faults.h"
#include "delos/optimize/problem.h"
#include "delos/scene/io.h"

namespace delos {
namespace {

PluginRegistry& faulty_plugins() {
  static PluginRegistry registry({DELOS_FAULTY_PLUGINS});
  return registry;
}

/// Four ranges, one of which can't be made where its knob is turned past the middle.
Scene room(const std::string& params) {
  std::string text = R"(delos: 1
motion: {type: position_velocity, q: [0.4, 0.4, 0.4]}
sample: {points: [[1, 1, 1], [2, 1, 2]]}
variables: [{path: devices.s1.params.knob, lower: 0, upper: 2}]
devices:
  - {name: s1, type: faulty, rate: 10 Hz, at: [2, 2, 3], params: {)" +
                     params + "}}\n";
  for (const char* at : {"[0, 0, 0]", "[4, 0, 1]", "[0, 4, 2]"})
    text += std::string("  - {name: a") + at[1] + at[4] + at[7] +
            ", type: faulty, rate: 10 Hz, at: " + at + "}\n";
  Diagnostics diagnostics;
  auto scene = parse_scene(text, "room.yaml", {}, faulty_plugins(), diagnostics);
  for (const Diagnostic& d : diagnostics) ADD_FAILURE() << to_string(d);
  return scene.value();
}

const std::vector<double> kSound = {0.2}, kClashing = {0.7};

TEST(Unbuildable, DesignsAreAsBadAsCanBe) {
  for (const char* create : {"throws", "silent", "number"}) {
    Problem problem(room(std::string("create: ") + create), faulty_plugins(), {});
    EXPECT_TRUE(std::isfinite(problem.score(kSound).objective));
    EXPECT_EQ(problem.score(kClashing).objective, INFINITY) << create;
    EXPECT_TRUE(std::isfinite(problem.soft_score(kSound, 0.1).objective));
    EXPECT_EQ(problem.soft_score(kClashing, 0.1).objective, INFINITY) << create;
  }
}

TEST(Unbuildable, LackOfMemoryIsNoDesign) {
  Problem problem(room("create: memory"), faulty_plugins(), {});
  EXPECT_THROW((void)problem.score(kClashing), std::bad_alloc);
  EXPECT_THROW((void)problem.soft_score(kClashing, 0.1), std::bad_alloc);
}

TEST(Unbuildable, AMisbehavingDeviceIsNoDesign) {
  const std::string name = "s1 (faulty): its plugin ";
  const auto fault_of = [](auto&& body) -> std::string {
    try {
      body();
    } catch (const DeviceFault& fault) {
      return fault.what();
    }
    return "";
  };
  EXPECT_EQ(fault_of([] {
              Problem problem(room("answer: throws"), faulty_plugins(), {});
              (void)problem.score(kSound);
            }),
            name + "fails: the lens is dirty");
  const auto smoothly = [&](const std::string& answer) {
    return fault_of([&] {
      Problem problem(room("entry: smooth, answer: " + answer), faulty_plugins(), {});
      (void)problem.soft_score(kSound, 0.1);
    });
  };
  EXPECT_EQ(smoothly("throws"), name + "fails: the lens is dirty");
  EXPECT_EQ(smoothly("rows"), name + "answers smoothly with 4 rows, not 0 to 3");
  EXPECT_EQ(smoothly("nan"),
            name + "answers smoothly with a variance that isn't finite and above 0");
  EXPECT_EQ(smoothly("wild_H"), name + "answers smoothly with an H that isn't finite");
}

}  // namespace
}  // namespace delos
