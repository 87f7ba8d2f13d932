// Steps back and forth, and memory that doesn't grow with them.
#include "session/history.h"

#include <gtest/gtest.h>

namespace delos::session {
namespace {

std::string text_of(const History& history) {
  std::string text;
  for (const Override& change : history.changes())
    text += change.path + "=" + change.value + " ";
  return text;
}

TEST(History, JoinsTheChangesOfAGesture) {
  History history;
  history.add({{"a", "1"}}, "drag");
  history.add({{"a", "2"}}, "drag");
  history.add({{"b", "1"}}, "drag");
  history.add({{"a", "3"}}, "drag again");
  EXPECT_EQ(history.undoable(), 2u);
  EXPECT_EQ(text_of(history), "a=2 b=1 a=3 ");
  EXPECT_TRUE(history.undo());
  EXPECT_EQ(text_of(history), "a=2 b=1 ");
  // After going back, the same hand begins anew.
  history.add({{"a", "4"}}, "drag");
  EXPECT_EQ(history.undoable(), 2u);
  EXPECT_EQ(history.redoable(), 0u);
  EXPECT_TRUE(history.undo());
  EXPECT_TRUE(history.undo());
  EXPECT_FALSE(history.undo());
  EXPECT_EQ(text_of(history), "");
  EXPECT_TRUE(history.redo());
  EXPECT_TRUE(history.redo());
  EXPECT_FALSE(history.redo());
  EXPECT_EQ(text_of(history), "a=2 b=1 a=4 ");
}

TEST(History, StaysBoundedOverTenThousandSteps) {
  History history;
  for (int i = 0; i < 10'000; ++i)
    history.add({{"devices.d" + std::to_string(i % 7) + ".rate", std::to_string(i)}},
                "");
  EXPECT_EQ(history.undoable(), History::kMostSteps);
  EXPECT_EQ(history.changes().size(), History::kMostSteps + 7);
  EXPECT_EQ(history.changes().back().value, "9999");
}

/// "a.x" after "a" isn't undone by an older "a.x" that went; "+" adds each time.
TEST(History, KeepsWhatComesAfterAnotherInOrder) {
  History history;
  const auto drag = [&](const std::string& path, const std::string& value) {
    history.add({{path, value}}, "drag");
  };
  drag("a.x", "1");
  drag("a", "[0]");
  drag("a.x", "2");
  drag("ab", "3");
  drag("a.x", "4");
  drag("list.+", "5");
  drag("list.+", "6");
  EXPECT_EQ(text_of(history), "a.x=1 a=[0] ab=3 a.x=4 list.+=5 list.+=6 ");
}

}  // namespace
}  // namespace delos::session
