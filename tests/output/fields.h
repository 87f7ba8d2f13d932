// Small fields and files for the tests of the output room.
#pragma once

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "delos/field/field.h"
#include "support/folder.h"

namespace delos {

using test::Folder;

inline constexpr double kBlind = std::numeric_limits<double>::infinity();

/// Add a part to a field; observable exactly where the value is finite.
inline void add_part(Field& field, SamplePart part,
                     const std::vector<Eigen::Vector3d>& points,
                     const std::vector<double>& values) {
  part.first = field.value.size();
  part.count = values.size();
  field.samples.parts.push_back(std::move(part));
  field.samples.points.insert(field.samples.points.end(), points.begin(), points.end());
  for (const double value : values) {
    field.value.push_back(value);
    field.observable.push_back(std::isfinite(value) ? 1 : 0);
  }
  field.evaluations = field.evaluated = field.value.size();
}

inline Field empty_field() {
  Field field;
  field.scene = std::string("test");
  field.metric = std::string("eigmax");
  field.unit = std::string("m");
  return field;
}

/// One volume; `value` is asked at every point.
template <typename Value>
Field volume(const GridShape& grid, const Value& value) {
  std::vector<Eigen::Vector3d> points;
  std::vector<double> values;
  for (int k = 0; k < grid.counts[2]; ++k)
    for (int j = 0; j < grid.counts[1]; ++j)
      for (int i = 0; i < grid.counts[0]; ++i) {
        points.push_back(grid.origin +
                         grid.step.cwiseProduct(Eigen::Vector3d(i, j, k)));
        values.push_back(value(points.back()));
      }
  Field field = empty_field();
  add_part(field, {"", 0, 0, grid}, points, values);
  return field;
}

/// One plane, likewise.
template <typename Value>
Field plane(const PlaneShape& shape, const Value& value) {
  std::vector<Eigen::Vector3d> points;
  std::vector<double> values;
  const auto part = [](int i, int count) { return count > 1 ? i / (count - 1.0) : 0; };
  for (int j = 0; j < shape.counts[1]; ++j)
    for (int i = 0; i < shape.counts[0]; ++i) {
      points.push_back(shape.origin + part(i, shape.counts[0]) * shape.u +
                       part(j, shape.counts[1]) * shape.v);
      values.push_back(value(points.back()));
    }
  Field field = empty_field();
  add_part(field, {"", 0, 0, shape}, points, values);
  return field;
}

/// Scattered samples along x at 0, 1, 2, … metres.
inline Field scattered(const std::vector<double>& values) {
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i < values.size(); ++i)
    points.emplace_back(static_cast<double>(i), 0.5, -0.25);
  Field field = empty_field();
  add_part(field, {"", 0, 0, ScatteredShape{}}, points, values);
  return field;
}

inline std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

inline void write_bytes(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

}  // namespace delos
