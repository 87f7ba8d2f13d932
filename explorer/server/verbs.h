// Each thing that a page can ask of a design, as a function of the design and the
// request.
#pragma once

#include <stdexcept>
#include <string>

#include "server/reply.h"
#include "server/visitors.h"

namespace delos::server {

/// What a verb works with.
struct Work {
  Visitor& visitor;
  const Json& request;
  PluginRegistry& plugins;
  const std::atomic<bool>* stop;  ///< set: the answer is of no use any more
  int threads;
};

struct Verb {
  const char* name;
  Reply (*work)(const Work& work);
  bool changes;  ///< the design; else it only asks
};

/// The verb of a name; null where there is none.
[[nodiscard]] const Verb* find_verb(const std::string& name);

/// The description of a visitor's design as it is now.
[[nodiscard]] Json described(Visitor& visitor, PluginRegistry& plugins);

/// Thrown by what reads a request: one sentence that says what is missing.
class BadRequest : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The text under a key. @throws BadRequest
[[nodiscard]] std::string text_at(const Json& request, const char* key);

}  // namespace delos::server
