// Five hundred changes of all kinds, back and forth, and the same journal in a study.
#include <algorithm>
#include <random>

#include "designs.h"
#include "session/more_devices.h"
#include "session/placing.h"
#include "study/journal.h"

namespace delos::session {
namespace {

/// Draws changes of a scene: numbers by path, places by hand, devices more and fewer.
class Hand {
 public:
  explicit Hand(unsigned seed) : random_(seed) {}

  std::vector<Override> next(const LoadedScene& loaded) {
    const Scene& scene = loaded.scene;
    const std::string& device = scene.devices[upto(scene.devices.size())].name;
    switch (upto(7)) {
      case 0:
        return {{"devices." + device + ".at." + "xyz"[upto(3)], text(-1, 2)}};
      case 1:
        return {{"devices." + device + ".params.r", text(0.001, 0.01)}};
      case 2:
        return {{"devices." + device + ".rate", text(20, 100)},
                {"sample.volume.step", text(0.04, 0.2)}};
      case 3:
        return first_of(copying(loaded, device, {number(0.1, 0.5), 0, 0}));
      case 4:
        return first_of(mirroring(loaded, device, static_cast<int>(upto(3))));
      case 5:
        return first_of(removing(loaded, device));
      default: {
        auto put = placing(scene, device,
                           Eigen::Vector3d(number(0, 1), number(0, 1), number(1, 2)),
                           std::nullopt);
        return std::get<0>(std::move(put));
      }
    }
  }
  std::size_t upto(std::size_t n) { return random_() % n; }

 private:
  static std::vector<Override> first_of(const Ways& ways) {
    const auto* list = std::get_if<0>(&ways);
    return list ? list->front() : std::vector<Override>{};
  }
  double number(double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(random_);
  }
  std::string text(double least, double most) {
    return std::to_string(number(least, most));
  }

  std::mt19937 random_;
};

TEST(Edits, GoBackAndForthAndIntoAStudy) {
  Design design = design_of("10-better-speakers");
  Hand hand(11);
  // What the design must be after so many steps that aren't undone.
  std::vector<std::string> texts = {design.text()};
  std::size_t at = 0, refused = 0;
  for (int edit = 0; edit < 500; ++edit) {
    if (hand.upto(5) == 0 && at > 0) {
      ASSERT_TRUE(design.undo(plugins()));
      --at;
    } else if (hand.upto(8) == 0 && at + 1 < texts.size()) {
      ASSERT_TRUE(design.redo(plugins()));
      ++at;
    } else {
      Diagnostics findings;
      auto changes = hand.next(design.loaded());
      if (changes.empty() ||
          !design.change(std::move(changes), "", plugins(), findings)) {
        ++refused;  // such as a device that a variable names: all stays
      } else {
        texts.resize(++at);
        texts.push_back(design.text());
      }
    }
    ASSERT_TRUE(design.text() == texts[at]) << edit;
  }
  EXPECT_LT(refused, 250u);
  ASSERT_GT(at, 100u);
  for (std::size_t i = at; i-- > 0;) {
    ASSERT_TRUE(design.undo(plugins()));
    ASSERT_TRUE(design.text() == texts[i]) << i;
  }
  for (std::size_t i = 1; i <= at; ++i) ASSERT_TRUE(design.redo(plugins()));

  // By the acts of a study's journal, each on its own.
  Journal journal(DELOS_SCENES, plugins());
  journal.arrive({design_of("10-better-speakers").loaded().scene, {}, 0});
  for (const Override& change : design.history().changes())
    journal.act({0, 0, "set", change.path + "=" + change.value});
  EXPECT_TRUE(journal.position().scene == design.loaded().scene);
}

/// One speaker of a pair that the scene mirrors, by hand and by a search alike.
TEST(Edits, MoveWhatFollows) {
  Design design = design_of("10-better-speakers");
  change(design, {{"devices.s1.at.x", "-0.1"}});
  const auto& devices = design.loaded().scene.devices;
  EXPECT_EQ(devices[3].placement.at.x(), 2 * 0.2 + 0.1);
  EXPECT_EQ(design.history().undoable(), 1u);
  design.undo(plugins());
  EXPECT_EQ(design.loaded().scene.devices[3].placement.at.x(), 0.4);
}

}  // namespace
}  // namespace delos::session
