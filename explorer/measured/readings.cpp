#include "measured/readings.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>

#include "delos/text/words.h"
#include "recordings/lines.h"

namespace delos::measured {
namespace {

constexpr std::size_t kMostFindings = 20;

/// Where the columns of a file stand; its number of columns: it has none.
struct Columns {
  std::size_t count = 0, t = 0, device = 0;
  std::vector<std::size_t> z, truth;
};

class Reader {
 public:
  Reader(const std::filesystem::path& file, const System& system, Diagnostics& findings)
      : file_(file), system_(system), findings_(findings), before_(findings.size()) {}

  std::optional<Readings> read() {
    std::ifstream in(file_, std::ios::binary);
    std::string line;
    Readings readings;
    for (line_ = 1; std::getline(in, line); ++line_) {
      if (line.ends_with('\r')) line.pop_back();
      if (line.empty() || line.front() == '#') continue;
      const std::vector<recordings::Cell> cells = recordings::cells_of(line, ',');
      if (columns_.count == 0) {
        read_head(cells);
        if (failed()) return std::nullopt;
      } else {
        read_row(cells, readings);
        if (findings_.size() - before_ >= kMostFindings) return std::nullopt;
      }
    }
    if (columns_.count == 0)
      error(0, "is no file with a head such as t [s],device,z1,x,y,z");
    else if (readings.all.empty() && !failed())
      error(0, "has no readings");
    if (failed()) return std::nullopt;
    return readings;
  }

 private:
  void error(int column, std::string problem) {
    findings_.push_back(
        {{file_.string(), line_, column}, Severity::error, std::move(problem)});
    failed_ = true;
  }
  [[nodiscard]] bool failed() const { return failed_; }

  void read_head(const std::vector<recordings::Cell>& cells) {
    columns_ = {cells.size(), cells.size(), cells.size(), {}, {}};
    std::vector<std::string> names;
    for (const recordings::Cell& cell : cells)
      names.emplace_back(cell.text.substr(0, cell.text.find_first_of(" [(")));
    const auto find = [&](const std::string& name) {
      return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) -
                                      names.begin());
    };
    columns_.t = find("t");
    columns_.device = find("device");
    for (int k = 1; find("z" + std::to_string(k)) < cells.size(); ++k)
      columns_.z.push_back(find("z" + std::to_string(k)));
    if (columns_.z.empty() && find("z") < cells.size()) columns_.z = {find("z")};
    for (const char* axis : {"x", "y", "z"})
      if (find(axis) < cells.size() && find("x") < cells.size())
        columns_.truth.push_back(find(axis));
    if (columns_.t == cells.size()) error(1, "names no column t [s]");
    if (columns_.device == cells.size()) error(1, "names no column device");
    if (columns_.z.empty()) error(1, "names no column z1, the reading");
    if (!columns_.truth.empty() && columns_.truth.size() != 3)
      error(1, "has a part of x, y and z only; where the target is has all three");
    if (columns_.truth.size() == 3 && columns_.z == std::vector{columns_.truth[2]})
      error(1,
            "has one column z for a reading and for where the target is; call the "
            "reading z1");
  }

  double number(const recordings::Cell& cell, const char* what) {
    const auto value = recordings::number_of(cell.text);
    if (!value) error(cell.column, "'" + std::string(cell.text) + "' isn't " + what);
    return value.value_or(std::numeric_limits<double>::quiet_NaN());
  }

  void read_row(const std::vector<recordings::Cell>& cells, Readings& readings) {
    if (cells.size() != columns_.count)
      return error(1, "has " + std::to_string(cells.size()) + " cells, the head has " +
                          std::to_string(columns_.count));
    TimedReading timed;
    timed.t = number(cells[columns_.t], "a time in seconds");
    if (std::isnan(timed.t)) {
      if (!failed()) error(cells[columns_.t].column, "has no time");
      return;
    }
    if (!readings.all.empty() && timed.t < readings.all.back().t)
      return error(cells[columns_.t].column,
                   "its time is before that of the reading above; sort readings by "
                   "their times");
    const auto device = device_named(cells[columns_.device]);
    if (!device) return;
    timed.reading.device = static_cast<int>(*device);
    timed.reading.block = {0, system_.motion.layout.size()};
    std::vector<double> z;
    for (const std::size_t c : columns_.z)
      if (!cells[c].text.empty()) z.push_back(number(cells[c], "a number"));
    if (z.empty()) return error(1, "has no reading");
    timed.reading.z = Eigen::Map<const Eigen::VectorXd>(
        z.data(), static_cast<Eigen::Index>(z.size()));
    if (!timed.reading.z.allFinite()) return;
    readings.all.push_back(timed);
    if (columns_.truth.empty()) return;
    Eigen::Vector3d truth;
    for (int k = 0; k < 3; ++k)
      truth(k) = number(cells[columns_.truth[static_cast<std::size_t>(k)]], "a number");
    if (!truth.allFinite()) readings.without_truth.push_back(readings.truth.size());
    readings.truth.push_back(truth);
  }

  std::optional<std::size_t> device_named(const recordings::Cell& cell) {
    for (std::size_t d = 0; d < system_.devices.size(); ++d) {
      if (system_.devices[d].name != cell.text) continue;
      if (system_.devices[d].carried() &&
          system_.devices[d].device->span() == Span::point) {
        error(cell.column, "'" + std::string(cell.text) +
                               "' sees beacons from the target; which one a reading is "
                               "of can't be said here");
        return std::nullopt;
      }
      return d;
    }
    std::vector<std::string> known;
    for (const PlacedDevice& placed : system_.devices) known.push_back(placed.name);
    error(cell.column, "the scene has no device '" + std::string(cell.text) +
                           "'; it has " + joined(known));
    return std::nullopt;
  }

  const std::filesystem::path& file_;
  const System& system_;
  Diagnostics& findings_;
  std::size_t before_;
  Columns columns_;
  int line_ = 0;
  bool failed_ = false;
};

}  // namespace

bool has_readings(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line.front() == '#') continue;
    for (const recordings::Cell& cell : recordings::cells_of(line, ','))
      if (cell.text == "device") return true;
    return false;
  }
  return false;
}

std::optional<Readings> read_readings(const std::filesystem::path& file,
                                      const System& system, Diagnostics& findings) {
  return Reader(file, system, findings).read();
}

}  // namespace delos::measured
