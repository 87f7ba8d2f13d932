// The formats of calibrations that are known: one file a format.
#pragma once

#include <span>

#include "imports/calibration.h"

namespace delos::imports {

/// A format whose text is a tree of values.
struct CalibrationFormat {
  const char* name;  ///< for people: "a calibration of Qualisys Track Manager"
  /// Whether the file is one, by what it holds.
  bool (*recognises)(const Value& root);
  /// Camera by camera; what is wrong goes to the source.
  void (*read)(const Value& root, const ImportOptions& options, Source& source,
               Calibration& out);
};

/// All of them, those first that are easiest to tell.
[[nodiscard]] std::span<const CalibrationFormat> calibration_formats();

extern const CalibrationFormat kQualisys, kVicon, kMotive, kCaliscope, kPose2Sim,
    kAnipose, kKalibr, kHuman36M, kMrcal, kRos, kEasyMocap, kOpenCv;

/// EasyMocap has one file of lenses and one of places, side by side in a folder.
[[nodiscard]] std::optional<Value> easymocap_whole(const Value& root,
                                                   const std::filesystem::path& file,
                                                   Source& source);

/// cameras.txt and images.txt of a COLMAP model, which are told by their first line.
[[nodiscard]] bool is_colmap(std::string_view text);
void read_colmap(const std::filesystem::path& file, const ImportOptions& options,
                 Source& source, Calibration& out);

}  // namespace delos::imports
