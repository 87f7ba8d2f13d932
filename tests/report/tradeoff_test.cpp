// What delos tradeoff wrote, and nothing else, becomes a part of a report.
#include "report/tradeoff.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace delos::report {
namespace {

using session::Json;

TEST(Tradeoff, RefusesOtherDocuments) {
  EXPECT_THROW((void)tradeoff_json({{"scene", "x"}}), std::invalid_argument);
  EXPECT_THROW((void)tradeoff_json(Json::array()), std::invalid_argument);
}

TEST(Tradeoff, TellsKitsAndTheCheapest) {
  const Json json = tradeoff_json(
      {{"scene", "x"},
       {"objective", {{"name", "mean eigmax"}, {"unit", "m"}}},
       {"points",
        {{{"devices", 3}, {"price", 30}, {"objective", 0.003}, {"kept", false}},
         {{"devices", 4}, {"price", 40}, {"objective", 0.002}, {"kept", true}},
         {{"devices", 5}, {"price", 50}, {"objective", nullptr}, {"kept", false}}}},
       {"cheapest", {{"devices", 4}, {"price", 40}}}});
  EXPECT_EQ(json["across"]["name"], "devices");
  ASSERT_EQ(json["points"].size(), 2u);  // the last one wasn't reached
  EXPECT_EQ(json["points"][1]["used"], 40);
  EXPECT_EQ(json["cheapest"]["devices"], 4);
}

TEST(Tradeoff, TellsTheFrontOfALimit) {
  const Json json = tradeoff_json({{"objective", {{"name", "mean"}, {"unit", "m"}}},
                                   {"limit", {{"constraint", "cost"}, {"unit", "1"}}},
                                   {"points",
                                    {{{"limit", 4},
                                      {"used", 3.5},
                                      {"objective", 0.003},
                                      {"kept", true},
                                      {"dominated", true}}}}});
  EXPECT_EQ(json["of_limit"], true);
  EXPECT_EQ(json["across"]["name"], "cost");
  EXPECT_EQ(json["points"][0]["used"], 3.5);
  EXPECT_EQ(json["points"][0]["dominated"], true);
  EXPECT_TRUE(json["cheapest"].is_null());
}

}  // namespace
}  // namespace delos::report
