#include "session/drawn_shapes.h"

#include <limits>

#include "session/packing.h"

namespace delos::session {
namespace {

using shapes::ShapeMesh;

/// Makes of each part what it can have of a shape.
struct ShapeMaker {
  const DrawnField& drawn;
  const SamplePart& part;
  const std::atomic<bool>* stop;
  std::vector<ShapeMesh>& meshes;

  void operator()(const LevelShape& level) const {
    if (const auto* grid = std::get_if<GridShape>(&part.shape))
      add(isosurface(grid_values(drawn, part, *grid), level.level, stop));
  }
  void operator()(const BetweenShape& ends) const {
    if (const auto* grid = std::get_if<GridShape>(&part.shape))
      add(body_between(grid_values(drawn, part, *grid), ends.low, ends.high, stop));
  }
  void operator()(const ReliefShape& raised) const {
    const auto add_relief = [&](const shapes::Sheet& sheet) {
      add(relief(
          sheet, [&](std::size_t i) { return drawn_value(drawn, i); }, raised.heights));
    };
    if (const auto* grid = std::get_if<GridShape>(&part.shape); grid && raised.layer)
      add_relief(shapes::layer_of(part, *grid, *raised.layer));
    if (const auto* plane = std::get_if<PlaneShape>(&part.shape);
        plane && !raised.layer)
      add_relief(shapes::sheet_of(part, *plane));
  }

  void add(ShapeMesh mesh) const { meshes.push_back(std::move(mesh)); }
};

std::vector<float> flattened(const std::vector<Eigen::Vector3d>& all) {
  std::vector<float> flat;
  flat.reserve(3 * all.size());
  for (const Eigen::Vector3d& p : all)
    for (int k = 0; k < 3; ++k) flat.push_back(static_cast<float>(p[k]));
  return flat;
}

Json mesh_json(const ShapeMesh& shape, std::size_t which, Arrays& arrays) {
  std::vector<std::uint32_t> corners;
  corners.reserve(3 * shape.mesh.triangles.size());
  for (const auto& t : shape.mesh.triangles)
    corners.insert(corners.end(), t.begin(), t.end());
  return {{"shape", which},
          {"vertices", shape.mesh.vertices.size()},
          {"corners", corners.size()},
          {"caps", 3 * shape.caps},
          {"area", number(shapes::area_of(shape.mesh))},
          {"positions", arrays.add<float>(flattened(shape.mesh.vertices))},
          {"normals", arrays.add<float>(flattened(shape.normals))},
          {"values", arrays.add<float>(shape.values)},
          {"triangles", arrays.add<std::uint32_t>(corners)}};
}

}  // namespace

double drawn_value(const DrawnField& drawn, std::size_t sample) {
  return drawn.mask[sample] == Drawn::value ? drawn.field.value[sample]
                                            : std::numeric_limits<double>::quiet_NaN();
}

shapes::ScalarGrid grid_values(const DrawnField& drawn, const SamplePart& part,
                               const GridShape& grid) {
  shapes::ScalarGrid values{grid, {}};
  values.value.reserve(part.count);
  for (std::size_t i = part.first; i < part.first + part.count; ++i)
    values.value.push_back(drawn_value(drawn, i));
  return values;
}

std::vector<ShapeMesh> shapes_of(const DrawnField& drawn, const FieldShape& shape,
                                 const std::atomic<bool>* stop) {
  std::vector<ShapeMesh> meshes;
  for (const SamplePart& part : drawn.field.samples.parts)
    std::visit(ShapeMaker{drawn, part, stop, meshes}, shape);
  return meshes;
}

shapes::LeafEdges leaves_of(const DrawnField& drawn,
                            const std::optional<shapes::AxisPlane>& near) {
  if (!drawn.leaves) return {};
  const SamplePart& part = drawn.leaves->parts.front();
  return leaf_edges(drawn.leaves->points, part, std::get<OctreeShape>(part.shape),
                    near);
}

std::string packed_shapes(const MadeShapes& made, bool coarse, std::size_t revision) {
  Arrays arrays;
  Json head{{"revision", revision},
            {"level", coarse ? "coarse" : "full"},
            {"meshes", Json::array()},
            {"leaves", nullptr}};
  for (std::size_t k = 0; k < made.meshes.size(); ++k)
    for (const ShapeMesh& shape : made.meshes[k])
      head["meshes"].push_back(mesh_json(shape, k, arrays));
  if (made.leaves)
    head["leaves"] = {{"count", made.leaves->leaves},
                      {"lines", made.leaves->ends.size() / 2},
                      {"positions", arrays.add<float>(flattened(made.leaves->ends))}};
  return packed_text("DLS1", head, arrays);
}

}  // namespace delos::session
