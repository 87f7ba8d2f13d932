// Fields as files, by suffix: .vti .vtu .vtp .csv .json .png.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "delos/field/field.h"
#include "output/marker.h"

namespace delos {

/// How a picture shows a field.
struct PictureOptions {
  bool log10 = false;  ///< colours follow log10 of the value
  double slice_z = 0;  ///< height of the slice through a volume, metres; nearest layer
  /// Statistics of all that the picture is a part of; by default, those of the field.
  std::optional<FieldStatistics> whole;
  bool has_slice = false;         ///< false: the slice through the best sample
  bool larger_is_better = false;  ///< turns the colours round: bright is always good
  /// Values are changes of a metric: blue is better, white none, red worse.
  bool change = false;
  /// What the colours run over, SI, where several pictures share them; by default what
  /// the slice has.
  std::optional<std::pair<double, double>> range;
  std::vector<Marker> devices;  ///< to draw where they are near the slice
};

/// Write a field in the format of the file's suffix. Written beside the target under a
/// temporary name and then renamed, so that a failure leaves what was there.
///
///   .vti  regular grid for ParaView; needs exactly one volume; a blind value is NaN
///   .vtu  the octree of adaptive samples for ParaView; likewise
///   .vtp  points for ParaView; any samples; likewise
///   .csv  x,y,z,value,observable with a header; a blind value is empty
///   .json field_json() with "columns" and "values": [[x, y, z, value, observable], …];
///         a blind value is null
///   .png  a slice with a colour bar; needs a volume or a plane
///
/// @returns empty, or a sentence that says why it was not written and what would be
/// right.
[[nodiscard]] std::string write_field(const Field& field,
                                      const std::filesystem::path& file,
                                      const PictureOptions& picture = {});

/// Write a text as it is, whole or not at all, as write_field() does.
/// @returns empty, or a sentence that says why it was not written
[[nodiscard]] std::string write_text(const std::filesystem::path& file,
                                     std::string_view text);

/// Empty where write_field() knows the suffix and can show this field; else why not.
/// Asked before a long evaluation.
[[nodiscard]] std::string writable(const Samples& samples,
                                   const std::filesystem::path& file);

/// The field as the contract's JSON document (`field --json`), indented, one newline at
/// the end. Non-finite numbers never appear.
[[nodiscard]] std::string field_json(const Field& field);

/// A small picture of a slice for a terminal: half blocks in 24-bit colour, or shades
/// of plain characters where `colour` is false. Lines end in newlines.
/// @param columns width available, characters
/// @returns empty where no volume or plane is among the samples
[[nodiscard]] std::string terminal_picture(const Field& field, int columns, bool colour,
                                           const PictureOptions& picture = {});

}  // namespace delos
