#include "cover/check_cover.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <utility>

namespace delos {
namespace {

/// How many of many are named.
constexpr std::size_t kNamed = 10;

class Findings {
 public:
  void add(const std::string& what) { text_ += (text_.empty() ? "" : "; ") + what; }
  [[nodiscard]] bool none() const { return text_.empty(); }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// Lists must be whole before anything can be read of them.
void check_sizes(const CoverProblem& p, Findings& findings) {
  const std::size_t n = p.start.empty() ? 0 : p.start.size() - 1;
  if (p.samples <= 0) findings.add("there are no samples to see");
  if (n == 0) findings.add("there are no candidates");
  if (p.start.empty() || p.start.front() != 0 ||
      p.start.back() != static_cast<std::int64_t>(p.seen.size()))
    findings.add("the candidates' starts don't span the list of what is seen");
  for (std::size_t j = 0; j < n; ++j)
    if (p.start[j] > p.start[j + 1])
      return findings.add("the start of candidate " + std::to_string(j + 1) +
                          " lies before that of the one before");
  const auto sized = [&](std::size_t size, std::size_t wanted, const char* what) {
    if (size != wanted)
      findings.add(std::string("there are ") + std::to_string(size) + " " + what +
                   ", wanted " + std::to_string(wanted));
  };
  sized(p.cost.size(), n, "costs");
  sized(p.demand.size(), static_cast<std::size_t>(std::max(p.samples, 0)), "demands");
  if (!p.fixed.empty()) sized(p.fixed.size(), n, "candidates fixed or free");
  if (!p.group.empty()) sized(p.group.size(), n, "groups");
}

void check_lists(const CoverProblem& p, Findings& findings) {
  for (int j = 0; j < p.candidates(); ++j) {
    int before = -1;
    for (std::int64_t k = p.start[j]; k < p.start[j + 1]; ++k) {
      if (p.seen[k] <= before || p.seen[k] >= p.samples)
        return findings.add("candidate " + std::to_string(j) +
                            " sees samples that don't exist, or not in rising order");
      before = p.seen[k];
    }
  }
}

void check_values(const CoverProblem& p, Findings& findings) {
  for (int j = 0; j < p.candidates(); ++j) {
    if (p.cost[j] > 0 && std::isfinite(p.cost[j])) continue;
    findings.add("the cost of candidate " + std::to_string(j) + " isn't positive");
    break;
  }
  for (int i = 0; i < p.samples; ++i) {
    if (p.demand[i] >= 0) continue;
    findings.add("the demand of sample " + std::to_string(i) + " is negative");
    break;
  }
}

void check_groups(const CoverProblem& p, Findings& findings) {
  if (p.group.empty() || p.fixed.empty()) return;
  std::unordered_map<int, int> members;
  for (int j = 0; j < p.candidates(); ++j) {
    if (p.group[j] < 0 || p.fixed[j] != Membership::in) continue;
    const auto [first, fresh] = members.emplace(p.group[j], j);
    if (!fresh)
      findings.add("candidates " + std::to_string(first->second) + " and " +
                   std::to_string(j) + " are both fixed in, but of one group");
  }
}

}  // namespace

void check_cover(const CoverProblem& problem) {
  Findings findings;
  check_sizes(problem, findings);
  if (findings.none()) {
    check_lists(problem, findings);
    check_values(problem, findings);
    check_groups(problem, findings);
  }
  if (!findings.none()) throw std::invalid_argument(findings.text());
}

void refuse_uncoverable(std::vector<int> missed) {
  if (missed.empty()) return;
  std::string names;
  for (std::size_t k = 0; k < missed.size() && k < kNamed; ++k)
    names += (k ? ", " : "") + std::to_string(missed[k]);
  if (missed.size() > kNamed)
    names += " and " + std::to_string(missed.size() - kNamed) + " more";
  const std::string text = "too few candidates see sample" +
                           std::string(missed.size() > 1 ? "s " : " ") + names;
  throw Uncoverable(text, std::move(missed));
}

}  // namespace delos
