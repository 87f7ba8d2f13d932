// C3D, of motion capture laboratories: blocks of 512 bytes, a head, parameters with
// names, frames of points and of analog samples, in the numbers of one of three
// processors.
//
// Source: The C3D File Format User Guide, Motion Lab Systems (2008).
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>

#include "delos/text/units.h"
#include "recordings/lines.h"

namespace delos::recordings {
namespace {

constexpr std::size_t kBlock = 512;

enum class Processor { pc = 84, dec = 85, sgi = 86 };

/// The bytes as numbers of a processor. What lies beyond the end reads as 0.
struct Numbers {
  std::string_view bytes;
  Processor processor = Processor::pc;

  [[nodiscard]] unsigned byte(std::size_t at) const {
    return at < bytes.size() ? static_cast<unsigned char>(bytes[at]) : 0;
  }
  [[nodiscard]] std::uint16_t word(std::size_t at) const {
    const unsigned first = byte(at), second = byte(at + 1);
    return static_cast<std::uint16_t>(
        processor == Processor::sgi ? first << 8 | second : second << 8 | first);
  }
  [[nodiscard]] int integer(std::size_t at) const {
    return static_cast<std::int16_t>(word(at));
  }
  /// Two words: a DEC has the high one first, and an exponent that is greater by 2.
  [[nodiscard]] double real(std::size_t at) const {
    const std::uint32_t first = word(at), second = word(at + 2);
    const bool high_first = processor != Processor::pc;
    const float value =
        std::bit_cast<float>(high_first ? first << 16 | second : second << 16 | first);
    return processor == Processor::dec ? value / 4.0 : value;
  }
};

struct Parameter {
  int bytes = 0;  // of an element: −1 a character, 1, 2 an integer, 4 a real
  std::vector<std::size_t> sizes;
  std::size_t at = 0;
};

/// "POINT:RATE" and so on.
using Parameters = std::map<std::string, Parameter>;

std::string upper(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return out;
}

/// Entries one after another: length of the name, number of the group (negative where
/// it is a group itself), name, way to the next entry, then the value.
Parameters parameters_of(const Numbers& file, std::size_t at) {
  std::map<int, std::string> groups;
  std::vector<std::pair<int, std::pair<std::string, Parameter>>> found;
  while (at + 4 < file.bytes.size()) {
    const auto name_length = static_cast<std::size_t>(
        std::abs(static_cast<int>(static_cast<signed char>(file.byte(at)))));
    const int group = static_cast<signed char>(file.byte(at + 1));
    if (name_length == 0 || group == 0) break;
    if (at + 2 + name_length > file.bytes.size()) break;
    const std::string name = upper(file.bytes.substr(at + 2, name_length));
    const std::size_t way = at + 2 + name_length;
    if (group < 0) {
      groups[-group] = name;
    } else {
      Parameter p;
      p.bytes = static_cast<signed char>(file.byte(way + 2));
      const unsigned dimensions = file.byte(way + 3);
      for (unsigned d = 0; d < std::min(dimensions, 7u); ++d)
        p.sizes.push_back(file.byte(way + 4 + d));
      p.at = way + 4 + dimensions;
      found.emplace_back(group, std::pair(name, p));
    }
    const std::size_t next = file.word(way);
    if (next == 0) break;
    at = way + next;
  }
  Parameters parameters;
  for (const auto& [group, entry] : found)
    parameters.emplace(groups[group] + ":" + entry.first, entry.second);
  return parameters;
}

/// The first element of a parameter, of whichever kind. Counts beyond 32,767 stand in
/// integers as if these had no sign.
std::optional<double> number_in(const Numbers& file, const Parameters& parameters,
                                const char* name) {
  const auto found = parameters.find(name);
  if (found == parameters.end()) return std::nullopt;
  const auto& [bytes, sizes, at] = found->second;
  if (bytes == 4) return file.real(at);
  if (bytes == 2) return file.word(at);
  return std::nullopt;
}

/// Frames are counted in the head to 65,535, and by later programs elsewhere.
double frames_of(const Numbers& file, const Parameters& parameters) {
  const auto field = [&](const char* name) -> std::optional<double> {
    const auto found = parameters.find(name);
    if (found == parameters.end() || found->second.bytes != 2) return std::nullopt;
    return file.word(found->second.at) + 65536.0 * file.word(found->second.at + 2);
  };
  const auto first = field("TRIAL:ACTUAL_START_FIELD"),
             last = field("TRIAL:ACTUAL_END_FIELD");
  if (first && last && *last >= *first) return *last - *first + 1;
  const double head = static_cast<double>(file.word(8)) - file.word(6) + 1;
  const double said = number_in(file, parameters, "POINT:FRAMES").value_or(0);
  return std::isfinite(said) ? std::max(head, std::floor(said)) : head;
}

std::vector<std::string> texts_in(const Numbers& file, const Parameters& parameters,
                                  const std::string& name) {
  std::vector<std::string> texts;
  const auto found = parameters.find(name);
  if (found == parameters.end() || found->second.bytes != -1) return texts;
  const auto& [bytes, sizes, at] = found->second;
  const std::size_t length = sizes.empty() ? 1 : sizes[0],
                    count = sizes.size() < 2 ? 1 : sizes[1];
  for (std::size_t i = 0; i < count && at + (i + 1) * length <= file.bytes.size();
       ++i) {
    std::string_view text = file.bytes.substr(at + i * length, length);
    text = text.substr(0, text.find('\0'));
    text = text.substr(0, text.find_last_not_of(' ') + 1);
    texts.emplace_back(text);
  }
  return texts;
}

/// As many names as points: of POINT:LABELS, LABELS2, …, of 255 each.
std::vector<std::string> names_of(const Numbers& file, const Parameters& parameters,
                                  std::size_t points) {
  std::vector<std::string> labels;
  for (int part = 1; labels.size() < points; ++part) {
    const std::string name = "POINT:LABELS" + (part > 1 ? std::to_string(part) : "");
    const auto more = texts_in(file, parameters, name);
    if (more.empty()) break;
    labels.insert(labels.end(), more.begin(), more.end());
  }
  std::vector<std::string> names;
  for (std::size_t p = 0; p < points; ++p)
    names.push_back(p < labels.size() && !labels[p].empty()
                        ? labels[p]
                        : "point " + std::to_string(p + 1));
  return distinct(std::move(names));
}

}  // namespace

std::optional<Recording> read_c3d(std::string_view bytes, const std::string& file,
                                  const ReadOptions& options, Diagnostics& findings) {
  const auto refuse = [&](std::string problem) -> std::optional<Recording> {
    findings.push_back({{file, 0, 0}, Severity::error, std::move(problem)});
    return std::nullopt;
  };
  Numbers numbers{bytes};
  if (bytes.size() < 2 * kBlock || numbers.byte(1) != 0x50 || numbers.byte(0) == 0)
    return refuse("doesn't begin as a C3D file does");
  const std::size_t begin = (numbers.byte(0) - 1) * kBlock;
  const unsigned processor = numbers.byte(begin + 3);
  if (processor < 84 || processor > 86)
    return refuse("its parameters are of processor " + std::to_string(processor) +
                  "; known: 84 (PC), 85 (DEC), 86 (SGI)");
  numbers.processor = static_cast<Processor>(processor);
  const Parameters parameters = parameters_of(numbers, begin + 4);

  const std::size_t points = numbers.word(2), analog = numbers.word(4);
  const double rate =
      number_in(numbers, parameters, "POINT:RATE").value_or(numbers.real(20));
  const double scale =
      number_in(numbers, parameters, "POINT:SCALE").value_or(numbers.real(12));
  const double count = frames_of(numbers, parameters);
  const double block =
      number_in(numbers, parameters, "POINT:DATA_START").value_or(numbers.word(16));
  if (points == 0) return refuse("has no points");
  if (!(rate > 0) || !std::isfinite(rate))
    return refuse("its POINT:RATE isn't above 0");
  if (options.rate > 0 && std::abs(options.rate / rate - 1) > 0.01)
    return refuse("frames are " + shortest(rate) +
                  " a second by POINT:RATE, but not by --rate; correct what is wrong");
  if (!std::isfinite(scale) || scale == 0)
    return refuse("its POINT:SCALE is no factor");
  if (count < 2)
    return refuse("one frame doesn't show how anything moves; give a recording");
  // A scale below 0 says that numbers are reals, and not to be scaled.
  const bool real = scale < 0;
  const std::size_t width = real ? 4 : 2, frame = (4 * points + analog) * width;
  if (!(block >= 1) || (block - 1) * kBlock + count * static_cast<double>(frame) >
                           static_cast<double>(bytes.size()))
    return refuse("ends before its " + std::to_string(static_cast<long long>(count)) +
                  " frames of " + std::to_string(points) +
                  " points do; was it copied whole?");
  std::optional<double> unit;
  const auto units = texts_in(numbers, parameters, "POINT:UNITS");
  if (!units.empty() && !units[0].empty()) {
    unit = unit_of(units[0], false);
    if (!unit) return refuse("'" + units[0] + "' is no unit of length");
  } else {
    unit = unit_said(file, options, findings);
    if (!unit) return std::nullopt;
  }

  constexpr double kGap = std::numeric_limits<double>::quiet_NaN();
  const auto frames = static_cast<std::size_t>(count);
  const std::size_t data = (static_cast<std::size_t>(block) - 1) * kBlock;
  Recording recording{1 / rate, {}};
  const auto names = names_of(numbers, parameters, points);
  for (std::size_t p = 0; p < points; ++p) {
    Track track{names[p], {}};
    track.at.resize(static_cast<Eigen::Index>(frames), 3);
    for (std::size_t f = 0; f < frames; ++f) {
      const std::size_t at = data + f * frame + 4 * p * width;
      const auto value = [&](std::size_t i) {
        return real ? numbers.real(at + i * width)
                    : numbers.integer(at + i * width) * scale;
      };
      // Below 0: no camera saw it.
      const bool seen = real ? numbers.real(at + 3 * width) >= 0
                             : numbers.integer(at + 3 * width) >= 0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double x = value(axis) * *unit;
        track.at(static_cast<Eigen::Index>(f), static_cast<Eigen::Index>(axis)) =
            seen && std::isfinite(x) ? x : kGap;
      }
    }
    recording.tracks.push_back(std::move(track));
  }
  return recording;
}

}  // namespace delos::recordings
