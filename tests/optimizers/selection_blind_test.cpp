// Blind samples, and the guess that judges them and nothing else.
#include <gtest/gtest.h>

#include <cmath>

#include "delos/optimize/choices.h"
#include "optimizers/scenes.h"
#include "selection/question.h"
#include "selection/seeing.h"

namespace delos::test {
namespace {

SelectResult selected(const std::string& text) {
  SelectOptions options;
  options.gap = 0;
  options.threads = 1;
  return select(parse(text), plugins(), options);
}

std::vector<std::string> names_of_chosen(const SelectResult& result) {
  std::vector<std::string> names;
  for (const std::size_t i : result.chosen)
    names.push_back(result.all.candidates[i].name);
  return names;
}

using Names = std::vector<std::string>;

// With readings that nearly measure one combination without noise, a guess of a hundred
// times what they tell would still know everything. Expected: SciPy, solve_discrete_are
// for each of the three choices.
TEST(BlindSamples, LendTheirGuessToNoOther) {
  for (const auto& [R, least] : {std::pair{"1e-4", 4.082236}, {"1e-6", 3.053065}}) {
    const SelectResult result = selected(R"(delos: 1
motion: {type: custom, A: [[0.8, 0, 0], [0, 0, 0], [0, 0, 0]], Q: [[1, 0, 0], [0, 1, 0], [0, 0, 1]]}
sample: {points: [[0, 0, 0]]}
devices:
  - {name: s1, type: linear, rate: 1 Hz, params: {H: [[1, 300, 300]], R: &r [[)" +
                                         std::string(R) + R"(]]}}
  - {name: s2, type: linear, rate: 1 Hz, params: {H: [[1, 0, 300]], R: *r}}
  - {name: s3, type: linear, rate: 1 Hz, params: {H: [[0, 1, 1]], R: *r}}
objective: {minimize: mean, of: trace}
selection: {count: 2, candidates: [{devices: [s1, s2, s3]}]}
)");
    EXPECT_EQ(names_of_chosen(result), (Names{"s1", "s3"}));
    EXPECT_NEAR(result.value, least, 1e-6);
    EXPECT_NEAR(result.lower_bound, least, 1e-6);
    EXPECT_EQ(result.blind, 0U);
  }
}

// The time that a search may take is over before anything is found: it is given up at
// once, however many choices are left.
TEST(BlindSamples, AreJudgedWithinTheTimeThatIsLeft) {
  std::string text = kOneTarget + "devices:\n";
  for (int i = 0; i < 8; ++i)
    text += "  - {name: a" + std::to_string(i) +
            ", type: uwb_range, rate: 50 Hz, at: [" + std::to_string(std::cos(i)) +
            ", " + std::to_string(std::sin(i)) + ", " + std::to_string(0.3 * i) +
            "]}\n";
  text +=
      "objective: {minimize: mean, of: trace}\n"
      "selection: {count: 4, candidates: [{devices: \"*\"}]}\n";
  const Question q = question_of(parse(text), plugins(), {});
  const auto cost = cost_of(q, 1);
  cost->guess_the_always_blind(std::vector<char>(8, 1));
  int asked = 0;
  const auto stop_after = [&](int most) {
    return [&asked, most] { return ++asked > most; };
  };
  EXPECT_TRUE(seeing_choice(*cost, q.rules, q.decisions, stop_after(1000)));
  EXPECT_GT(asked, 2);  // a step for each device of the choice
  asked = 0;
  EXPECT_FALSE(seeing_choice(*cost, q.rules, q.decisions, stop_after(2)));
  EXPECT_LE(asked, 6);  // once more for each step on the way back
  EXPECT_TRUE(judge_blind_samples(*cost, q.rules, q.decisions, stop_after(0)).empty());
}

/// Three random walks of unit steps, and what may be chosen of some sensors.
std::string walks(const std::string& sensors, const std::string& objective, int count) {
  return R"(delos: 1
motion: {type: custom, A: [[1, 0, 0], [0, 1, 0], [0, 0, 1]], Q: [[1, 0, 0], [0, 1, 0], [0, 0, 1]]}
sample: {points: [[0, 0, 0]]}
devices:
)" + sensors +
         "objective: " + objective + "\nselection: {count: " + std::to_string(count) +
         ", candidates: [{devices: \"*\"}]}\n";
}

/// P of one walk that is read with variance r: P² = P + r.
double walk(double r) { return (1 + std::sqrt(1 + 4 * r)) / 2; }

const std::string kAll =
    "  - {name: all, type: linear, rate: 1 Hz, params: {H: [[1, 0, 0], [0, 1, 0], "
    "[0, 0, 1]], R: [[100, 0, 0], [0, 100, 0], [0, 0, 100]]}}\n";
const std::string kPlane =
    "  - {name: plane, type: linear, rate: 1 Hz, params: {H: [[1, 0, 0], [0, 1, 0]], "
    "R: [[1e-8, 0], [0, 1e-8]]}}\n";
const std::string kPoorPlane =
    "  - {name: poor, type: linear, rate: 1 Hz, params: {H: [[1, 0, 0], [0, 1, 0]], "
    "R: [[1, 0], [0, 1]]}}\n";
const std::string kAxes =
    "  - {name: x, type: linear, rate: 1 Hz, params: {H: [[1, 0, 0]], R: [[1]]}}\n"
    "  - {name: y, type: linear, rate: 1 Hz, params: {H: [[0, 1, 0]], R: [[0.25]]}}\n"
    "  - {name: z, type: linear, rate: 1 Hz, params: {H: [[0, 0, 1]], R: [[4]]}}\n";

// By the guess, which knows z to a millimetre, the plane costs a tenth.
TEST(BlindSamples, AreChosenOnlyWhereNothingSees) {
  const SelectResult result =
      selected(walks(kPlane + kAll, "{minimize: mean, of: trace, guess: 1 mm}", 1));
  EXPECT_EQ(names_of_chosen(result), (Names{"all"}));
  EXPECT_NEAR(result.value, 3 * walk(100), 1e-9);
  EXPECT_LE(result.lower_bound, result.value * (1 + 1e-12));
  EXPECT_EQ(result.blind, 0U);
  EXPECT_EQ(result.always_blind, 0U);
}

TEST(BlindSamples, AreJudgedByTheGuessWhateverIsChosen) {
  const SelectResult result = selected(
      walks(kPoorPlane + kPlane, "{minimize: mean, of: trace, guess: 2 m}", 1));
  EXPECT_EQ(names_of_chosen(result), (Names{"plane"}));
  EXPECT_NEAR(result.value, 2 * walk(1 / (1e8 + 0.25)) + walk(4), 1e-7);
  EXPECT_NEAR(result.lower_bound, result.value, 1e-6 * result.value);
  EXPECT_EQ(result.blind, 1U);
  EXPECT_EQ(result.always_blind, 1U);
}

TEST(BlindSamples, AreJudgedByTheGuessWhereNoChoiceSeesThem) {
  const SelectResult result =
      selected(walks(kAxes, "{minimize: mean, of: trace, guess: 2 m}", 1));
  EXPECT_EQ(names_of_chosen(result), (Names{"y"}));
  EXPECT_NEAR(result.value, walk(1 / 4.25) + 2 * walk(4), 1e-7);
  EXPECT_NEAR(result.lower_bound, result.value, 1e-6 * result.value);
  EXPECT_EQ(result.blind, 1U);
  EXPECT_EQ(result.always_blind, 0U);
}

// A field calls blind what its metric reads, no more.
TEST(BlindSamples, AreThoseOfTheMetric) {
  const SelectResult result =
      selected(walks(kAxes, "{minimize: mean, of: sigma_y, guess: 1 mm}", 1));
  EXPECT_EQ(names_of_chosen(result), (Names{"y"}));
  EXPECT_NEAR(result.value, std::sqrt(walk(0.25)), 1e-9);
  EXPECT_LE(result.lower_bound, result.value * (1 + 1e-12));
  EXPECT_EQ(result.blind, 0U);
}

// Two of three axes gone, as the counts have it and as the removals.
TEST(BlindSamples, AreCountedInCurvesAndRemovals) {
  const Scene scene = parse(walks(kAxes, "{minimize: mean, of: trace, guess: 2 m}", 1));
  SelectOptions options;
  options.gap = 0;
  options.threads = 1;
  const CountCurve curve = count_curve(scene, plugins(), options, 1, 3);
  ASSERT_EQ(curve.points.size(), 3U);
  EXPECT_EQ(curve.points[0].blind, 1U);
  EXPECT_EQ(curve.points[2].blind, 0U);
  EXPECT_NEAR(curve.points[0].value, walk(1 / 4.25) + 2 * walk(4), 1e-7);
  EXPECT_NEAR(curve.points[2].value, walk(1) + walk(0.25) + walk(4), 1e-7);
  EXPECT_EQ(curve.guess, 2);
  const RemovalOrder order = removal_order(scene, plugins(), options);
  ASSERT_EQ(order.removals.size(), 2U);
  EXPECT_NEAR(order.all_chosen, walk(1) + walk(0.25) + walk(4), 1e-7);
  EXPECT_EQ(order.removals[1].blind, 1U);
  EXPECT_LE(order.removals[1].lower_bound, order.removals[1].value);
}

TEST(BlindSamples, AreBlindInTheEnvelope) {
  SelectOptions options;
  options.threads = 1;
  const Field blind = selection_envelope(
      parse(walks(kAxes, "{minimize: mean, of: trace}", 2)), plugins(), options);
  EXPECT_TRUE(std::isinf(blind.value[0]));
  EXPECT_FALSE(blind.observable[0]);
  const Field seen = selection_envelope(
      parse(walks(kAxes, "{minimize: mean, of: trace}", 3)), plugins(), options);
  EXPECT_NEAR(seen.value[0], walk(1) + walk(0.25) + walk(4), 1e-2);
  EXPECT_TRUE(seen.observable[0]);
}

TEST(Selections, SayThatEverythingIsLeftOut) {
  Scene scene = parse(walks(kAxes, "{minimize: mean, of: trace}", 1));
  scene.selection.leave_out = {"x", "y", "z"};
  try {
    (void)select(scene, plugins(), {});
    ADD_FAILURE() << "isn't refused";
  } catch (const std::invalid_argument& refusal) {
    EXPECT_STREQ(refusal.what(),
                 "selection.leave_out names every candidate, so that none can be "
                 "chosen");
  }
}

}  // namespace
}  // namespace delos::test
