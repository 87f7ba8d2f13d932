// Collects what is wrong with a scene's texts, in the order of the texts.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "delos/document/diagnostic.h"

namespace delos {

/// A place in one of the texts that make a scene. Small, since every node has one.
struct Mark {
  int source = 0;  ///< which text, see Findings::add_source()
  int line = 0;    ///< from 1; 0 where the text has no lines
  int column = 0;  ///< from 1
};

/// Findings of one pass over a scene: its own text, overrides and files that it names.
class Findings {
 public:
  /// Announce a text; findings are sorted in the order of announcement.
  int add_source(std::string name);

  /// @param path    of the value; may be empty
  /// @param problem what is wrong with it, and what to do
  void error(Mark where, std::string path, std::string problem);

  /// The same for what may be meant, but seldom is: it stops nothing.
  void warning(Mark where, std::string path, std::string problem);

  /// Errors so far: comparing two counts tells whether something between was in order.
  [[nodiscard]] std::size_t errors() const { return errors_; }

  /// Append to `out` in order of position. A value that several paths lead to, by way
  /// of aliases, is reported under the first of them only.
  void move_to(Diagnostics& out);

 private:
  struct Finding {
    Mark where;
    Severity severity;
    std::string path, problem;
  };
  std::vector<std::string> sources_;
  std::vector<Finding> found_;
  std::size_t errors_ = 0;
};

}  // namespace delos
