// What a picture of a slice says in words.
#pragma once

#include <string>

#include "delos/field/field.h"
#include "output/slice.h"

namespace delos {

/// A share as people say it: "12 %", "< 1 %", "> 99 %".
[[nodiscard]] std::string share_text(std::size_t part, std::size_t whole);

/// "scene — metric [unit], z = 0.24 m", in two pieces so that a long scene name can
/// give way to what follows.
struct Title {
  std::string scene;  ///< may be empty
  std::string rest;   ///< "metric [unit], z = 0.24 m"
};
[[nodiscard]] Title title_of(const Field& field, const Slice& slice,
                             const std::string& unit, const PictureOptions& options);

/// The whole field in a line: median, 95th percentile, share observable.
[[nodiscard]] std::string subtitle(const Field& field, const PictureOptions& options);

/// What a reader has to know to read the numbers rightly; may be empty.
/// @param to_scale whether both axes have the same scale
[[nodiscard]] std::string footnote(const Field& field, bool to_scale);

/// Why a slice without any finite value is empty.
[[nodiscard]] std::string why_empty(const Slice& slice);

/// The values of the best and the worst sample, with as many digits as tell them apart.
struct ExtremeWords {
  std::string best, worst;
};
/// @pre the slice has a finite value
[[nodiscard]] ExtremeWords extreme_words(const Slice& slice, const std::string& unit);

}  // namespace delos
