// Pieces of an HTML page.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace delos::figures {

/// Markup. Text becomes part of it only escaped, so that nothing that a user wrote is
/// ever read as markup.
class Html {
 public:
  Html() = default;
  Html(std::string_view text);  // not explicit: text is what pages are made of
  Html(const std::string& text) : Html(std::string_view(text)) {}
  Html(const char* text) : Html(std::string_view(text)) {}

  /// What the program itself writes as markup.
  static Html markup(std::string_view own);

  Html& operator+=(const Html& more) {
    markup_ += more.markup_;
    return *this;
  }
  friend Html operator+(Html a, const Html& b) { return a += b; }

  [[nodiscard]] const std::string& str() const { return markup_; }
  [[nodiscard]] bool empty() const { return markup_.empty(); }

 private:
  std::string markup_;
};

/// An attribute: its value is escaped.
struct Attribute {
  const char* name;
  std::string value;
};

/// <tag …>content</tag>
[[nodiscard]] Html element(const char* tag, const Html& content);
[[nodiscard]] Html element(const char* tag, std::initializer_list<Attribute> attributes,
                           const Html& content);
/// <tag …>, of which there is no end: meta, link, img.
[[nodiscard]] Html void_element(const char* tag,
                                std::initializer_list<Attribute> attributes);

/// A whole page that needs nothing else, neither scripts nor other files.
[[nodiscard]] std::string page(std::string_view title, const Html& body);

}  // namespace delos::figures
