#include "recordings/recording.h"

#include <fstream>
#include <iterator>

#include "recordings/lines.h"

namespace delos::recordings {
namespace {

std::vector<std::string_view> split(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    lines.push_back(line);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

}  // namespace

std::optional<Recording> read_recording(const std::filesystem::path& file,
                                        const ReadOptions& options,
                                        Diagnostics& findings) {
  const auto refuse = [&](std::string problem) -> std::optional<Recording> {
    findings.push_back({{file.string(), 0, 0}, Severity::error, std::move(problem)});
    return std::nullopt;
  };
  std::error_code none;
  if (!std::filesystem::is_regular_file(file, none))
    return refuse("there is no such file");
  std::ifstream in(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!in) return refuse("can't be read");
  const std::string suffix = file.extension().string();
  if (suffix == ".c3d") return read_c3d(text, file.string(), options, findings);
  if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
  const Lines lines{file.string(), split(text), findings};
  if (suffix == ".bvh") return read_bvh(lines, options);
  if (suffix == ".csv")
    return text.starts_with("Format Version") ? read_motive(lines)
                                              : read_csv(lines, options);
  if (suffix == ".trc") return read_trc(lines);
  if (suffix == ".tum") return read_tum(lines);
  return refuse(
      "'" + suffix +
      "' isn't a kind of recording that is read; known: .bvh, .c3d, .csv, .trc, "
      ".tum");
}

}  // namespace delos::recordings
