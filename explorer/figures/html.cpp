#include "figures/html.h"

namespace delos::figures {
namespace {

constexpr const char* kStyle = R"(
:root { color-scheme: light; }
body { font: 16px/1.5 system-ui, "DejaVu Sans", sans-serif; color: #1c1c1c;
  background: #fff; max-width: 70rem; margin: 0 auto; padding: 1rem; }
figure { margin: 0; max-width: 48rem; }
figure svg { width: 100%; height: auto; display: block; }
figcaption { color: #444; font-size: 0.9rem; }
@media print { body { max-width: none; font-size: 10pt; padding: 0; }
  figure { break-inside: avoid; } }
)";

/// <tag …>
Html opening(const char* tag, std::initializer_list<Attribute> attributes) {
  Html html = Html::markup("<" + std::string(tag));
  for (const Attribute& a : attributes)
    html += Html::markup(" " + std::string(a.name) + "=\"") + Html(a.value) +
            Html::markup("\"");
  return html + Html::markup(">");
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
  return opening(tag, attributes) + content +
         Html::markup("</" + std::string(tag) + ">\n");
}

Html void_element(const char* tag, std::initializer_list<Attribute> attributes) {
  return opening(tag, attributes) + Html::markup("\n");
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

}  // namespace delos::figures
