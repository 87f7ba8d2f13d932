#include "delos/document/changed_text.h"

#include "document/node_text.h"
#include "document/override.h"

namespace delos {

std::optional<std::string> changed_text(std::string_view text,
                                        const std::vector<Override>& changes,
                                        Diagnostics& findings) {
  Findings found;
  std::optional<Node> tree = parse_yaml(text, found.add_source("text"), false, found);
  if (tree)
    for (const Override& change : changes) apply_override(*tree, change, found);
  const bool whole = found.errors() == 0;
  found.move_to(findings);
  return whole ? std::optional(to_yaml(*tree)) : std::nullopt;
}

}  // namespace delos
