// Motions by name, in words, and several of them.
#include "delos/model/motion_words.h"

#include <set>

#include "scene/load.h"

namespace delos::test {
namespace {

Eigen::VectorXd diagonal_q(const Scene& scene) {
  return std::get<ChainMotion>(scene.motion.dynamics).q.diagonal();
}

Loaded moving(const std::string& motion, const std::string& more = "") {
  return load(good_with(
      "motion:\n  type: position_velocity\n  state: position\n  q: [0.4, 0.4, 0.1]\n",
      "motion: " + motion + "\n" + more));
}

/// A velocity that forgets itself with a time constant T has the spectral density
/// 2 σ²/T of what drives it; its variance is σ², and of speed v is v²/2 along each of
/// two axes, v²/3 along each of three.
TEST(MotionWords, GiveQ) {
  EXPECT_TRUE(
      q_of({1.5, 0.5, 0.2}, 2)
          .isApprox(Eigen::Vector3d(2 * 1.125 / 0.5, 2 * 1.125 / 0.5, 2 * 0.04 / 0.5)));
  EXPECT_TRUE(q_of({1.5, 0.5}, 2).isApprox(Eigen::Vector3d::Constant(2 * 0.75 / 0.5)));
  EXPECT_TRUE(q_of({6, 0.1}, 3).isApprox(Eigen::Vector3d::Constant(2 * 12 / 0.1)));
  EXPECT_TRUE(q_of({3, 2}, 1).isApprox(Eigen::Vector3d::Constant(2 * 3 * 2)));
}

TEST(MotionWords, StandInAScene) {
  const Loaded spoken = moving(
      "{type: position_velocity, speed: 150 cm/s, vertical: 0.2, changes_within: "
      "500 ms}");
  ASSERT_TRUE(spoken.scene) << spoken.findings.at(0);
  EXPECT_TRUE(diagonal_q(*spoken.scene).isApprox(Eigen::Vector3d(4.5, 4.5, 0.16)));
  const Loaded accelerated = moving(
      "{type: position_velocity_acceleration, acceleration: 6, changes_within: 0.1}");
  ASSERT_TRUE(accelerated.scene) << accelerated.findings.at(0);
  EXPECT_EQ(accelerated.scene->motion.layout.order, 3);
  EXPECT_TRUE(diagonal_q(*accelerated.scene).isApprox(Eigen::Vector3d::Constant(240)));
}

TEST(MotionWords, AreRefusedWithASentence) {
  const auto says = [](const std::string& motion, const std::string& part) {
    const Loaded loaded = moving(motion);
    EXPECT_FALSE(loaded.scene) << motion;
    ASSERT_FALSE(loaded.findings.empty()) << motion;
    std::string all;
    for (const std::string& finding : loaded.findings) all += finding + "\n";
    EXPECT_NE(all.find(part), std::string::npos) << all;
  };
  says("{type: position_velocity, speed: 1}", "motion.changes_within: missing");
  says("{type: position_velocity, changes_within: 1}", "motion.speed: missing");
  says("{type: position_velocity, speed: 1, changes_within: 1, q: [1, 1, 1]}",
       "motion.q: stands beside words");
  says("{type: position_velocity, acceleration: 1, changes_within: 1}",
       "motion.acceleration: this type is described by speed");
  says("{type: position_velocity, speed: -1, changes_within: 1}",
       "motion.speed: must be above 0");
  says("{type: position_velocity, state: pose, speed: 1, changes_within: 1}",
       "motion.state: words say nothing of how the target turns");
  says("{type: custom, speed: 1, changes_within: 1}", "motion.type: words such as");
  says("{named: wlak}", "motion.named: ");
  says("{named: walk, q: [1, 1, 1]}", "motion.q: a named motion says all");
}

TEST(NamedMotions, HaveDifferentNamesAndPositiveQ) {
  std::set<std::string> names;
  for (const NamedMotion& motion : named_motions()) {
    EXPECT_TRUE(names.insert(motion.name).second) << motion.name;
    EXPECT_GT(motion.q.minCoeff(), 0) << motion.name;
    EXPECT_GT(std::string(motion.source).size(), 10u) << motion.name;
    EXPECT_EQ(std::string(motion.source).find("assumed") != std::string::npos,
              motion.assumed)
        << motion.name;
    const Loaded loaded = moving("{named: " + std::string(motion.name) + "}");
    ASSERT_TRUE(loaded.scene) << loaded.findings.at(0);
    EXPECT_EQ(loaded.scene->motion.layout.order, motion.order);
    EXPECT_TRUE(diagonal_q(*loaded.scene) == motion.q);
  }
  // Allen (2007), Eq. 57.
  EXPECT_NEAR(named_motion("hiball_head")->q.z(), 0.0815344167 * 0.0815344167, 1e-15);
  EXPECT_EQ(named_motion("nobody"), nullptr);
}

TEST(SeveralMotions, AreWrittenAsTheyWereRead) {
  const Loaded loaded =
      moving("{named: walk}",
             "motions: {still: {named: still}, punch: {type: "
             "position_velocity_acceleration, q: [900, 900, 100]}}\n");
  ASSERT_TRUE(loaded.scene) << loaded.findings.at(0);
  ASSERT_EQ(loaded.scene->motions.size(), 2u);
  EXPECT_EQ(loaded.scene->motions[1].name, "punch");
  const Loaded again = load(write_scene(*loaded.scene));
  ASSERT_TRUE(again.scene) << again.findings.at(0);
  EXPECT_TRUE(*again.scene == *loaded.scene);
}

TEST(SeveralMotions, TakeThePlaceOfTheScenes) {
  const std::string motions =
      "motions: {punch: {type: position_velocity_acceleration, q: [900, 900, 100]}}\n";
  const Loaded loaded = moving("{named: walk}", motions);
  ASSERT_TRUE(loaded.scene);
  const Override change = motion_override(loaded.scene->motions[0]);
  const Loaded changed = load(
      good_with("motion:\n  type: position_velocity\n  state: position\n  q: [0.4, "
                "0.4, 0.1]\n",
                "motion: {named: walk}\n" + motions),
      {change});
  ASSERT_TRUE(changed.scene) << changed.findings.at(0);
  EXPECT_TRUE(changed.scene->motion == loaded.scene->motions[0].motion);
}

TEST(SeveralMotions, AreRefusedWithASentence) {
  const auto first = [](const std::string& motions) {
    const Loaded loaded = moving("{named: walk}", "motions: " + motions + "\n");
    EXPECT_FALSE(loaded.scene) << motions;
    return loaded.findings.empty() ? std::string() : loaded.findings[0];
  };
  EXPECT_NE(first("[1, 2]").find("a mapping of names to motions"), std::string::npos);
  EXPECT_NE(first("{all: {named: walk}}").find("'all' means all"), std::string::npos);
  EXPECT_NE(first("{a: {type: position}}").find("motions.a.q: missing"),
            std::string::npos);
}

}  // namespace
}  // namespace delos::test
