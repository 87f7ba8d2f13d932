#include <algorithm>
#include <cmath>
#include <string>

#include "delos/text/number_text.h"
#include "output/picture_words.h"
#include "output/shading.h"
#include "output/write.h"

namespace delos {
namespace {

/// Size of the picture in characters, each of which holds two dots, one above the
/// other.
struct TerminalSize {
  int columns, lines;
};

/// The slice's proportions within the width and a third of it in lines. A character is
/// about twice as high as wide.
TerminalSize terminal_size(const Slice& slice, int columns) {
  const double width = std::max(columns, 8);
  const double most_dots = 2 * std::max(4.0, std::floor(width * 0.3));
  const double shape = slice.axis[1].span() / slice.axis[0].span();
  const double across = std::min(width, std::round(most_dots / shape));
  const double dots = std::min(most_dots, std::round(across * shape));
  return {static_cast<int>(std::max(across, 4.0)),
          static_cast<int>(std::max(std::ceil(dots / 2), 1.0))};
}

std::string colour_code(const char* which, const Rgb& colour) {
  std::string code = std::string{"\x1b["} + which + ";2";
  for (const double value : {colour.r, colour.g, colour.b})
    code.append(1, ';').append(std::to_string(std::lround(255 * value)));
  return code + "m";
}

constexpr const char* kReset = "\x1b[0m";
constexpr Rgb kBlind{0.35, 0.35, 0.35};

/// One character of two dots, the upper one as its ink and the lower as its paper.
std::string dots_in_colour(const Shade& upper, const Shade& lower,
                           const ColourScale& scale) {
  if (upper.fill != Fill::colour && lower.fill != Fill::colour)
    return std::string{kReset} + colour_code("38", kBlind) + "·";
  const auto colour = [&](const Shade& shade) {
    return shade.fill == Fill::colour ? scale.colour(shade.position) : kBlind;
  };
  return colour_code("38", colour(upper)) + colour_code("48", colour(lower)) + "▀";
}

std::string shade_of_ink(double brightness) {
  static constexpr std::string_view kRamp = ":-=+*#%@";
  const auto step = static_cast<std::size_t>(brightness * kRamp.size());
  return std::string(1, kRamp[std::min(step, kRamp.size() - 1)]);
}

/// What is shown and what the colours mean: the low value, the scale, the high one.
std::string legend(const Field& field, const Slice& slice, const ColourScale& scale,
                   bool colour) {
  std::string text = title_of(field, slice, "", {}).rest + "\n";
  if (!slice.best) return text + why_empty(slice) + "\n";
  const ExtremeWords words = extreme_words(slice, field.unit);
  if (scale.flat()) {
    text += words.best;
    if (slice.finite == slice.value.size()) text += " everywhere";
  } else {
    constexpr int kSteps = 12;
    text += (scale.bright_high ? words.worst : words.best) + " ";
    for (int i = 0; i < kSteps; ++i) {
      const double position = (i + 0.5) / kSteps;
      if (colour)
        text += colour_code("38", scale.colour(position)) + "█";
      else
        text += shade_of_ink(scale.bright_high ? position : 1 - position);
    }
    if (colour) text += kReset;
    text += " " + (scale.bright_high ? words.best : words.worst);
    if (scale.log10) text += " (log)";
  }
  const auto solid =
      static_cast<std::size_t>(std::count(slice.solid.begin(), slice.solid.end(), 1));
  const std::size_t blind = slice.value.size() - slice.finite - solid;
  if (blind > 0) {
    text += field.cancelled ? "   · blind or not evaluated " : "   · blind ";
    text += share_text(blind, slice.value.size());
  }
  return text + "\n";
}

}  // namespace

std::string terminal_picture(const Field& field, int columns, bool colour,
                             const PictureOptions& picture) {
  if (!has_slice(field.samples)) return {};
  const Slice slice = make_slice(field, picture);
  const ColourScale scale = make_scale(slice, picture);
  const ShadedSlice shaded(slice, scale);
  const TerminalSize size = terminal_size(slice, columns);

  const auto shade = [&](int character, double line) {
    return shaded.at(slice.axis[0].sample_at((character + 0.5) / size.columns),
                     slice.axis[1].sample_at(1 - line / size.lines));
  };
  std::string text;
  for (int line = 0; line < size.lines; ++line) {
    for (int character = 0; character < size.columns; ++character) {
      if (colour) {
        text += dots_in_colour(shade(character, line + 0.25),
                               shade(character, line + 0.75), scale);
        continue;
      }
      const Shade middle = shade(character, line + 0.5);
      text +=
          middle.fill == Fill::colour
              ? shade_of_ink(scale.bright_high ? middle.position : 1 - middle.position)
              : "·";
    }
    if (colour) text += kReset;
    text += '\n';
  }
  return text + legend(field, slice, scale, colour);
}

}  // namespace delos
