#include "imports/value.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace delos::imports {
namespace {

bool collect(const Value& value, std::vector<double>& out) {
  for (const auto& [name, member] : value.members)
    if (!collect(member, out)) return false;
  if (value.kind != Value::Kind::text) return true;
  std::string_view text = value.text;
  bool any = false;
  while (true) {
    const std::size_t begin = text.find_first_not_of(" \t\r\n,;");
    if (begin == std::string_view::npos) return any;
    text.remove_prefix(begin);
    if (text.front() == '+') text.remove_prefix(1);
    double number = 0;
    const auto [end, error] =
        std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || !std::isfinite(number)) return false;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    if (!text.empty() &&
        std::string_view(" \t\r\n,;").find(text.front()) == std::string_view::npos)
      return false;
    out.push_back(number);
    any = true;
  }
}

}  // namespace

const Value* Value::find(std::string_view name) const {
  for (const auto& [key, value] : members)
    if (kind == Kind::map && key == name) return &value;
  return nullptr;
}

const Value* Value::find(std::initializer_list<std::string_view> names) const {
  const Value* at = this;
  for (const std::string_view name : names)
    if (at != nullptr) at = at->find(name);
  return at;
}

std::size_t Source::errors() const {
  return static_cast<std::size_t>(
      std::count_if(findings_.begin(), findings_.end(),
                    [](const Diagnostic& d) { return d.severity == Severity::error; }));
}

void Source::add(int line, int column, Severity severity, std::string problem) {
  // A file of another kind has a finding a line.
  constexpr std::size_t kMostTold = 50;
  const std::size_t errors_so_far = errors();
  const std::size_t like_it =
      severity == Severity::error ? errors_so_far : findings_.size() - errors_so_far;
  if (like_it < kMostTold)
    findings_.push_back({{file_, line, column}, severity, std::move(problem)});
}

void Source::error(const Value& at, std::string problem) {
  add(at.line, at.column, Severity::error, std::move(problem));
}
void Source::warning(const Value& at, std::string problem) {
  add(at.line, at.column, Severity::warning, std::move(problem));
}
void Source::error(int line, std::string problem) {
  add(line, 0, Severity::error, std::move(problem));
}
void Source::warning(int line, std::string problem) {
  add(line, 0, Severity::warning, std::move(problem));
}

std::optional<std::vector<double>> numbers_in(const Value& value) {
  std::vector<double> out;
  const Value* data = value.find("data");
  if (!collect(data ? *data : value, out)) return std::nullopt;
  return out;
}

std::optional<std::vector<double>> numbers(const Value& map, std::string_view name,
                                           std::size_t count, Source& source) {
  const std::string called(name);
  const Value* value = map.find(name);
  if (value == nullptr) {
    source.error(map, "lacks '" + called + "'; is the file cut off?");
    return std::nullopt;
  }
  auto all = numbers_in(*value);
  if (!all || all->size() != count) {
    source.error(*value, "'" + called + "' must be " +
                             (count == 1 ? std::string("a number")
                                         : std::to_string(count) + " numbers") +
                             (all ? ", and has " + std::to_string(all->size()) : ""));
    return std::nullopt;
  }
  return all;
}

std::optional<double> number(const Value& map, std::string_view name, Source& source) {
  const auto one = numbers(map, name, 1, source);
  return one ? std::optional((*one)[0]) : std::nullopt;
}

std::optional<double> number_or(const Value& map, std::string_view name,
                                double otherwise, Source& source) {
  return map.find(name) ? number(map, name, source) : std::optional(otherwise);
}

std::string text_or_empty(const Value& map, std::string_view name) {
  const Value* value = map.find(name);
  return value != nullptr ? value->text : std::string();
}

}  // namespace delos::imports
