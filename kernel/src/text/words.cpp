#include "delos/text/words.h"

#include "delos/text/number_text.h"

namespace delos {

std::string joined(std::span<const std::string> words, std::string_view between) {
  std::string text;
  for (const std::string& word : words) {
    if (!text.empty()) text += between;
    text += word;
  }
  return text;
}

std::string listed(std::span<const std::string> names) {
  constexpr std::size_t kShown = 8;
  if (names.size() == 1) return names.front();
  if (names.size() > kShown)
    return joined(names.first(kShown - 1)) + " and " +
           std::to_string(names.size() - (kShown - 1)) + " more";
  if (names.empty()) return {};
  return joined(names.first(names.size() - 1)) + " and " + names.back();
}

std::string counted(std::size_t count, std::string_view noun) {
  return std::to_string(count) + ' ' + std::string(noun) + (count == 1 ? "" : "s");
}

std::string percent(double part) { return rounded(100 * part, 3) + " %"; }

std::string coordinates(const Eigen::Vector3d& p, int digits) {
  return '(' + rounded(p.x(), digits) + ", " + rounded(p.y(), digits) + ", " +
         rounded(p.z(), digits) + ')';
}

bool fits(std::string_view name, std::string_view pattern) {
  if (pattern.empty()) return name.empty();
  if (pattern.front() != '*')
    return !name.empty() && name.front() == pattern.front() &&
           fits(name.substr(1), pattern.substr(1));
  for (std::size_t skip = 0; skip <= name.size(); ++skip)
    if (fits(name.substr(skip), pattern.substr(1))) return true;
  return false;
}

}  // namespace delos
