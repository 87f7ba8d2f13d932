#include "imports/artemis_lines.h"

#include <algorithm>
#include <sstream>

#include "delos/text/units.h"

namespace delos::imports {
namespace {

constexpr std::size_t kMostMeasurements = 10'000;

std::optional<double> word_as_number(const std::string& word) {
  Value value;
  value.text = word;
  const auto one = numbers_in(value);
  return one && one->size() == 1 ? std::optional((*one)[0]) : std::nullopt;
}

/// "positionX" → 0; of "orientationR", with "RPY", 0
std::optional<int> axis_of_word(const std::string& word, const std::string& stem,
                                const std::string& letters) {
  if (word.size() != stem.size() + 1 || !word.starts_with(stem)) return std::nullopt;
  const std::size_t at = letters.find(word.back());
  return at == std::string::npos ? std::nullopt : std::optional(static_cast<int>(at));
}

/// A number with what follows it: "0.005 GUI slider S1_Noise 0.001 0.006", "relative".
std::optional<ArtemisNumber> number_with_control(const ArtemisLine& line,
                                                 Source& source) {
  const auto value =
      line.words.size() > 1 ? word_as_number(line.words[1]) : std::nullopt;
  if (!value) {
    source.error(line.number, "'" + line.words[0] + "' needs a number");
    return std::nullopt;
  }
  ArtemisNumber out{*value, false, {}};
  std::size_t at = 2;
  if (at < line.words.size() && line.words[at] == "relative") {
    out.relative = true;
    ++at;
  }
  if (at == line.words.size()) return out;
  if (line.words[at] != "GUI" || line.words.size() < at + 3) {
    source.error(line.number,
                 "after a number comes 'relative', or 'GUI slider NAME "
                 "LEAST GREATEST', and not '" +
                     line.words[at] + "'");
    return out;
  }
  ArtemisControl control{line.words[at + 1], line.words[at + 2], "", ""};
  if (control.kind != "slider" && control.kind != "text" && control.kind != "textbox")
    source.error(line.number,
                 "'" + control.kind + "' is no control: slider, text and textbox are");
  if (line.words.size() > at + 3) {
    const auto range = numbers_of(line, at + 3, 2);
    if (range && (*range)[0] < (*range)[1]) {
      control.lower = shortest((*range)[0]);
      control.upper = shortest((*range)[1]);
    } else {
      source.error(line.number, "the range of '" + control.name +
                                    "' must be two numbers, the lesser first");
    }
  }
  out.control = control;
  return out;
}

/// Three numbers of one line, without controls.
void take_three(const ArtemisLine& line, std::optional<ArtemisNumber> (&to)[3],
                Source& source) {
  const auto all = numbers_of(line, 1, 3);
  if (!all) {
    source.error(line.number, "'" + line.words[0] +
                                  "' needs three numbers; controls are "
                                  "of single ones, such as positionX");
    return;
  }
  for (std::size_t i = 0; i < 3; ++i) to[i] = ArtemisNumber{(*all)[i], false, {}};
}

/// One line within a measurement.
/// @returns false where it is none of a measurement
bool take(const ArtemisLine& line, ArtemisMeasurement& m, Source& source) {
  const std::string& word = line.words[0];
  if (word == "icon") return true;
  if (word == "position") return take_three(line, m.position, source), true;
  if (word == "orientation") return take_three(line, m.angle, source), true;
  if (const auto axis = axis_of_word(word, "position", "XYZ"))
    return m.position[*axis] = number_with_control(line, source), true;
  if (const auto axis = axis_of_word(word, "orientation", "RPY"))
    return m.angle[*axis] = number_with_control(line, source), true;
  if (word == "r") return m.r = number_with_control(line, source), true;
  if (word == "dt") return m.dt = number_with_control(line, source), true;
  if (word == "filename") {
    if (line.words.size() == 2) m.filename = line.words[1];
    return true;
  }
  for (const auto& [name, member] :
       {std::pair{"left", &m.left}, {"up", &m.up}, {"look", &m.look}}) {
    if (word != name) continue;
    *member = numbers_of(line, 1, 3);
    if (!*member) source.error(line.number, "'" + word + "' needs three numbers");
    return true;
  }
  return false;
}

}  // namespace

std::vector<ArtemisLine> artemis_lines(std::string_view text) {
  std::vector<ArtemisLine> lines;
  std::istringstream in{std::string(text)};
  int number = 0;
  for (std::string row; std::getline(in, row);) {
    ++number;
    std::istringstream words(row.substr(0, row.find(';')));
    ArtemisLine line{{}, number};
    for (std::string word; words >> word && line.words.size() < 32;)
      line.words.push_back(word);
    if (!line.words.empty()) lines.push_back(std::move(line));
  }
  return lines;
}

std::optional<std::vector<double>> numbers_of(const ArtemisLine& line,
                                              std::size_t first, std::size_t count) {
  if (line.words.size() != first + count) return std::nullopt;
  std::vector<double> out;
  for (std::size_t i = first; i < line.words.size(); ++i) {
    const auto value = word_as_number(line.words[i]);
    if (!value) return std::nullopt;
    out.push_back(*value);
  }
  return out;
}

std::vector<ArtemisMeasurement> artemis_measurements(
    const std::vector<ArtemisLine>& lines, std::size_t from, Source& source) {
  std::vector<ArtemisMeasurement> all;
  std::string group;
  double left_of_header = 0;  // sets of flags that one "measurement TYPE N" still has
  std::vector<std::string> seen;
  for (std::size_t i = from; i < lines.size(); ++i) {
    const ArtemisLine& line = lines[i];
    if (line.words[0] == "group") {
      if (line.words.size() != 2) source.error(line.number, "'group' needs a name");
      group = line.words.size() > 1 ? line.words[1] : "";
      continue;
    }
    if (line.words[0] == "measurement") {
      ArtemisMeasurement m;
      const auto count =
          line.words.size() > 2 ? word_as_number(line.words[2]) : std::nullopt;
      if (!count || !(*count >= 1)) {
        source.error(line.number,
                     "write 'measurement TYPE N', and 'master' or 'slave' "
                     "where it is one of a group");
        return all;
      }
      m.type = line.words[1];
      m.role = line.words.size() > 3 ? line.words[3] : "";
      m.group = group;
      m.line = line.number;
      left_of_header = *count - 1;
      all.push_back(std::move(m));
      seen.clear();
    } else if (all.empty()) {
      source.error(line.number,
                   "'" + line.words[0] + "' stands before any measurement");
      return all;
    } else {
      // A flag that comes again begins the next of "measurement TYPE N".
      if (std::find(seen.begin(), seen.end(), line.words[0]) != seen.end()) {
        if (left_of_header < 1) {
          source.error(line.number, "'" + line.words[0] + "' is there already");
          continue;
        }
        --left_of_header;
        ArtemisMeasurement next;
        next.type = all.back().type;
        next.group = group;
        next.line = line.number;
        all.push_back(std::move(next));
        seen.clear();
      }
      seen.push_back(line.words[0]);
      if (!take(line, all.back(), source))
        source.warning(line.number,
                       "'" + line.words[0] + "' isn't known, and left out");
    }
    if (all.size() > kMostMeasurements) {
      source.error(line.number, "has more than 10000 measurements");
      return all;
    }
  }
  return all;
}

}  // namespace delos::imports
