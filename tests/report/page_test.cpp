// A report is one file: nothing that somebody named leaves its place in it, and nothing
// is asked of a network.
#include <gtest/gtest.h>

#include "bundle/page_file.h"
#include "report/report.h"

namespace delos::report {
namespace {

const std::string kEvil = "</script><img src=x onerror=alert(1)><!--<script>";

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t n = 0;
  for (std::size_t at = text.find(what); at != std::string::npos;
       at = text.find(what, at + what.size()))
    ++n;
  return n;
}

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
  EXPECT_EQ(count(page, "<img src=x"), 0u);
  // Three scripts: the data, the licences, the program; each ends once.
  EXPECT_EQ(count(page, "</script"), 3u);
  EXPECT_EQ(count(page, "&lt;/script&gt;&lt;img src=x"), 5u);  // title twice, headline,
                                                               // alternative, caption
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
  EXPECT_EQ(count(head, "href="), count(head, "href=\"data:"));
  EXPECT_EQ(count(page, "<img "), count(page, "<img src=\"data:image/png;base64,"));
}

}  // namespace
}  // namespace delos::report
