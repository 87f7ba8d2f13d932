// A field as a page draws it: its values over shapes that have neighbours.
#pragma once

#include <string>

#include "session/scene_field.h"

namespace delos::session {

// NOLINTNEXTLINE(bugprone-exception-escape): nlohmann's moves don't throw
struct DrawnField {
  Field field;          ///< over grids where its scene is sampled adaptively
  Json summary;         ///< field_answer() of the scene's own samples
  bool coarse = false;  ///< over fewer samples than the scene's
};

/// Evaluate a scene to be drawn.
/// @param most more samples than this make it coarse: grids then have about so many, or
///        fewer; 0: never coarse
/// @throws std::invalid_argument as make_steady_solver()
[[nodiscard]] DrawnField draw_field(const LoadedScene& loaded, std::size_t most,
                                    const FieldOptions& options);

/// The same sets with about `most` samples or fewer, where they are grids; adaptive
/// ones become grids.
[[nodiscard]] std::vector<SampleSet> coarser(std::vector<SampleSet> sets,
                                             std::size_t most);

/// How a value is to be drawn.
enum class Drawn : unsigned char {
  blind = 0,  ///< the metric has no finite value there
  value = 1,
  inside = 2,  ///< within a solid, where no target can be
};

/// "DLF1", the length of a JSON text as 32 bits, the text, filled up to four bytes,
/// then its arrays, little-endian, where the text says, in bytes from its own end:
///
///   {revision, level, summary,
///    values: {at, count}   float32, not a number where it isn't finite
///    mask: {at, count}     uint8, a Drawn each
///    parts: [{name, kind: grid, first, count, origin, step, counts}
///            {…, kind: plane, origin, u, v, counts}
///            {…, kind: points, positions: at}                    float32, 3 each
///            {…, kind: surface, positions, triangles, corners}]}   uint32, 3 each
[[nodiscard]] std::string packed(const DrawnField& drawn, std::size_t revision);

}  // namespace delos::session
