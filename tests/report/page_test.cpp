// A report is one file: nothing that somebody named leaves its place in it, and nothing
// is asked of a network.
#include <gtest/gtest.h>

#include "bundle/page_file.h"
#include "report/report.h"
#include "support/occurrences.h"

namespace delos::report {
namespace {

const std::string kEvil = "</script><img src=x onerror=alert(1)><!--<script>";

std::string page_of_evil() {
  return page_of(
      {kEvil, kEvil, {{"kind", "scene"}, {kEvil, kEvil}}, {{kEvil, kEvil, "png"}}});
}

/// What stands between the tags of an element.
std::string content_of(const std::string& page, const std::string& tag) {
  const std::size_t begin = page.find(tag);
  if (begin == std::string::npos) return "";
  return page.substr(begin + tag.size(),
                     page.find("</script>", begin) - begin - tag.size());
}

TEST(ReportPage, KeepsNamesInTheirPlaces) {
  const std::string page = page_of_evil();
  EXPECT_EQ(test::occurrences(page, "<img src=x"), 0u);
  // Three scripts: the data, the licences, the program; each ends once.
  EXPECT_EQ(test::occurrences(page, "</script"), 3u);
  // In the title twice, the headline, the alternative text and the caption.
  EXPECT_EQ(test::occurrences(page, "&lt;/script&gt;&lt;img src=x"), 5u);
  const auto data = session::Json::parse(
      content_of(page, "<script type=\"application/json\" id=\"frozen\">"));
  EXPECT_EQ(data[kEvil], kEvil);
}

TEST(ReportPage, HoldsTheBundleWhole) {
  const std::string page = page_of_evil();
  const auto script = bundle::page_file("/explorer.js");
  const auto style = bundle::page_file("/explorer.css");
  ASSERT_TRUE(script && style);
  // What would end its element, or hide its end, isn't in it.
  for (const char* end : {"</script", "<!--", "</style"}) {
    EXPECT_EQ(script->bytes.find(end), std::string_view::npos) << end;
    EXPECT_EQ(style->bytes.find(end), std::string_view::npos) << end;
  }
  EXPECT_NE(page.find(script->bytes), std::string::npos);
  EXPECT_NE(page.find(style->bytes), std::string::npos);
  EXPECT_NE(page.find("MIT"), std::string::npos);  // the licence of what it contains
}

TEST(ReportPage, AsksNothingOfANetwork) {
  const std::string page = page_of_evil();
  EXPECT_NE(page.find("default-src &#39;none&#39;"), std::string::npos);
  const std::string head = page.substr(0, page.find("<style>"));
  EXPECT_EQ(test::occurrences(head, "href="), test::occurrences(head, "href=\"data:"));
  EXPECT_EQ(test::occurrences(page, "<img "),
            test::occurrences(page, "<img src=\"data:image/png;base64,"));
}

}  // namespace
}  // namespace delos::report
