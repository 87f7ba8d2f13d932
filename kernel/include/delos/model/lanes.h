// How many poses are worked on side by side, and how their symmetric matrices are
// stored.
#pragma once

namespace delos {

/// Poses are handled this many at a time: one bit a pose in a 64-bit word. Element e of
/// the matrix of pose l stands at [e·kLanes + l].
inline constexpr int kLanes = 64;

/// Index of element (i, j), i ≥ j, of a symmetric matrix stored by its lower triangle,
/// row after row.
[[nodiscard]] constexpr int packed_index(int i, int j) { return i * (i + 1) / 2 + j; }

}  // namespace delos
