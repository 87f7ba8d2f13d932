// Where something was, frame by frame, as a motion capture system wrote it to a file.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "delos/document/diagnostic.h"

namespace delos::recordings {

/// One marker or body.
struct Track {
  std::string name;
  /// A row a frame: x, y, z in metres; NaN where it wasn't seen.
  Eigen::Matrix<double, Eigen::Dynamic, 3> at;
};

/// Tracks of one clock.
struct Recording {
  double period = 0;  ///< seconds between frames, > 0
  std::vector<Track> tracks;
};

struct ReadOptions {
  double rate = 0;  ///< frames a second of files that say no times; 0: not given
  double unit = 0;  ///< metres, of files that say no unit of length; 0: not given
};

/// Read a recording; what the suffix says is how:
///
///     .bvh   the joints of a figure; its unit of length isn't in the file: `unit`
///     .c3d   points as integers or reals, of PC, DEC and SGI processors
///     .csv   a head with names and units, such as "t [s],x [mm],y [mm],z [mm]"; of
///            several tracks "hand.x [m]"; without t, `rate` counts. Or as Motive
///            exports it: bodies, bones and markers
///     .trc   Track Row Column, with tabs or commas
///     .tum   t x y z, and a quaternion that isn't read; # begins a comment
///
/// Axes are those of the file: of BVH, TRC and Motive y points up. Frames that are
/// missing in evenly spaced times become gaps. Findings are appended.
/// @returns nullopt where one of them is an error
[[nodiscard]] std::optional<Recording> read_recording(const std::filesystem::path& file,
                                                      const ReadOptions& options,
                                                      Diagnostics& findings);

}  // namespace delos::recordings
