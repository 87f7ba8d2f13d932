#include "scene/mesh_keys.h"

#include <Eigen/Geometry>

#include "delos/geometry/defects.h"
#include "delos/text/number_text.h"
#include "delos/text/numbers.h"
#include "document/node_text.h"

namespace delos {
namespace {

/// Rooms of a kilometre are rarer than meshes in millimetres.
constexpr double kLargeRoom = 1000;

std::string counted(std::size_t n, const char* one, const char* several) {
  return grouped(n) + ' ' + (n == 1 ? one : several);
}

std::string open_text(const MeshDefects& d) {
  return d.border_edges > 0
             ? "is open, " + counted(d.border_edges, "edge has", "edges have") +
                   " one triangle only"
             : "has no inside, " +
                   counted(d.non_manifold_edges, "edge has", "edges have") +
                   " an odd number of triangles or more than two";
}

/// What is wrong and what follows from it; empty where all is well.
std::string defects_text(const MeshDefects& d) {
  std::string text;
  const auto add = [&](const std::string& clause) {
    if (!text.empty()) text += "; ";
    text += clause;
  };
  if (!d.closed) add(open_text(d) + ": it hides, but has no inside");
  if (d.closed && d.non_manifold_edges > 0)
    add(counted(d.non_manifold_edges, "edge has", "edges have") +
        " more than two triangles: its inside is where a line out crosses it an odd "
        "number of times");
  if (d.flipped_edges > 0)
    add(counted(d.flipped_edges, "edge has", "edges have") +
        " triangles that don't face the same way: it hides all the same");
  if (d.inverted) add("faces inward: it hides all the same");
  if (d.self_intersections.value_or(0) > 0)
    add(counted(*d.self_intersections, "pair of triangles cuts",
                "pairs of triangles cut") +
        " through each other: it hides all the same");
  if (d.duplicate > 0)
    add(counted(d.duplicate, "triangle is there twice", "triangles are there twice"));
  if (d.degenerate > 0)
    add(counted(d.degenerate, "triangle without area hides",
                "triangles without area hide") +
        " nothing");
  return text;
}

void warn_of_defects(Reader& reader, const Place& at, const MeshShape& shape,
                     const MeshDefects& defects) {
  const std::string text = defects_text(defects);
  if (!text.empty()) reader.warning(at, '\'' + shape.file + "': " + text);
}

/// The file again, where its defects aren't known yet; else null.
MeshFiles::File* unchecked(Reader& reader, const MeshShape& shape) {
  if (!shape.mesh) return nullptr;
  MeshFiles::File& file = reader.meshes.read(reader.folder / shape.file);
  return file.defects_known ? nullptr : &file;
}

}  // namespace

void read_mesh_file(Reader& reader, const Place& at, MeshShape& out) {
  const auto written = reader.word(at);
  if (!written) return;
  out.file = reader.file_name(at, *written);
  const MeshFiles::File& file = reader.meshes.read(reader.folder / out.file);
  if (!file.mesh) reader.error(at, file.problem);
  out.mesh = file.mesh;
}

void read_scale(Reader& reader, const Place& at, MeshShape& out) {
  if (const auto scale = reader.number(at)) out.scale = *scale;
}

void check_mesh_size(Reader& reader, const Place& at, const MeshShape& shape) {
  if (!shape.mesh) return;
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : shape.mesh->vertices) box.extend(shape.scale * p);
  const double extent = box.sizes().maxCoeff();
  if (!std::isfinite(extent))
    reader.error(at, "is beyond the range of a double at this scale");
  else if (extent > kLargeRoom)
    reader.warning(at, '\'' + shape.file + "' extends over " + rounded(extent, 3) +
                           " m; if it is in millimetres, give 'scale: 0.001'");
}

void check_mesh_hides(Reader& reader, const Place& at, const MeshShape& shape) {
  MeshFiles::File* file = unchecked(reader, shape);
  if (!file) return;
  file->defects_known = true;
  warn_of_defects(reader, at, shape, find_defects(*shape.mesh));
}

void check_mesh_room(Reader& reader, const Place& at, const MeshShape& shape) {
  MeshFiles::File* file = unchecked(reader, shape);
  if (!file) return;
  file->defects_known = true;
  MeshDefects defects = find_defects(*shape.mesh);
  defects.inverted = false;
  warn_of_defects(reader, at, shape, defects);
}

void check_mesh_contains(Reader& reader, const Place& at, const MeshShape& shape) {
  if (!shape.mesh) return;
  const MeshDefects defects = find_defects(*shape.mesh);
  if (!defects.closed)
    reader.error(at, '\'' + shape.file + "' " + open_text(defects) +
                         "; nothing is inside of it: close it, or use another body");
  else if (MeshFiles::File* file = unchecked(reader, shape)) {
    file->defects_known = true;
    warn_of_defects(reader, at, shape, defects);
  }
}

std::optional<Node> write_scale(const MeshShape& shape) {
  if (shape.scale == 1) return std::nullopt;
  return to_node(shape.scale);
}

}  // namespace delos
