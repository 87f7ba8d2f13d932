#include "text/nearest.h"

#include <gtest/gtest.h>

namespace delos {
namespace {

TEST(EditDistance, CountsEdits) {
  EXPECT_EQ(edit_distance("", ""), 0u);
  EXPECT_EQ(edit_distance("abc", ""), 3u);
  EXPECT_EQ(edit_distance("", "abc"), 3u);
  EXPECT_EQ(edit_distance("focal", "focal"), 0u);
  EXPECT_EQ(edit_distance("focall", "focal"), 1u);    // insertion
  EXPECT_EQ(edit_distance("fcal", "focal"), 1u);      // deletion
  EXPECT_EQ(edit_distance("fokal", "focal"), 1u);     // replacement
  EXPECT_EQ(edit_distance("foacl", "focal"), 1u);     // swap
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);  // the textbooks' example
}

std::string suggestion(std::string_view word) {
  const std::vector<std::string> known = {"at",    "focal",          "noise", "near",
                                          "pitch", "pinhole_camera", "r",     "rate"};
  return nearest(word, known);
}

TEST(Nearest, FindsWhatWasMeant) {
  EXPECT_EQ(suggestion("focall"), "focal");
  EXPECT_EQ(suggestion("pinhole_camra"), "pinhole_camera");
  EXPECT_EQ(suggestion("pinehole_kamara"), "pinhole_camera");  // three edits in fifteen
  EXPECT_EQ(suggestion("nosie"), "noise");
  EXPECT_EQ(suggestion("raet"), "rate");
}

TEST(Nearest, DoesntGuessWildly) {
  EXPECT_EQ(suggestion("sigma"), "");
  EXPECT_EQ(suggestion("camera"), "");
  EXPECT_EQ(suggestion("q"), "");  // every edit of a letter is another word
  EXPECT_EQ(suggestion(""), "");
  EXPECT_EQ(nearest("focal", {}), "");
}

TEST(Nearest, TakesTheCloserThenTheFirst) {
  const std::vector<std::string> known = {"beacon_b", "beacon_a", "beacons"};
  EXPECT_EQ(nearest("beacon_c", known), "beacon_b");
  EXPECT_EQ(nearest("beacon_a", known), "beacon_a");
}

}  // namespace
}  // namespace delos
