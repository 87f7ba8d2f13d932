// Each thing that a page can ask of a design, as a function of the design and the
// request.
#pragma once

#include <string>

#include "server/reply.h"
#include "server/search_place.h"
#include "server/visitors.h"

namespace delos::server {

/// What a verb works with.
struct Work {
  Visitor& visitor;
  const Json& request;
  PluginRegistry& plugins;
  SearchPlace& place;
  const std::atomic<bool>* stop;  ///< set: the answer is of no use any more
  int threads;
};

struct Verb {
  const char* name;
  Reply (*work)(const Work& work);
  bool changes;  ///< the design; else it only asks
  /// Reads nothing but what is kept of fields: done beside what is worked out.
  bool aside = false;
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

// Those of the room, whatever it is made of. @throws BadRequest
[[nodiscard]] Reply form(const Work& work);
[[nodiscard]] Reply edit(const Work& work);
[[nodiscard]] Reply copy_part(const Work& work);
[[nodiscard]] Reply rename_part(const Work& work);
[[nodiscard]] Reply shape(const Work& work);
[[nodiscard]] Reply paint(const Work& work);

/// The list of {path, value} under "set". @throws BadRequest
[[nodiscard]] std::vector<Override> changes_asked(const Json& request);
/// Take a change over, and describe what came of it; a search at work goes on from
/// there.
/// @throws BadRequest there is nothing to change
[[nodiscard]] Reply changed(const Work& work, std::vector<Override> changes,
                            const std::string& gesture);
/// Tell the search at work that the design is another one.
void tell_search(Visitor& visitor);

// Those that search, beside all others. @throws BadRequest
[[nodiscard]] Reply task(const Work& work);
[[nodiscard]] Reply vary(const Work& work);
[[nodiscard]] Reply fix(const Work& work);
[[nodiscard]] Reply terms(const Work& work);
[[nodiscard]] Reply searches(const Work& work);
[[nodiscard]] Reply search_start(const Work& work);
[[nodiscard]] Reply select_start(const Work& work);
[[nodiscard]] Reply front_start(const Work& work);
[[nodiscard]] Reply search_pause(const Work& work);
[[nodiscard]] Reply search_resume(const Work& work);
[[nodiscard]] Reply search_lock(const Work& work);
[[nodiscard]] Reply search_follow(const Work& work);
[[nodiscard]] Reply search_accept(const Work& work);
[[nodiscard]] Reply search_reject(const Work& work);
[[nodiscard]] Reply search_reinstate(const Work& work);

// Those that work something out of it. @throws BadRequest
[[nodiscard]] Reply field(const Work& work);
[[nodiscard]] Reply difference(const Work& work);
[[nodiscard]] Reply sensitivity(const Work& work);
[[nodiscard]] Reply through(const Work& work);
[[nodiscard]] Reply sections(const Work& work);
[[nodiscard]] Reply point(const Work& work);
[[nodiscard]] Reply lattice(const Work& work);
[[nodiscard]] Reply blind(const Work& work);
[[nodiscard]] Reply worth(const Work& work);
[[nodiscard]] Reply shapes(const Work& work);

/// Of work that was stopped.
[[nodiscard]] Reply superseded();

}  // namespace delos::server
