// A field as a page draws it: its values over shapes that have neighbours.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "session/scene_field.h"

namespace delos::session {

/// How a value is to be drawn.
enum class Drawn : unsigned char {
  blind = 0,  ///< the metric has no finite value there
  value = 1,
  inside = 2,  ///< within a solid, where no target can be
  gained = 3,  ///< of a difference: only the second has a value
  lost = 4,    ///< of a difference: only the first has one
};

// NOLINTNEXTLINE(bugprone-exception-escape): nlohmann's moves don't throw
struct DrawnField {
  Field field;              ///< over grids where its scene is sampled adaptively
  Json summary;             ///< field_answer() of the scene's own samples
  bool coarse = false;      ///< over fewer samples than the scene's
  std::vector<Drawn> mask;  ///< one a sample
  /// Of an adaptive scene, the octree that the field was read from: one OctreeShape.
  /// Null of others, and where it is coarse.
  std::shared_ptr<const Samples> leaves;
};

/// Evaluate a scene to be drawn.
/// @param most more samples than this make it coarse: grids then have about so many, or
///        fewer; 0: never coarse
/// @throws std::invalid_argument as make_steady_solver()
[[nodiscard]] DrawnField draw_field(const LoadedScene& loaded, std::size_t most,
                                    const FieldOptions& options);

/// A scene's field as it is drawn: an octree on a grid.
[[nodiscard]] DrawnField drawn_of(const LoadedScene& loaded, Evaluation evaluation);
/// A field to be drawn that no scene was evaluated for.
[[nodiscard]] DrawnField drawn_over(Field field);

/// The same sets with about `most` samples or fewer, where they are grids; adaptive
/// ones become grids.
[[nodiscard]] std::vector<SampleSet> coarser(std::vector<SampleSet> sets,
                                             std::size_t most);

/// The samples that a scene is drawn on without its octree.
/// @param most as draw_field() @param[out] fewer whether they are fewer than its own
[[nodiscard]] Samples drawn_samples(const Scene& scene, std::size_t most, bool& fewer);

/// A grid of about `most` samples or fewer over the box from min to max, metres, as
/// even along all axes as may be.
[[nodiscard]] VolumeSampling grid_over(const Eigen::Vector3d& min,
                                       const Eigen::Vector3d& max, std::size_t most);

/// How the values of a field are drawn.
[[nodiscard]] std::vector<Drawn> drawn_as(const Field& field);

/// "DLF1", the length of a JSON text as 32 bits, the text, filled up to four bytes,
/// then its arrays, little-endian, where the text says, in bytes from its own end:
///
///   {revision, level, summary, leaves,    how many there are; 0: not of an octree
///    values: {at, count}   float32, not a number where it isn't finite
///    mask: {at, count}     uint8, a Drawn each
///    parts: [{name, kind: grid, first, count, origin, step, counts}
///            {…, kind: plane, origin, u, v, counts}
///            {…, kind: points, positions: at}                    float32, 3 each
///            {…, kind: surface, positions, triangles, corners}]}   uint32, 3 each
[[nodiscard]] std::string packed(const DrawnField& drawn, std::size_t revision);

}  // namespace delos::session
