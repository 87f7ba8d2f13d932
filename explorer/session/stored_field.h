// Fields kept in files, to be read again without computing them (Allen, 2007, §4.1.5).
#pragma once

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "delos/field/field.h"
#include "output/marker.h"

namespace delos::session {

/// A field with all that its statistics, pictures and comparisons are of, but for the
/// octree behind an adaptive one, of which it has the nodes.
struct StoredField {
  Field field;
  std::vector<Marker> devices;
};

/// Whether a file is one of these, by its name: ".field".
[[nodiscard]] bool is_stored_field(const std::filesystem::path& file);

/// Write it as CBOR (RFC 8949), arrays as bytes, little-endian; whole or not at all.
/// @returns empty, or a sentence that says why it was not written
[[nodiscard]] std::string store_field(const Field& field,
                                      const std::vector<Marker>& devices,
                                      const std::filesystem::path& file);

/// @returns it, to the last bit, or a sentence that says why it can't be read: what is
///          damaged is refused and never guessed
[[nodiscard]] std::variant<StoredField, std::string> read_field(
    const std::filesystem::path& file);

}  // namespace delos::session
