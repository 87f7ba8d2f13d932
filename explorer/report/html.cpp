#include "report/html.h"

#include <cctype>

namespace delos::report {
namespace {

constexpr const char* kStyle = R"(
:root { color-scheme: light; }
body { font: 16px/1.5 system-ui, "DejaVu Sans", sans-serif; color: #1c1c1c;
  background: #fff; max-width: 70rem; margin: 0 auto; padding: 1rem; }
h1 { font-size: 1.6rem; line-height: 1.2; margin: 0.5rem 0; }
h2 { font-size: 1.2rem; margin: 2.2rem 0 0.5rem; border-bottom: 1px solid #ccc; }
h3 { font-size: 1rem; margin: 1.2rem 0 0.3rem; }
.answer { font-size: 1.1rem; }
.figures { display: grid; gap: 1rem;
  grid-template-columns: repeat(auto-fit, minmax(min(100%, 19rem), 1fr)); }
figure { margin: 0; }
figure svg { width: 100%; height: auto; display: block; }
.chart { max-width: 48rem; }
figcaption, caption, .note { color: #444; font-size: 0.9rem; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; min-width: min(100%, 24rem); margin: 0.5rem 0; font-size: 0.92rem; }
caption { text-align: left; padding-bottom: 0.3rem; }
th, td { padding: 0.2rem 0.7rem 0.2rem 0; border-bottom: 1px solid #e2e2e2;
  text-align: left; vertical-align: top; }
th { font-weight: 600; border-bottom-color: #999; }
.n { text-align: right; white-space: nowrap; font-variant-numeric: tabular-nums; }
td:first-child { overflow-wrap: anywhere; min-width: 7rem; }
.good { color: #1d6b2f; } .bad { color: #a11622; font-weight: 600; }
pre { background: #f5f5f3; padding: 0.7rem; overflow-x: auto; font-size: 0.82rem; }
@media print { body { max-width: none; font-size: 10pt; padding: 0; }
  .figures { grid-template-columns: repeat(3, 1fr); }
  figure, tr { break-inside: avoid; } h2, h3 { break-after: avoid; }
  pre { white-space: pre-wrap; } .wide { overflow: visible; } }
)";

bool is_number(const std::string& cell) {
  constexpr std::size_t kLongest = 24;  // what is longer is a sentence
  if (cell.empty() || cell.size() > kLongest) return false;
  if (cell.rfind("∞", 0) == 0 || cell.rfind("−", 0) == 0) return true;
  const auto digit = [&](std::size_t i) {
    return i < cell.size() && std::isdigit(static_cast<unsigned char>(cell[i])) != 0;
  };
  return digit(0) || ((cell[0] == '-' || cell[0] == '+') && digit(1));
}

}  // namespace

Html::Html(std::string_view text) {
  for (const char c : text) {
    switch (c) {
      case '&':
        markup_ += "&amp;";
        break;
      case '<':
        markup_ += "&lt;";
        break;
      case '>':
        markup_ += "&gt;";
        break;
      case '"':
        markup_ += "&quot;";
        break;
      case '\'':
        markup_ += "&#39;";
        break;
      default:
        // Of the control characters a page may hold but these three.
        if (static_cast<unsigned char>(c) >= 0x20 || c == '\n' || c == '\t')
          markup_ += c;
        else
          markup_ += "\uFFFD";
    }
  }
}

Html Html::markup(std::string_view own) {
  Html html;
  html.markup_ = own;
  return html;
}

Html element(const char* tag, const Html& content) { return element(tag, {}, content); }

Html element(const char* tag, std::initializer_list<Attribute> attributes,
             const Html& content) {
  Html html = Html::markup("<" + std::string(tag));
  for (const Attribute& a : attributes)
    html += Html::markup(" " + std::string(a.name) + "=\"") + Html(a.value) +
            Html::markup("\"");
  html += Html::markup(">") + content;
  return html + Html::markup("</" + std::string(tag) + ">\n");
}

Html table(const Html& caption, const std::vector<Html>& head,
           const std::vector<std::vector<Html>>& rows) {
  // The first column says what a row is about.
  const auto kind = [](const std::vector<Html>& row, std::size_t column) {
    return column > 0 && column < row.size() && is_number(row[column].str());
  };
  const auto cell = [](const char* tag, bool number, const Html& content) {
    return number ? element(tag, {{"class", "n"}}, content) : element(tag, content);
  };
  Html names, body;
  for (std::size_t i = 0; i < head.size(); ++i)
    names += cell("th", !rows.empty() && kind(rows.front(), i), head[i]);
  for (const std::vector<Html>& row : rows) {
    Html cells;
    for (std::size_t i = 0; i < row.size(); ++i)
      cells += cell("td", kind(row, i), row[i]);
    body += element("tr", cells);
  }
  const Html all = element("caption", caption) +
                   element("thead", element("tr", names)) + element("tbody", body);
  return element("div", {{"class", "wide"}}, element("table", all));
}

Html section(std::string_view heading, const Html& content) {
  return element("section", element("h2", heading) + content);
}

std::string page(std::string_view title, const Html& body) {
  const Html head = Html::markup("<meta charset=\"utf-8\">\n") +
                    Html::markup(
                        "<meta name=\"viewport\" content=\"width=device-width, "
                        "initial-scale=1\">\n") +
                    element("title", title) + element("style", Html::markup(kStyle));
  return "<!DOCTYPE html>\n" +
         element("html", {{"lang", "en"}},
                 element("head", head) + element("body", element("main", body)))
             .str();
}

}  // namespace delos::report
