#include "shapes/relief.h"

#include <cmath>

namespace delos::shapes {

double Heights::of(double value) const {
  if (!(high > low)) return 0;
  return size * (log10 ? std::log(value / low) / std::log(high / low)
                       : (value - low) / (high - low));
}

ShapeMesh relief(const Sheet& sheet, const std::function<double(std::size_t)>& value,
                 const Heights& heights) {
  ShapeMesh shape;
  const auto place = [&](int i, int j) {
    return static_cast<std::size_t>(i) +
           static_cast<std::size_t>(j) * static_cast<std::size_t>(sheet.nu);
  };
  std::vector<std::uint32_t> vertex(place(0, sheet.nv));
  std::vector<bool> there(vertex.size());
  for (int j = 0; j < sheet.nv; ++j)
    for (int i = 0; i < sheet.nu; ++i) {
      const double v = value(sheet.index(i, j));
      if (!std::isfinite(v)) continue;
      there[place(i, j)] = true;
      vertex[place(i, j)] = static_cast<std::uint32_t>(shape.values.size());
      shape.mesh.vertices.emplace_back(sheet.at(i, j) + heights.of(v) * sheet.up);
      shape.values.push_back(v);
    }
  const bool right_handed = sheet.u.cross(sheet.v).dot(sheet.up) > 0;
  for (int j = 0; j + 1 < sheet.nv; ++j)
    for (int i = 0; i + 1 < sheet.nu; ++i) {
      std::size_t a = place(i + 1, j), b = place(i, j + 1);
      const std::size_t first = place(i, j), last = place(i + 1, j + 1);
      if (!there[first] || !there[a] || !there[b] || !there[last]) continue;
      if (!right_handed) std::swap(a, b);
      shape.mesh.triangles.push_back({vertex[first], vertex[a], vertex[last]});
      shape.mesh.triangles.push_back({vertex[first], vertex[last], vertex[b]});
    }
  shape.caps = shape.mesh.triangles.size();
  set_normals(shape);
  return shape;
}

}  // namespace delos::shapes
