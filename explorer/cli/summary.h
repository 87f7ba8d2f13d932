// A field's statistics for people.
#pragma once

#include <iosfwd>

#include "command.h"
#include "delos/text/words.h"
#include "session/scene_field.h"

namespace delos::cli {

/// A text filled to a number of characters, of which UTF-8 may take several bytes.
[[nodiscard]] std::string cell(const std::string& text, std::size_t width);

/// Where the field is best, typical and worst.
void print_statistics(std::ostream& out, const Field& field);

/// The same, what it is of, and how it was computed.
void print_summary(std::ostream& out, const LoadedScene& loaded, const Field& field);

/// What adaptive sampling did: nodes, leaves, rays and why it ended.
void print_octree(std::ostream& out, const AdaptiveReport& report);

}  // namespace delos::cli
