#include "render/picture.h"

#include <algorithm>

#include "render/cloud.h"
#include "render/legend.h"
#include "session/description.h"
#include "session/refusal.h"

namespace delos::render {
namespace {

std::optional<ColourRange> colours_of(const session::DrawnField& drawn, bool log10) {
  const auto& low = drawn.summary.at("min");
  if (low.is_null()) return std::nullopt;
  ColourRange range;
  range.low = low.at("value");
  range.high = drawn.summary.at("max").at("value");
  range.larger_is_better = drawn.field.larger_is_better;
  range.log10 = log10;
  if (log10 && !(range.low > 0))
    throw session::Refusal(session::Blame::question,
                           "log10: " + drawn.field.metric +
                               " isn't positive everywhere; leave --log10 out");
  return range;
}

Frame frame_of(const PictureOptions& options) {
  return {options.width, options.height,
          std::max(options.width - kLegend, options.width / 2)};
}

/// Values of shapes that lie on the bar.
std::vector<double> marks_of(const std::vector<DrawnShape>& shapes,
                             const std::optional<ColourRange>& colours) {
  std::vector<double> marks;
  for (const DrawnShape& shape : shapes)
    for (const double end : {shape.low, shape.high})
      if (end >= colours->low && end <= colours->high) marks.push_back(end);
  return marks;
}

}  // namespace

Eye eye_of(const session::LoadedScene& loaded, const PictureOptions& options, int finer,
           const Eigen::AlignedBox3d& more) {
  Eigen::AlignedBox3d room = session::room_box(loaded);
  for (const Slice& slice : options.slices)
    if (options.reliefs && slice.at) {
      Eigen::Vector3d peak = room.center();
      peak[slice.axis] = *slice.at + options.relief_height;
      room.extend(peak);
    }
  room.extend(more);
  // Icons and the floor reach a little beyond.
  const Eigen::Vector3d margin =
      Eigen::Vector3d::Constant(0.04 * room.diagonal().norm() + 1e-6);
  room.extend(Eigen::Vector3d(room.min() - margin));
  room.extend(Eigen::Vector3d(room.max() + margin));
  const Frame shown = frame_of(options);
  return {options.view, room,
          Frame{finer * shown.width, finer * shown.height, finer * shown.free}};
}

Picture render_picture(const session::LoadedScene& loaded,
                       const session::DrawnField& drawn,
                       const PictureOptions& options) {
  const Ground& ground = options.dark ? kDark : kLight;
  Raster raster(frame_of(options), ground.background);
  std::optional<session::DrawnField> through;
  Eigen::AlignedBox3d more;
  if (options.through) {
    through = session::surface_through(drawn, *options.through);
    for (const Eigen::Vector3d& p : through->field.samples.points) more.extend(p);
  }
  const Eye eye = eye_of(loaded, options, Raster::kFiner, more);
  const Pen pen{raster, eye, ground};
  const std::optional<ColourRange> colours = colours_of(drawn, options.log10);

  Picture picture;
  picture.shapes = draw_field_layer(pen, drawn, colours, options);
  if (through) {
    draw_through(pen, *through, colours);
    picture.through = through->summary.at("through");
  }
  const std::vector<Label> names = draw_room_layer(pen, loaded, options);
  if (options.cloud && colours) draw_cloud(pen, drawn, *colours);
  picture.width = options.width;
  picture.height = options.height;
  picture.pixels = raster.bytes();
  if (colours) picture.range = {colours->low, colours->high};

  const auto count = [&](session::Drawn what) {
    return static_cast<std::size_t>(std::ranges::count(drawn.mask, what));
  };
  const std::size_t blind = count(session::Drawn::blind);
  draw_legend(picture, ground,
              {loaded.scene.name, drawn.field.metric, drawn.field.unit, blind,
               blind + count(session::Drawn::value)},
              colours, marks_of(picture.shapes, colours), names);
  return picture;
}

}  // namespace delos::render
