#include "recordings/lines.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <unordered_set>

#include "delos/text/units.h"

namespace delos::recordings {
namespace {

constexpr double kGap = std::numeric_limits<double>::quiet_NaN();

/// Times may be off their frame by so much of a period: they are written with few
/// decimals.
constexpr double kJitter = 0.2;
/// And what a file says of its rate by so much.
constexpr double kRateOff = 0.01;

std::string_view trimmed(std::string_view text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  if (text.size() >= 2 && text.front() == '"' && text.back() == '"')
    text = text.substr(1, text.size() - 2);
  return text;
}

std::string hertz(double period) { return shortest(std::round(1e4 / period) / 1e4); }

}  // namespace

void Lines::error(std::size_t line, int column, std::string problem) const {
  findings.push_back({{file, static_cast<int>(line) + 1, column},
                      Severity::error,
                      std::move(problem)});
}

void Lines::warning(std::size_t line, std::string problem) const {
  findings.push_back(
      {{file, static_cast<int>(line) + 1, 0}, Severity::warning, std::move(problem)});
}

std::vector<Cell> cells_of(std::string_view line, char separator) {
  std::vector<Cell> cells;
  std::size_t begin = 0;
  while (begin <= line.size()) {
    std::size_t end = std::min(line.find(separator, begin), line.size());
    if (separator == ' ')
      end = std::min(line.find_first_of(" \t\r", begin), line.size());
    const std::string_view text = trimmed(line.substr(begin, end - begin));
    if (separator != ' ' || !text.empty())
      cells.push_back({text, static_cast<int>(begin) + 1});
    begin = end + 1;
  }
  return cells;
}

std::optional<double> number_of(std::string_view text) {
  if (text.empty() || text == "nan" || text == "NaN" || text == "NAN") return kGap;
  if (text.front() == '+') text.remove_prefix(1);
  double value = 0;
  const auto [end, error] =
      std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

std::optional<double> unit_of(std::string_view name, bool of_time) {
  const auto one = parse_quantity("1 " + std::string(name), of_time ? "s" : "m");
  const double* factor = std::get_if<double>(&one);
  return factor && !name.empty() ? std::optional(*factor) : std::nullopt;
}

std::vector<std::string> distinct(std::vector<std::string> names) {
  std::unordered_set<std::string> seen;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (!seen.insert(names[i]).second) names[i] += "#" + std::to_string(i + 1);
  return names;
}

std::optional<double> unit_said(const std::string& file, const ReadOptions& options,
                                Diagnostics& findings) {
  if (options.unit > 0) return options.unit;
  findings.push_back({{file, 0, 0},
                      Severity::error,
                      "doesn't say the unit of its lengths; give --unit, such as cm"});
  return std::nullopt;
}

Frames frames_of(const Lines& lines, std::size_t begin, char separator,
                 const std::vector<std::size_t>& first, double unit) {
  const std::size_t before = lines.findings.size();
  Frames frames;
  for (std::size_t l = begin; l < lines.lines.size(); ++l) {
    const auto cells = cells_of(lines.lines[l], separator);
    const bool blank = std::all_of(cells.begin(), cells.end(),
                                   [](const Cell& c) { return c.text.empty(); });
    if (blank) continue;
    const auto value = [&](std::size_t c) {
      if (c >= cells.size()) return std::nan("");  // cut off: not seen
      const auto number = number_of(cells[c].text);
      if (!number)
        lines.error(l, cells[c].column,
                    "'" + std::string(cells[c].text) + "' isn't a number");
      return number.value_or(0);
    };
    const double when = value(1);
    if (std::isnan(when)) lines.error(l, 1, "has no time");
    frames.line.push_back(l);
    frames.time.push_back(when);
    for (const std::size_t at : first)
      for (std::size_t axis = 0; axis < 3; ++axis)
        frames.values.push_back(value(at + axis) * unit);
    if (lines.findings.size() > before + 20) break;
  }
  return frames;
}

std::optional<Recording> evenly_spaced(const Lines& lines,
                                       const std::vector<std::string>& names,
                                       const Frames& frames, double period) {
  const std::size_t count = frames.time.size(), errors = lines.findings.size();
  std::vector<double> steps;
  for (std::size_t i = 1; i < count; ++i) {
    const double step = frames.time[i] - frames.time[i - 1];
    if (!(step > 0)) {
      lines.error(frames.line[i], 1,
                  "its time, " + shortest(frames.time[i]) +
                      " s, isn't after that of the frame before; sort the frames, and "
                      "leave out repeated ones");
      return std::nullopt;
    }
    steps.push_back(step);
  }
  if (steps.empty()) {
    lines.error(count ? frames.line[0] : 0, 0,
                "one frame doesn't show how anything moves; give a recording");
    return std::nullopt;
  }
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  // The median of rounded times is off; their mean over frames that follow isn't.
  double sum = 0, of = 0;
  for (std::size_t i = 1; i < count; ++i) {
    const double step = frames.time[i] - frames.time[i - 1];
    if (std::abs(step - *middle) > kJitter * *middle) continue;
    sum += step;
    ++of;
  }
  const double found = sum / of;
  if (period > 0 && std::abs(found / period - 1) > kRateOff)
    lines.error(frames.line[1], 1,
                "frames are " + hertz(found) + " a second by their times, but " +
                    hertz(period) +
                    " by the file's head or --rate; correct what is wrong");
  if (period <= 0) period = found;
  if (lines.findings.size() > errors) return std::nullopt;

  std::vector<std::size_t> at = {0};
  // What is missing is held in memory, too.
  constexpr double kMostGap = 1e6;
  const std::size_t most_frames = 1000 + 10 * count;
  for (std::size_t i = 1; i < count; ++i) {
    const double step = (frames.time[i] - frames.time[i - 1]) / found;
    const double whole = std::round(step);
    if (whole < 1 || std::abs(step - whole) > kJitter || whole > kMostGap) {
      lines.error(frames.line[i], 1,
                  "is " + shortest(std::round(1000 * step) / 1000) +
                      " frames after the one before; times must be evenly spaced, but "
                      "for frames that are missing");
      return std::nullopt;
    }
    at.push_back(at.back() + static_cast<std::size_t>(whole));
    if (at.back() >= most_frames) {
      lines.error(frames.line[i], 1,
                  "more than nine of ten frames are missing before it; cut the "
                  "recording into parts");
      return std::nullopt;
    }
  }
  Recording recording{period, {}};
  for (std::size_t t = 0; t < names.size(); ++t) {
    Track track{names[t], {}};
    track.at.setConstant(static_cast<Eigen::Index>(at.back() + 1), 3, kGap);
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t axis = 0; axis < 3; ++axis)
        track.at(static_cast<Eigen::Index>(at[i]), static_cast<Eigen::Index>(axis)) =
            frames.values[(i * names.size() + t) * 3 + axis];
    recording.tracks.push_back(std::move(track));
  }
  return recording;
}

}  // namespace delos::recordings
