#include "bundle/page_file.h"
#include "figures/html.h"
#include "output/base64.h"
#include "report/report.h"

namespace delos::report {
namespace {

using figures::element;
using figures::Html;
using figures::void_element;

/// A file of the explorer's bundle.
std::string bundled(std::string_view path) {
  return std::string(bundle::page_file(path).value().bytes);
}

/// Text within <script>, where nothing is escaped: no name ends it, since no '<' is in
/// it.
Html script(std::initializer_list<figures::Attribute> attributes,
            const std::string& text) {
  return element("script", attributes, Html::markup(text));
}

std::string without_tags(const std::string& json) {
  std::string text;
  text.reserve(json.size());
  for (const char c : json) c == '<' ? text += "\\u003c" : text += c;
  return text;
}

Html still_figure(const Still& still) {
  const Html picture = void_element(
      "img",
      {{"src", "data:image/png;base64," + base64_of(still.png)}, {"alt", still.says}});
  return element("figure", picture + element("figcaption", still.caption));
}

/// The page itself sees to it that nothing is asked of a network.
constexpr const char* kPolicy =
    "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; "
    "img-src data: blob:; base-uri 'none'; form-action 'none'";

Html head_of(const Report& report) {
  return void_element("meta", {{"charset", "utf-8"}}) +
         void_element("meta", {{"http-equiv", "Content-Security-Policy"},
                               {"content", kPolicy}}) +
         void_element("meta", {{"name", "viewport"},
                               {"content", "width=device-width, initial-scale=1"}}) +
         void_element("meta", {{"name", "color-scheme"}, {"content", "dark light"}}) +
         element("title", report.title + " · Delos") +
         void_element("link", {{"rel", "icon"},
                               {"href", "data:image/svg+xml;base64," +
                                            base64_of(bundled("/icon.svg"))}}) +
         element("style", Html::markup(bundled("/explorer.css")));
}

Html body_of(const Report& report) {
  Html stills;
  for (const Still& still : report.stills) stills += still_figure(still);
  const Html without_script = element("h1", report.title) +
                              element("p", report.headline) +
                              element("p",
                                      "All else on this page, its tables too, is drawn "
                                      "with JavaScript, which is off.");
  return element("noscript", without_script) + element("div", {{"id", "app"}}, {}) +
         element("div", {{"id", "stills"}, {"class", "stills"}}, stills) +
         script({{"type", "application/json"}, {"id", "frozen"}},
                without_tags(session::text_of(report.data))) +
         script({{"type", "text/plain"}, {"id", "licences"}},
                without_tags(bundled("/licences.txt"))) +
         script({{"type", "module"}}, bundled("/explorer.js"));
}

}  // namespace

std::string page_of(const Report& report) {
  return "<!doctype html>\n" +
         element("html", {{"lang", "en"}},
                 element("head", head_of(report)) +
                     element("body", {{"class", "report"}}, body_of(report)))
             .str();
}

}  // namespace delos::report
