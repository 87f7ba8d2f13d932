// Fields as VTK XML files, for ParaView and its relatives.
#pragma once

#include <iosfwd>

#include "delos/field/field.h"

namespace delos {

/// ImageData (.vti): the samples are the points of the grid.
///
/// Point data: "<metric> [<unit>]", Float64, NaN where it isn't finite, and
/// "observable", UInt8. Arrays are inline base64 of a UInt64 length and the
/// little-endian numbers.
/// @pre the samples are one volume
void write_vti(const Field& field, std::ostream& out);

/// PolyData (.vtp): the triangles of meshes, and a vertex for each other sample, with
/// the same arrays. Where there are several sample sets, Int32 "part" numbers them from
/// 0.
void write_vtp(const Field& field, std::ostream& out);

/// UnstructuredGrid (.vtu): the leaves of an octree as voxels over its nodes, with the
/// same arrays and each leaf's "level".
/// @pre the samples are one octree
void write_vtu(const Field& field, std::ostream& out);

}  // namespace delos
