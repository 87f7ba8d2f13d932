// What requests about searches have in common.
#pragma once

#include <optional>
#include <vector>

#include "server/verbs.h"
#include "session/search_run.h"

namespace delos::server {

/// The newest search. @throws BadRequest there is none
[[nodiscard]] Searched& now(const Work& work);

/// It as one for values of variables. @throws BadRequest it is another one
[[nodiscard]] session::SearchRun& run_of(Searched& searched);

/// Take over what a search has found: a step of the design, or a part of one. The
/// search isn't told, since it knows.
/// @returns nullopt, or why not
[[nodiscard]] std::optional<Reply> take_over(const Work& work, Searched& searched,
                                             std::vector<Override> changes);

}  // namespace delos::server
