#include "imports/import.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>

#include "delos/text/words.h"
#include "imports/floor_plan.h"
#include "imports/formats.h"

namespace delos::imports {
namespace {

constexpr std::uintmax_t kMostBytes = 64 << 20;

/// The first line that is neither empty nor a comment.
std::string_view first_line(std::string_view text) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    const std::size_t begin = line.find_first_not_of(" \t\r");
    if (begin != std::string_view::npos && line[begin] != '#')
      return line.substr(begin);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return {};
}

/// "[cameras.0]" or "key = value"; a list of YAML has no word in its bracket.
bool looks_like_toml(std::string_view text) {
  const std::string_view line = first_line(text);
  if (line.starts_with("["))
    return line.size() > 1 && (std::isalpha(static_cast<unsigned char>(line[1])) != 0 ||
                               line[1] == '[' || line[1] == '"');
  const std::size_t equals = line.find('=');
  return equals != std::string_view::npos && line.find(':') > equals;
}

bool is_wide(std::string_view text) {
  return text.size() >= 4 &&
         ((text[0] == '\xFF' && text[1] == '\xFE') ||
          (text[0] == '\xFE' && text[1] == '\xFF') ||
          (text[0] == '<' && text[1] == '\0') || (text[0] == '\0' && text[1] == '<'));
}

/// What is no text at all: why it isn't read; empty where it is one.
std::string why_not_text(std::string_view text) {
  if (text.size() > 2 && text[0] == '\x80' && text[1] >= 2 && text[1] <= 5)
    return "is a Python pickle, which can run anything when it is loaded, and isn't "
           "read; save its matrices as JSON or YAML";
  if (is_wide(text)) return "";
  if (text.substr(0, 4096).find('\0') != std::string_view::npos)
    return "is binary; calibrations of Motive before 3.2 (.cal) are, and aren't read: "
           "export it as .mcal from a newer one";
  return "";
}

std::optional<Value> parse(std::string_view text, Source& source) {
  if (is_wide(text) || first_line(text).starts_with("<"))
    return parse_xml(text, source);
  return looks_like_toml(text) ? parse_toml(text, source) : parse_yaml(text, source);
}

std::string known_formats() {
  std::vector<std::string> names;
  for (const CalibrationFormat& format : calibration_formats())
    names.emplace_back(format.name);
  return joined(names, "; ") +
         "; geometry of lighthouse base stations (.yaml); model of COLMAP "
         "(cameras.txt, "
         "images.txt); input file of Artemis (.ext); floor plan as GeoJSON or SVG";
}

std::optional<Rig> rig_of_cameras(Calibration& calibration, const std::string& kind,
                                  const ImportOptions& options, Source& source) {
  check(calibration, options, source);
  if (source.errors() > 0) return std::nullopt;
  Rig rig = rig_of(calibration, kind);
  std::vector<Pose> sights;
  for (const RigDevice& d : rig.devices) sights.push_back(pose_of(d.placement));
  assume_rest(rig, sights, source);
  return rig;
}

std::optional<Rig> rig_of_values(const Value& root, const std::filesystem::path& file,
                                 const ImportOptions& options, Source& source) {
  if (is_lighthouse(root)) {
    std::vector<Pose> sights;
    Rig rig = read_lighthouse(root, options, source, sights);
    if (source.errors() == 0) assume_rest(rig, sights, source);
    return rig;
  }
  if (is_geojson(root) || is_svg(root)) {
    Rig rig;
    auto outlines = is_svg(root) ? svg_outlines(root, options, rig, source)
                                 : geojson_outlines(root, options, rig, source);
    if (source.errors() == 0) furnish(rig, std::move(outlines), options, source);
    return rig;
  }
  for (const CalibrationFormat& format : calibration_formats()) {
    if (!format.recognises(root)) continue;
    const auto whole = format.name == kEasyMocap.name
                           ? easymocap_whole(root, file, source)
                           : std::optional(root);
    if (!whole) return std::nullopt;
    Calibration calibration;
    format.read(*whole, options, source, calibration);
    return rig_of_cameras(calibration, format.name, options, source);
  }
  source.error(0,
               "isn't of a format that is known, or of another version of one; "
               "known: " +
                   known_formats());
  return std::nullopt;
}

}  // namespace

std::optional<Rig> import_text(std::string_view text, const std::filesystem::path& file,
                               const std::filesystem::path& folder,
                               const ImportOptions& options, Diagnostics& findings) {
  Source source(file.string(), findings);
  const std::size_t before = source.errors();
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  std::optional<Rig> rig;
  if (const std::string why = why_not_text(text); !why.empty()) {
    source.error(0, why);
  } else if (!is_wide(text) && first_line(text).empty() && !is_colmap(text)) {
    source.error(0, "is empty");
  } else if (is_colmap(text)) {
    Calibration calibration;
    read_colmap(file, options, source, calibration);
    rig = rig_of_cameras(calibration, "model of COLMAP (cameras.txt, images.txt)",
                         options, source);
  } else if (is_artemis(text)) {
    rig = read_artemis(text, file, folder, source);
  } else if (const auto root = parse(text, source)) {
    rig = rig_of_values(*root, file, options, source);
  }
  return source.errors() > before ? std::nullopt : rig;
}

std::optional<Rig> import_file(const std::filesystem::path& file,
                               const std::filesystem::path& folder,
                               const ImportOptions& options, Diagnostics& findings) {
  Source source(file.string(), findings);
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) {
    source.error(0, "there is no such file");
    return std::nullopt;
  }
  if (std::filesystem::file_size(file, error) > kMostBytes) {
    source.error(0, "is larger than 64 MiB, which no calibration is");
    return std::nullopt;
  }
  std::ifstream in(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  if (in.bad()) {
    source.error(0, "can't be read");
    return std::nullopt;
  }
  return import_text(text, file, folder.empty() ? file.parent_path() : folder, options,
                     findings);
}

}  // namespace delos::imports
