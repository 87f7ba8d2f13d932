// A field in its room as a picture in three dimensions.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/eye.h"
#include "session/drawn_field.h"
#include "session/surface_through.h"

namespace delos::render {

/// A layer of a grid.
struct Slice {
  int axis = 2;                   ///< 0, 1, 2: across x, y, z
  std::optional<double> at = {};  ///< metres; the nearest layer; by default the middle
};

/// What is drawn, and how.
struct PictureOptions {
  View view;
  int width = 1280, height = 720;  ///< pixels
  std::vector<Slice> slices;
  std::vector<double> levels;               ///< of isosurfaces, SI
  std::optional<session::Through> through;  ///< a surface through scattered samples
  bool log10 = false;
  bool dark = false;  ///< on a dark ground
  bool devices = true, frusta = true, names = true, bodies = true, beacons = true,
       floor = true, box = true;
};

/// A surface at a level, as it was drawn.
struct DrawnLevel {
  double level = 0;  ///< SI
  double area = 0;   ///< m²
};

struct Picture {
  int width = 0, height = 0;          ///< pixels
  std::vector<unsigned char> pixels;  ///< rows from the top: red, green, blue
  /// What the colour bar runs from and to, SI; none where no sample has a value.
  std::optional<std::pair<double, double>> range;
  std::vector<DrawnLevel> levels;
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
///         to cut, or that a logarithm is asked of what isn't positive; as
///         surface_through()
[[nodiscard]] Picture render_picture(const session::LoadedScene& loaded,
                                     const session::DrawnField& drawn,
                                     const PictureOptions& options);

/// The bytes of a PNG file.
[[nodiscard]] std::string png_of(const Picture& picture);

}  // namespace delos::render
