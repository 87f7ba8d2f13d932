// Whatever a user wrote stays text, in pages, drawings and titles.
#include "figures/html.h"

#include <gtest/gtest.h>

#include <limits>

#include "figures/chart.h"
#include "support/occurrences.h"

namespace delos::figures {
namespace {

const std::string kEvil = "<script>alert(\"1\")</script> & 'so' on";
const std::string kEscaped =
    "&lt;script&gt;alert(&quot;1&quot;)&lt;/script&gt; &amp; &#39;so&#39; on";

TEST(Html, EscapesTextAndAttributes) {
  EXPECT_EQ(Html(kEvil).str(), kEscaped);
  EXPECT_EQ(element("p", {{"title", kEvil}}, kEvil).str(),
            "<p title=\"" + kEscaped + "\">" + kEscaped + "</p>\n");
  // Markup of the program's own stays as it is, and is escaped once at most.
  EXPECT_EQ(element("p", element("b", "a & b")).str(), "<p><b>a &amp; b</b>\n</p>\n");
}

TEST(Html, HoldsNoControlCharacters) {
  EXPECT_EQ(Html("a\x01"
                 "b\nc")
                .str(),
            "a\uFFFD"
            "b\nc");
}

TEST(Page, IsWholeAndNeedsNothingElse) {
  const std::string text = page(kEvil, element("h1", kEvil) + element("p", kEvil));
  EXPECT_EQ(text.rfind("<!DOCTYPE html>\n<html lang=\"en\">", 0), 0u);
  EXPECT_EQ(test::occurrences(text, kEscaped), 3u);
  for (const char* outside : {"<script", "http://", "https://", "<link", "@import"})
    EXPECT_EQ(test::occurrences(text, outside), 0u) << outside;
}

TEST(Chart, SaysWhatItShowsAndDrawsEveryPoint) {
  Chart chart;
  chart.says = kEvil;
  chart.x_name = "devices";
  chart.y_name = "eigmax";
  chart.y_unit = "m";
  chart.series = {{kEvil, Stroke::line, {{3, 0.002}, {4, 0.0015}, {5, 0.0012}}}};
  chart.marks = {{4, kEvil}};
  const std::string text = chart_figure(chart, kEvil).str();
  EXPECT_NE(text.find("role=\"img\" aria-label=\"" + kEscaped), std::string::npos);
  EXPECT_EQ(test::occurrences(text, "<circle"), 3u);
  EXPECT_EQ(test::occurrences(text, "<script>"), 0u);
  EXPECT_NE(text.find("eigmax [mm]"), std::string::npos) << text;
  EXPECT_EQ(test::occurrences(text, "nan"), 0u);
  EXPECT_EQ(test::occurrences(text, "inf"), 0u);
}

TEST(Chart, OfOnePointHasAnAxis) {
  Chart chart;
  chart.series = {{"one", Stroke::line, {{3, 0}}}};
  const std::string text = chart_figure(chart, "").str();
  EXPECT_EQ(test::occurrences(text, "nan"), 0u) << text;
  EXPECT_EQ(test::occurrences(text, "inf"), 0u);
}

}  // namespace
}  // namespace delos::figures
