// The keys of scenes as a page of the manual.
#pragma once

#include <string>

namespace delos::session {

/// Every mapping of a scene once, with a table of its keys: what each is, its unit and
/// bounds, and whether it must be there. Markdown.
[[nodiscard]] std::string key_manual();

}  // namespace delos::session
