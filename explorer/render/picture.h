// A field in its room as a picture in three dimensions.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/eye.h"
#include "session/drawn_field.h"
#include "session/surface_through.h"
#include "shapes/sheet.h"

namespace delos::render {

/// A layer of a grid.
using Slice = shapes::AxisPlane;

/// What is drawn, and how.
struct PictureOptions {
  View view;
  int width = 1280, height = 720;  ///< pixels
  std::vector<Slice> slices;
  bool reliefs = false;        ///< slices and planes are as high as their values
  double relief_height = 1;    ///< of the end of the colour bar, metres
  std::vector<double> levels;  ///< of isosurfaces, SI
  std::vector<std::pair<double, double>> between;  ///< least and greatest of bodies, SI
  bool cloud = false;  ///< grids throughout their volume, by cloud.h
  std::optional<session::Through> through;  ///< a surface through scattered samples
  bool log10 = false;
  bool dark = false;  ///< on a dark ground
  bool devices = true, frusta = true, names = true, bodies = true, beacons = true,
       floor = true, box = true;
  bool cells = false;  ///< of an octree: those that slices cut, or all
};

/// A surface at a level, or a body between two, as it was drawn.
struct DrawnShape {
  double low = 0, high = 0;  ///< SI; of a surface the same
  double area = 0;           ///< m²
  double volume = 0;         ///< m³; of a surface 0
};

struct Picture {
  int width = 0, height = 0;          ///< pixels
  std::vector<unsigned char> pixels;  ///< rows from the top: red, green, blue
  /// What the colour bar runs from and to, SI; none where no sample has a value.
  std::optional<std::pair<double, double>> range;
  std::vector<DrawnShape> shapes;
  session::Json through;  ///< of the surface through scattered samples, or null
};

/// Where a picture of a room is looked at from; all that it draws is in it.
/// @param finer pixels of the eye's frame, along a side of one that is shown
/// @param more what is drawn beside the room, metres; may be empty
[[nodiscard]] Eye eye_of(const session::LoadedScene& loaded,
                         const PictureOptions& options, int finer = 1,
                         const Eigen::AlignedBox3d& more = {});

/// Draw a scene and its field. What hides is opaque, but for the walls of a room, which
/// are lines. Blind is hatched, what is within a solid plain grey.
/// @param drawn as draw_field()
/// @throws session::Refusal that a level lies outside the field, that there is no grid
///         to cut or no octree, or that a logarithm is asked of what isn't positive; as
///         surface_through()
[[nodiscard]] Picture render_picture(const session::LoadedScene& loaded,
                                     const session::DrawnField& drawn,
                                     const PictureOptions& options);

/// The bytes of a PNG file.
[[nodiscard]] std::string png_of(const Picture& picture);

}  // namespace delos::render
