// Source: Kitware, VTK XML file formats,
//         https://docs.vtk.org/en/latest/vtk_file_formats/vtkxml_file_format.html
#include "output/vtk.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <ostream>

#include "delos/text/number_text.h"
#include "output/base64.h"

namespace delos {
namespace {

/// One DataArray element. `fill` adds `count` numbers of `bytes` bytes each.
template <typename Fill>
void data_array(std::ostream& out, const std::string& attributes, std::size_t count,
                std::size_t bytes, const Fill& fill) {
  out << "        <DataArray " << attributes << " format=\"binary\">";
  Base64Stream data(out);
  data.add_little_endian(std::uint64_t{count * bytes});
  fill(data);
  data.finish();
  out << "</DataArray>\n";
}

void add_double(Base64Stream& data, double value) {
  data.add_little_endian(std::bit_cast<std::uint64_t>(value));
}

std::string three(const double* numbers) {
  std::string text;
  for (int i = 0; i < 3; ++i) {
    if (i > 0) text += ' ';
    append_number(text, numbers[i]);
  }
  return text;
}

void open_file(std::ostream& out, const char* type) {
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"" << type
      << "\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n";
}

void point_data(const Field& field, std::ostream& out) {
  const std::string name = xml_attribute(field.metric + " [" + field.unit + "]");
  const std::size_t n = field.value.size();
  out << "      <PointData Scalars=\"" << name << "\">\n";
  data_array(out, "type=\"Float64\" Name=\"" + name + "\"", n, 8, [&](auto& data) {
    // ParaView paints NaN in a colour of its own; an infinity would spoil its ranges.
    for (const double value : field.value)
      add_double(data, std::isfinite(value) ? value
                                            : std::numeric_limits<double>::quiet_NaN());
  });
  data_array(out, "type=\"UInt8\" Name=\"observable\"", n, 1, [&](auto& data) {
    for (const unsigned char seen : field.observable) data.add(seen != 0);
  });
  if (!field.lost.empty()) {
    data_array(out, "type=\"UInt8\" Name=\"lost directions\"", n, 1, [&](auto& data) {
      for (const unsigned char lost : field.lost) data.add(lost);
    });
  }
  if (!field.inside.empty()) {
    data_array(out, "type=\"UInt8\" Name=\"inside a solid\"", n, 1, [&](auto& data) {
      for (const unsigned char inside : field.inside) data.add(inside);
    });
  }
  if (field.samples.parts.size() > 1) {
    data_array(out, "type=\"Int32\" Name=\"part\"", n, 4, [&](auto& data) {
      std::uint32_t number = 0;
      for (const SamplePart& part : field.samples.parts) {
        for (std::size_t i = 0; i < part.count; ++i) data.add_little_endian(number);
        ++number;
      }
    });
  }
  out << "      </PointData>\n";
}

/// Cells of `size` corners each.
void cells(std::ostream& out, const char* element,
           const std::vector<std::uint64_t>& corners, std::size_t size) {
  out << "      <" << element << ">\n";
  data_array(out, "type=\"Int64\" Name=\"connectivity\"", corners.size(), 8,
             [&](auto& data) {
               for (const std::uint64_t corner : corners)
                 data.add_little_endian(corner);
             });
  data_array(out, "type=\"Int64\" Name=\"offsets\"", corners.size() / size, 8,
             [&](auto& data) {
               for (std::uint64_t end = size; end <= corners.size(); end += size)
                 data.add_little_endian(end);
             });
  out << "      </" << element << ">\n";
}

void write_points(const Field& field, std::ostream& out) {
  const std::vector<Eigen::Vector3d>& points = field.samples.points;
  out << "      <Points>\n";
  data_array(out, "type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"",
             3 * points.size(), 8, [&](auto& data) {
               for (const Eigen::Vector3d& point : points)
                 for (const double coordinate : point) add_double(data, coordinate);
             });
  out << "      </Points>\n";
}

}  // namespace

void write_vti(const Field& field, std::ostream& out) {
  const auto& grid = std::get<GridShape>(field.samples.parts.front().shape);
  std::string extent;
  for (const std::int64_t count : grid.counts)
    extent += (extent.empty() ? "0 " : " 0 ") + std::to_string(count - 1);

  open_file(out, "ImageData");
  out << "  <ImageData WholeExtent=\"" << extent << "\" Origin=\""
      << three(grid.origin.data()) << "\" Spacing=\"" << three(grid.step.data())
      << "\">\n    <Piece Extent=\"" << extent << "\">\n";
  point_data(field, out);
  out << "    </Piece>\n  </ImageData>\n</VTKFile>\n";
}

void write_vtp(const Field& field, std::ostream& out) {
  const std::size_t n = field.samples.points.size();
  // A vertex of a mesh is drawn by its triangles, any other sample as a dot.
  std::vector<std::uint64_t> dots, corners;
  for (const SamplePart& part : field.samples.parts) {
    if (const auto* surface = std::get_if<SurfaceShape>(&part.shape)) {
      for (const auto& triangle : surface->triangles)
        for (const std::uint32_t corner : triangle)
          corners.push_back(part.first + corner);
    } else {
      for (std::size_t i = 0; i < part.count; ++i) dots.push_back(part.first + i);
    }
  }
  open_file(out, "PolyData");
  out << "  <PolyData>\n    <Piece NumberOfPoints=\"" << n << "\" NumberOfVerts=\""
      << dots.size() << "\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\""
      << corners.size() / 3 << "\">\n";
  point_data(field, out);
  write_points(field, out);
  cells(out, "Verts", dots, 1);
  cells(out, "Polys", corners, 3);
  out << "    </Piece>\n  </PolyData>\n</VTKFile>\n";
}

void write_vtu(const Field& field, std::ostream& out) {
  constexpr unsigned char kVoxel = 11;  // its corners run as those of OctreeShape
  const auto& octree = std::get<OctreeShape>(field.samples.parts.front().shape);
  const std::size_t count = octree.cells.size();
  std::vector<std::uint64_t> corners;
  for (const auto& cell : octree.cells)
    corners.insert(corners.end(), cell.begin(), cell.end());
  open_file(out, "UnstructuredGrid");
  out << "  <UnstructuredGrid>\n    <Piece NumberOfPoints=\""
      << field.samples.points.size() << "\" NumberOfCells=\"" << count << "\">\n";
  point_data(field, out);
  out << "      <CellData Scalars=\"level\">\n";
  data_array(out, "type=\"Int32\" Name=\"level\"", count, 4, [&](auto& data) {
    for (const int level : octree.levels)
      data.add_little_endian(static_cast<std::uint32_t>(level));
  });
  out << "      </CellData>\n";
  write_points(field, out);
  out << "      <Cells>\n";
  data_array(out, "type=\"Int64\" Name=\"connectivity\"", 8 * count, 8,
             [&](auto& data) {
               for (const std::uint64_t corner : corners)
                 data.add_little_endian(corner);
             });
  data_array(out, "type=\"Int64\" Name=\"offsets\"", count, 8, [&](auto& data) {
    for (std::uint64_t c = 1; c <= count; ++c) data.add_little_endian(8 * c);
  });
  data_array(out, "type=\"UInt8\" Name=\"types\"", count, 1, [&](auto& data) {
    for (std::size_t c = 0; c < count; ++c) data.add(kVoxel);
  });
  out << "      </Cells>\n    </Piece>\n  </UnstructuredGrid>\n</VTKFile>\n";
}

}  // namespace delos
