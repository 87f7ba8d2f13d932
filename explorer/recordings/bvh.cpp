// Biovision hierarchy: a tree of joints, each with an offset from its parent and the
// channels that move it, and a line of channels a frame.
//
// A joint stands at p = p_parent + R_parent o, where o is its offset, or what its
// position channels say instead, and is turned by R = R_parent R_1 R_2 R_3, the
// rotations in the order of the channels.
//
// Source: M. Meredith, S. Maddock: Motion capture file formats explained, University of
// Sheffield, CS-01-11, 2001, §3.
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "recordings/lines.h"

namespace delos::recordings {
namespace {

struct Channel {
  bool rotates = false;
  int axis = 0;
};

struct Joint {
  std::string name;
  int parent = -1;
  Eigen::Vector3d offset{0, 0, 0};
  std::vector<Channel> channels;
};

/// One word after another, line after line.
class Words {
 public:
  explicit Words(const Lines& lines) : lines_(lines) {}

  /// Empty at the end.
  Cell next() {
    while (at_ >= cells_.size()) {
      if (line_ >= lines_.lines.size()) return {};
      cells_ = cells_of(lines_.lines[line_++], ' ');
      at_ = 0;
    }
    return cells_[at_++];
  }
  /// Of the word before, from 0.
  [[nodiscard]] std::size_t line() const { return line_ > 0 ? line_ - 1 : 0; }
  /// The line that nothing was read of yet.
  [[nodiscard]] std::size_t next_line() const { return line_; }

 private:
  const Lines& lines_;
  std::vector<Cell> cells_;
  std::size_t at_ = 0, line_ = 0;
};

std::optional<Channel> channel_of(std::string_view word) {
  if (word.size() < 2 || word[0] < 'X' || word[0] > 'Z') return std::nullopt;
  const std::string_view what = word.substr(1);
  if (what != "position" && what != "rotation") return std::nullopt;
  return Channel{what == "rotation", word[0] - 'X'};
}

/// The tree, as far as MOTION.
/// @returns empty, with a finding, where it can't be understood
std::vector<Joint> joints_of(const Lines& lines, Words& words) {
  constexpr std::size_t kMostJoints = 10'000;
  std::vector<Joint> joints;
  std::vector<int> open;  // the joints about this word; −1: the end of a limb
  std::string name;
  const auto refuse = [&](const Cell& word, const std::string& problem) {
    lines.error(words.line(), word.column, problem);
    return std::vector<Joint>();
  };
  int about = -2;  // whose braces come next; −2: nobody's
  for (;;) {
    const Cell word = words.next();
    if (word.text.empty()) return refuse(word, "ends before MOTION");
    if (word.text == "HIERARCHY") continue;
    if (word.text == "MOTION") {
      if (open.empty() && !joints.empty()) return joints;
      return refuse(word, joints.empty() ? "has no joints" : "lacks a }");
    }
    if (word.text == "ROOT" || word.text == "JOINT") {
      if (joints.size() == kMostJoints)
        return refuse(word, "has more than 10,000 joints");
      // Names may have blanks: all to the end of the line.
      const std::string_view line = lines.lines[words.line()];
      const std::size_t from =
          static_cast<std::size_t>(word.column - 1) + word.text.size();
      std::string text;
      for (const Cell& part : cells_of(line.substr(from), ' ')) {
        if (part.text == "{") break;
        (void)words.next();
        text += (text.empty() ? "" : " ") + std::string(part.text);
      }
      Joint joint;
      joint.name = text;
      joint.parent = open.empty() ? -1 : open.back();
      if (!open.empty() && open.back() < 0)
        return refuse(word, "a joint can't hang on an End Site");
      about = static_cast<int>(joints.size());
      joints.push_back(std::move(joint));
    } else if (word.text == "End") {
      (void)words.next();
      about = -1;
    } else if (word.text == "{") {
      if (about == -2) return refuse(word, "a { of no joint");
      open.push_back(about);
      about = -2;
    } else if (word.text == "}") {
      if (open.empty()) return refuse(word, "a } too many");
      open.pop_back();
    } else if (word.text == "OFFSET") {
      for (int axis = 0; axis < 3; ++axis) {
        const Cell cell = words.next();
        const auto value = number_of(cell.text);
        if (!value || std::isnan(*value) || open.empty())
          return refuse(cell, "expected the three numbers of a joint's OFFSET");
        if (open.back() >= 0)
          joints[static_cast<std::size_t>(open.back())].offset(axis) = *value;
      }
    } else if (word.text == "CHANNELS") {
      const auto count = number_of(words.next().text);
      if (!count || !(*count >= 0 && *count <= 6) || open.empty() || open.back() < 0)
        return refuse(word, "expected up to 6 channels of a joint");
      for (int c = 0; c < static_cast<int>(*count); ++c) {
        const Cell cell = words.next();
        const auto channel = channel_of(cell.text);
        if (!channel)
          return refuse(cell, "'" + std::string(cell.text) +
                                  "' is no channel, such as Xposition or Zrotation");
        joints[static_cast<std::size_t>(open.back())].channels.push_back(*channel);
      }
    } else {
      return refuse(word,
                    "'" + std::string(word.text) +
                        "' has no meaning here; expected JOINT, End Site, OFFSET, "
                        "CHANNELS, braces or MOTION");
    }
  }
}

/// Where all joints are, given a frame's channels.
/// @param places three numbers a joint
void place(const std::vector<Joint>& joints, const std::vector<double>& channels,
           std::vector<Eigen::Matrix3d>& turned, std::vector<double>& places) {
  std::size_t c = 0;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const Joint& joint = joints[j];
    Eigen::Vector3d offset = joint.offset;
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    for (const Channel& channel : joint.channels) {
      const double value = channels[c++];
      if (channel.rotates)
        turn = turn * Eigen::AngleAxisd(value * std::numbers::pi / 180,
                                        Eigen::Vector3d::Unit(channel.axis));
      else
        offset(channel.axis) = value;
    }
    Eigen::Map<Eigen::Vector3d> at(places.data() + 3 * j);
    turned[j] = turn;
    at = offset;
    if (joint.parent < 0) continue;
    const auto parent = static_cast<std::size_t>(joint.parent);
    turned[j] = turned[parent] * turn;
    at = Eigen::Map<Eigen::Vector3d>(places.data() + 3 * parent) +
         turned[parent] * offset;
  }
}

}  // namespace

std::optional<Recording> read_bvh(const Lines& lines, const ReadOptions& options) {
  const auto unit = unit_said(lines.file, options, lines.findings);
  if (!unit) return std::nullopt;
  Words words(lines);
  const std::vector<Joint> joints = joints_of(lines, words);
  if (joints.empty()) return std::nullopt;
  std::size_t channels = 0;
  for (const Joint& joint : joints) channels += joint.channels.size();
  const auto fact = [&](std::initializer_list<std::string_view> key) {
    for (const std::string_view word : key)
      if (words.next().text != word) return std::nan("");
    return number_of(words.next().text).value_or(NAN);
  };
  const double count = fact({"Frames:"}), period = fact({"Frame", "Time:"});
  if (!(count >= 1) || !(period > 0) || !std::isfinite(1 / period)) {
    lines.error(words.line(), 1, "expected 'Frames: N' and 'Frame Time: SECONDS'");
    return std::nullopt;
  }
  // Joints may have no channel, so that a small file could ask for any memory.
  constexpr double kMostPlaces = 5e7;
  const std::size_t left = lines.lines.size() - words.next_line();
  if (static_cast<double>(left) * static_cast<double>(joints.size()) > kMostPlaces) {
    lines.error(words.line(), 1, "has more than 50 million places of joints");
    return std::nullopt;
  }
  std::vector<double> values(channels), places(3 * joints.size()), all;
  std::vector<Eigen::Matrix3d> turned(joints.size());
  std::size_t frames = 0;
  for (std::size_t l = words.next_line(); l < lines.lines.size(); ++l) {
    const auto cells = cells_of(lines.lines[l], ' ');
    if (cells.empty()) continue;
    if (cells.size() != channels) {
      lines.error(l, 1,
                  "has " + std::to_string(cells.size()) + " numbers; the joints have " +
                      std::to_string(channels) + " channels");
      return std::nullopt;
    }
    for (std::size_t c = 0; c < channels; ++c) {
      const auto value = number_of(cells[c].text);
      if (!value) {
        lines.error(l, cells[c].column,
                    "'" + std::string(cells[c].text) + "' isn't a number");
        return std::nullopt;
      }
      values[c] = *value;
    }
    place(joints, values, turned, places);
    all.insert(all.end(), places.begin(), places.end());
    ++frames;
  }
  if (static_cast<double>(frames) != count) {
    lines.error(words.line(), 1,
                "has " + std::to_string(frames) + " frames; its head says " +
                    std::to_string(static_cast<long long>(std::min(count, 1e15))));
    return std::nullopt;
  }
  if (frames < 2) {
    lines.error(words.line(), 0,
                "one frame doesn't show how anything moves; give a recording");
    return std::nullopt;
  }
  Recording recording{period, {}};
  std::vector<std::string> names;
  for (const Joint& joint : joints) names.push_back(joint.name);
  names = distinct(std::move(names));
  for (std::size_t j = 0; j < joints.size(); ++j) {
    Track track{names[j], {}};
    track.at.resize(static_cast<Eigen::Index>(frames), 3);
    for (std::size_t f = 0; f < frames; ++f)
      for (std::size_t axis = 0; axis < 3; ++axis)
        track.at(static_cast<Eigen::Index>(f), static_cast<Eigen::Index>(axis)) =
            all[3 * (f * joints.size() + j) + axis] * *unit;
    recording.tracks.push_back(std::move(track));
  }
  return recording;
}

}  // namespace delos::recordings
