#include "session/refusal.h"

#include <utility>

namespace delos::session {
namespace {

std::string lines_of(const Diagnostics& findings) {
  std::string text;
  for (const Diagnostic& d : findings)
    text += (text.empty() ? "" : "\n") + to_string(d);
  return text;
}

}  // namespace

Refusal::Refusal(Diagnostics findings)
    : std::runtime_error(lines_of(findings)),
      blame_(Blame::scene),
      findings_(std::move(findings)) {}

Refusal::Refusal(Blame blame, const std::string& sentence)
    : std::runtime_error(sentence), blame_(blame) {}

}  // namespace delos::session
