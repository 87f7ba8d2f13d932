#include <gtest/gtest.h>

#include <cstdio>
#include <sstream>

#include "output/fields.h"
#include "output/write.h"

namespace delos {
namespace {

Field half_blind() {
  return volume({{0, 0, 0}, {0.1, 0.1, 0.1}, {11, 11, 1}},
                [](const Eigen::Vector3d& p) {
                  return p.x() > 0.55 ? kBlind : 0.05 + 0.1 * p.x();
                });
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// Characters as a terminal counts them: without escape sequences and UTF-8's tails.
std::size_t width(const std::string& line) {
  std::size_t n = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '\x1b')
      i = line.find('m', i);
    else if ((static_cast<unsigned char>(line[i]) & 0xC0) != 0x80)
      ++n;
  }
  return n;
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(TerminalPicture, ShadesFromGoodToBad) {
  const std::string text = terminal_picture(half_blind(), 40, false);
  EXPECT_EQ(text.find('\x1b'), std::string::npos);
  EXPECT_EQ(text.back(), '\n');
  const std::string line = lines_of(text).front();
  EXPECT_EQ(line.front(), '@');  // 50 mm, the best
  EXPECT_TRUE(has(line, ":·"));  // 100 mm, the worst, beside the blind
  EXPECT_EQ(line.substr(line.size() - 2), "·");
}

TEST(TerminalPicture, HasALegend) {
  for (const bool colour : {false, true}) {
    const std::string text = terminal_picture(half_blind(), 60, colour);
    EXPECT_TRUE(has(text, "eigmax, z = 0 m")) << text;
    EXPECT_TRUE(has(text, "50 mm ")) << text;
    EXPECT_TRUE(has(text, " 100 mm")) << text;
    EXPECT_TRUE(has(text, "· blind 45 %")) << text;  // 5 of 11 columns
  }
}

TEST(TerminalPicture, KeepsWithinTheWidth) {
  for (const int columns : {20, 80, 200}) {
    for (const bool colour : {false, true}) {
      const auto lines = lines_of(terminal_picture(half_blind(), columns, colour));
      for (std::size_t i = 0; i + 2 < lines.size(); ++i) {
        EXPECT_LE(width(lines[i]), static_cast<std::size_t>(columns));
        EXPECT_EQ(width(lines[i]), width(lines[0]));
      }
    }
  }
}

TEST(TerminalPicture, ColoursTwoDotsACharacter) {
  const std::string text = terminal_picture(half_blind(), 40, true);
  EXPECT_TRUE(has(text, "▀"));
  // The first dot lies beside the best sample, in the yellow end of the map.
  int r = 0, g = 0, b = 0;
  ASSERT_EQ(std::sscanf(text.c_str(), "\x1b[38;2;%d;%d;%dm", &r, &g, &b), 3);
  EXPECT_GT(r, 200);
  EXPECT_GT(g, 200);
  EXPECT_LT(b, 60);
  for (const std::string& line : lines_of(text))
    EXPECT_TRUE(!has(line, "\x1b[") || has(line, "\x1b[0m"));
}

TEST(TerminalPicture, SaysWhatCannotBeShaded) {
  EXPECT_EQ(terminal_picture(scattered({1, 2}), 40, false), "");
  const Field none = volume({{0, 0, 0}, {1, 1, 1}, {3, 3, 1}},
                            [](const Eigen::Vector3d&) { return kBlind; });
  EXPECT_TRUE(has(terminal_picture(none, 40, false), "Blind everywhere"));
  const Field equal = volume({{0, 0, 0}, {1, 1, 1}, {3, 3, 1}},
                             [](const Eigen::Vector3d&) { return 0.25; });
  EXPECT_TRUE(has(terminal_picture(equal, 40, false), "250 mm everywhere"));
}

TEST(TerminalPicture, TakesAnyWidth) {
  for (const int columns : {-5, 0, 1, 3}) {
    EXPECT_NE(terminal_picture(half_blind(), columns, true), "");
    EXPECT_NE(terminal_picture(half_blind(), columns, false), "");
  }
}

}  // namespace
}  // namespace delos
