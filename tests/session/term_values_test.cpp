// Terms of a weighted objective, one by one: they add up to it.
#include "session/term_values.h"

#include "delos/optimize/problem.h"
#include "designs.h"

namespace delos::session {
namespace {

TEST(TermValues, AddUpToTheObjective) {
  Design design = design_of("10-better-speakers");
  change(design,
         {{"objective",
           "{terms: [{minimize: mean, weight: 2}, {minimize: percentile, level: "
           "0.9, weight: 0.5}, {minimize: maximum, weight: 3}]}"}});
  const Scene& scene = design.loaded().scene;
  VariableValues first = values_of(scene, plugins()), second = first;
  second.values[0] += 0.05;
  second.values[2] -= 0.03;
  const Json json = term_values(scene, {first, second}, 300, 1, nullptr, plugins());
  ASSERT_EQ(json["terms"].size(), 3u);
  for (const Json& term : json["terms"]) EXPECT_EQ(term["unit"], "m");
  EXPECT_EQ(json["values"].size(), 2u);

  Problem whole(scene, plugins(), {.samples = 300, .threads = 1});
  std::size_t i = 0;
  for (const VariableValues& values : {first, second}) {
    const Json& terms = json["values"][i++];
    const double sum = 2 * terms[0].get<double>() + 0.5 * terms[1].get<double>() +
                       3 * terms[2].get<double>();
    const std::vector<double> x =
        ::delos::Design(with_values(scene, values, plugins()), plugins()).start();
    EXPECT_NEAR(sum, whole.score(x).objective, 1e-12 * std::abs(sum));
    EXPECT_LT(terms[0], terms[1]) << "the mean is below the worst tenth";
    EXPECT_LT(terms[1], terms[2]);
  }
  EXPECT_NE(json["values"][0], json["values"][1]);
}

/// An objective that isn't given has one term.
TEST(TermValues, OfWhatIsntGiven) {
  Design design = design_of("10-better-speakers");
  change(design, {{"-", "objective"}});
  const Scene& scene = design.loaded().scene;
  const Json json =
      term_values(scene, {values_of(scene, plugins())}, 300, 1, nullptr, plugins());
  ASSERT_EQ(json["terms"].size(), 1u);
  EXPECT_EQ(json["terms"][0]["name"], "mean " + scene.metric);
}

}  // namespace
}  // namespace delos::session
