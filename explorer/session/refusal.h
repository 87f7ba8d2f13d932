// What can't be answered, and whose mistake that is.
#pragma once

#include <stdexcept>
#include <string>

#include "delos/device/faults.h"
#include "delos/document/diagnostic.h"

namespace delos::session {

/// Who has to change something.
enum class Blame {
  scene,     ///< the scene's file, or a device's plugin
  question,  ///< what was asked of it
};

/// Thrown instead of an answer.
class Refusal : public std::runtime_error {
 public:
  /// @param findings with one error or more; what() has them all, a line each
  explicit Refusal(Diagnostics findings);
  /// @param sentence what is wrong and what to do
  Refusal(Blame blame, const std::string& sentence);

  [[nodiscard]] Blame blame() const { return blame_; }
  /// Located ones of a scene; empty where there is only a sentence.
  [[nodiscard]] const Diagnostics& findings() const { return findings_; }

 private:
  Blame blame_;
  Diagnostics findings_;
};

}  // namespace delos::session
