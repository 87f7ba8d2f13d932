// Each thing that a page can ask of a design, as a function of the design and the
// request.
#pragma once

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

// Those that change the design or what it is compared with; each answers with the
// description of what came of it. @throws BadRequest
[[nodiscard]] Reply change(const Work& work);
[[nodiscard]] Reply place(const Work& work);
[[nodiscard]] Reply add(const Work& work);
[[nodiscard]] Reply copy(const Work& work);
[[nodiscard]] Reply array(const Work& work);
[[nodiscard]] Reply mirror(const Work& work);
[[nodiscard]] Reply remove(const Work& work);
[[nodiscard]] Reply undo(const Work& work);
[[nodiscard]] Reply redo(const Work& work);
[[nodiscard]] Reply pin(const Work& work);
[[nodiscard]] Reply unpin(const Work& work);

// Those that work something out of it. @throws BadRequest
[[nodiscard]] Reply field(const Work& work);
[[nodiscard]] Reply difference(const Work& work);
[[nodiscard]] Reply sensitivity(const Work& work);
[[nodiscard]] Reply sections(const Work& work);
[[nodiscard]] Reply point(const Work& work);
[[nodiscard]] Reply lattice(const Work& work);
[[nodiscard]] Reply blind(const Work& work);
[[nodiscard]] Reply worth(const Work& work);

}  // namespace delos::server
