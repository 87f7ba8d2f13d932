// What XML, TOML, YAML and JSON have in common: values within values, and where they
// stand.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "delos/document/diagnostic.h"

namespace delos::imports {

/// A value of a file. An XML element is a map of its attributes and of the elements in
/// it, whose names may repeat; its text, where it has one, is named "".
struct Value {
  enum class Kind { text, list, map };
  Kind kind = Kind::text;
  std::string text;
  int line = 0, column = 0;  ///< from 1; 0 where that isn't known
  /// Of a list, without names; of a map, in the file's order.
  std::vector<std::pair<std::string, Value>> members;

  /// The first value of that name; null where there is none.
  [[nodiscard]] const Value* find(std::string_view name) const;
  /// The value at the end of a chain of names; null where it breaks.
  [[nodiscard]] const Value* find(std::initializer_list<std::string_view> names) const;
};

/// The file that is read, and what is wrong with it.
class Source {
 public:
  Source(std::string file, Diagnostics& findings)
      : file_(std::move(file)), findings_(findings) {}

  void error(const Value& at, std::string problem);
  void warning(const Value& at, std::string problem);
  /// About a line, or the whole file: 0.
  void error(int line, std::string problem);
  void warning(int line, std::string problem);
  /// Errors of this file and of those beside it.
  [[nodiscard]] std::size_t errors() const;
  /// Another file that belongs to this one.
  [[nodiscard]] Source beside(std::string file) const {
    return {std::move(file), findings_};
  }

 private:
  void add(int line, int column, Severity severity, std::string problem);

  std::string file_;
  Diagnostics& findings_;
};

/// The whole of a text as a tree of values, at most 64 deep and a million large.
/// @returns nullopt, with an error, where the text isn't well formed or is too large
[[nodiscard]] std::optional<Value> parse_xml(std::string_view text, Source& source);
[[nodiscard]] std::optional<Value> parse_toml(std::string_view text, Source& source);
/// YAML, JSON, and what cv::FileStorage and mrcal write, which is nearly YAML.
[[nodiscard]] std::optional<Value> parse_yaml(std::string_view text, Source& source);

inline constexpr int kDeepest = 64;
inline constexpr int kMostValues = 1'000'000;

/// All numbers in a value, in order: of a list, of lists in it, or of a text with
/// blanks or commas; of a matrix as cv::FileStorage writes it, those of its `data`.
/// @returns nullopt where something in it is no finite number
[[nodiscard]] std::optional<std::vector<double>> numbers_in(const Value& value);

/// Numbers under a name.
/// @param what they are, for messages: "focal lengths"
/// @returns as many as `count`; nullopt, with an error, where there aren't
[[nodiscard]] std::optional<std::vector<double>> numbers(const Value& map,
                                                         std::string_view name,
                                                         std::size_t count,
                                                         Source& source);
[[nodiscard]] std::optional<double> number(const Value& map, std::string_view name,
                                           Source& source);
/// The same, and `otherwise` where the name isn't there.
[[nodiscard]] std::optional<double> number_or(const Value& map, std::string_view name,
                                              double otherwise, Source& source);
/// A text under a name; empty where it isn't there.
[[nodiscard]] std::string text_or_empty(const Value& map, std::string_view name);

}  // namespace delos::imports
