// The head of an input file of Artemis: state, samples, q.
#include <algorithm>
#include <filesystem>

#include "delos/text/units.h"
#include "imports/artemis_lines.h"
#include "imports/rig.h"

namespace delos::imports {
namespace {

/// How many numbers q a state has, and its words in a scene; of "P_PV", "PO.PVA" …
struct ArtemisState {
  std::size_t coordinates = 0;
  const char *state = "", *type = "";
};

std::optional<ArtemisState> state_of(std::string word) {
  std::replace(word.begin(), word.end(), '.', '_');
  const std::size_t gap = word.find('_');
  if (gap == std::string::npos) return std::nullopt;
  const std::string what = word.substr(0, gap), how = word.substr(gap + 1);
  ArtemisState s;
  if (what == "P") s = {3, "position", ""};
  if (what == "O") s = {3, "orientation", ""};
  if (what == "PO") s = {6, "pose", ""};
  if (how == "P") s.type = "position";
  if (how == "PV") s.type = "position_velocity";
  if (how == "PVA") s.type = "position_velocity_acceleration";
  return s.coordinates > 0 && s.type[0] != 0 ? std::optional(s) : std::nullopt;
}

class ArtemisHeadReader {
 public:
  ArtemisHeadReader(const std::vector<ArtemisLine>& lines,
                    const std::filesystem::path& file,
                    const std::filesystem::path& folder, Source& source)
      : lines_(lines), file_(file), folder_(folder), source_(source) {}

  std::optional<ArtemisHead> read() {
    state_ = *state_of(lines_[0].words[0]);
    if (!read_samples() || !read_q()) return std::nullopt;
    return out_;
  }

 private:
  /// "volume meters" and three lines of numbers, or "PointList meters" and a file.
  bool read_samples() {
    const ArtemisLine& line = lines_[std::min<std::size_t>(1, lines_.size() - 1)];
    const std::string what = line.words[0];
    const auto unit = line.words.size() == 2 ? parse_quantity("1 " + line.words[1], "m")
                                             : std::variant<double, std::string>("");
    if (!std::holds_alternative<double>(unit) ||
        (what != "volume" && what != "Volume" && what != "PointList")) {
      source_.error(line.number,
                    "the second line is 'volume meters' or 'PointList meters'");
      return false;
    }
    out_.unit = std::get<double>(unit);
    if (what == "PointList") return read_points();
    std::vector<Eigen::VectorXd> corners;
    for (std::size_t i = 2; i < 5; ++i) {
      const auto v = i < lines_.size() ? numbers_of(lines_[i], 0, 3) : std::nullopt;
      if (!v) {
        source_.error(line.number,
                      "a volume has three lines of three numbers: its "
                      "least, its greatest corner, its steps");
        return false;
      }
      corners.emplace_back(out_.unit * Eigen::Vector3d((*v)[0], (*v)[1], (*v)[2]));
    }
    out_.sample = "volume: {min: " + list_text(corners[0]) +
                  ", max: " + list_text(corners[1]) +
                  ", step: " + list_text(corners[2]) + "}";
    out_.next = 5;
    return true;
  }

  bool read_points() {
    if (lines_.size() < 3 || lines_[2].words.size() != 1) {
      source_.error(lines_[1].number, "'PointList' has the name of a file below it");
      return false;
    }
    if (out_.unit != 1)
      source_.error(lines_[1].number,
                    "files of points are read in metres; scale this one");
    const auto points = file_.parent_path() / lines_[2].words[0];
    std::error_code error;
    if (!std::filesystem::is_regular_file(points, error))
      source_.error(lines_[2].number, "'" + points.string() + "' isn't there");
    const auto from_scene = std::filesystem::proximate(points, folder_, error);
    std::string name = from_scene.string();
    for (std::size_t i = 0; (i = name.find('\'', i)) != std::string::npos; i += 2)
      name.insert(i, "'");
    out_.sample = "file: '" + name + "'";
    out_.next = 3;
    return true;
  }

  /// A number a line; Fig. 4.5 has those of a position twice, for its velocity.
  bool read_q() {
    std::vector<double> q;
    const int line = out_.next < lines_.size() ? lines_[out_.next].number : 0;
    for (; out_.next < lines_.size(); ++out_.next) {
      const auto one = numbers_of(lines_[out_.next], 0, 1);
      if (!one) break;
      if (!((*one)[0] > 0)) source_.error(lines_[out_.next].number, "a q is above 0");
      q.push_back((*one)[0]);
    }
    const std::size_t n = state_.coordinates;
    const bool twice = q.size() == 2 * n &&
                       std::equal(q.begin(), q.begin() + static_cast<std::ptrdiff_t>(n),
                                  q.begin() + static_cast<std::ptrdiff_t>(n));
    if (q.size() != n && !twice) {
      source_.error(line, "this state has " + std::to_string(n) + " lines of q, and " +
                              std::to_string(q.size()) + " are there");
      return false;
    }
    if (twice) out_.facts.emplace_back("its q are there twice; one of each counts");
    q.resize(n);
    out_.motion = std::string("{type: ") + state_.type + ", state: " + state_.state +
                  ", q: " +
                  list_text(Eigen::Map<const Eigen::VectorXd>(
                      q.data(), static_cast<Eigen::Index>(n))) +
                  "}";
    return true;
  }

  const std::vector<ArtemisLine>& lines_;
  const std::filesystem::path &file_, &folder_;
  Source& source_;
  ArtemisState state_;
  ArtemisHead out_;
};

}  // namespace

bool is_artemis(std::string_view text) {
  const auto lines = artemis_lines(text.substr(0, 4096));
  return !lines.empty() && state_of(lines[0].words[0]).has_value();
}

std::optional<ArtemisHead> artemis_head(const std::vector<ArtemisLine>& lines,
                                        const std::filesystem::path& file,
                                        const std::filesystem::path& folder,
                                        Source& source) {
  return ArtemisHeadReader(lines, file, folder, source).read();
}

}  // namespace delos::imports
