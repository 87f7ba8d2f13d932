#include "output/write.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "delos/document/file_commit.h"
#include "output/csv.h"
#include "output/json.h"
#include "output/picture.h"
#include "output/slice.h"
#include "output/vtk.h"

namespace delos {
namespace {

/// A file format: its suffix, what it can't show, and its writer.
struct Format {
  std::string_view suffix;
  /// Why these samples don't fit, and what does; empty where they fit.
  std::string (*misfit)(const Samples& samples);
  void (*write)(const Field& field, const PictureOptions& picture, std::ostream& out);
};

std::string fits_all(const Samples&) { return {}; }

bool is_octree(const SamplePart& part) {
  return std::holds_alternative<OctreeShape>(part.shape);
}

std::string misfit_vti(const Samples& samples) {
  if (samples.parts.size() > 1) {
    return ".vti holds one volume and the scene has " +
           std::to_string(samples.parts.size()) +
           " sample sets; .vtp takes them all as points";
  }
  if (samples.parts.size() == 1 && is_octree(samples.parts.front()))
    return ".vti holds a regular volume and these samples are adaptive; .vtu takes "
           "them";
  if (samples.parts.empty() ||
      !std::holds_alternative<GridShape>(samples.parts.front().shape))
    return ".vti holds a volume and these samples aren't one; .vtp takes any points";
  return {};
}

bool is_surface(const SamplePart& part) {
  return std::holds_alternative<SurfaceShape>(part.shape);
}

std::string misfit_vtu(const Samples& samples) {
  if (samples.parts.size() == 1 && is_octree(samples.parts.front())) return {};
  return ".vtu holds the octree of adaptive samples and these aren't; .vti takes a "
         "volume, .vtp any points";
}

std::string misfit_png(const Samples& samples) {
  if (has_slice(samples)) return {};
  if (std::any_of(samples.parts.begin(), samples.parts.end(), is_surface))
    return "a .png shows a volume or a plane and these samples are on a mesh; .vtp "
           "takes its surface";
  return "a .png shows a volume or a plane and these samples are scattered; .vtp and "
         ".csv "
         "take any points";
}

constexpr std::array kFormats = {
    Format{".vti", misfit_vti,
           [](const Field& field, const PictureOptions&, std::ostream& out) {
             write_vti(field, out);
           }},
    Format{".vtu", misfit_vtu,
           [](const Field& field, const PictureOptions&, std::ostream& out) {
             write_vtu(field, out);
           }},
    Format{".vtp", fits_all,
           [](const Field& field, const PictureOptions&, std::ostream& out) {
             write_vtp(field, out);
           }},
    Format{".csv", fits_all,
           [](const Field& field, const PictureOptions&, std::ostream& out) {
             write_csv(field, out);
           }},
    Format{".json", fits_all,
           [](const Field& field, const PictureOptions&, std::ostream& out) {
             write_json(field, out);
           }},
    Format{".png", misfit_png, write_picture},
};

const Format* find_format(const std::filesystem::path& file) {
  std::string suffix = file.extension().string();
  for (char& c : suffix)
    if (c >= 'A' && c <= 'Z') c += 'a' - 'A';
  const auto found = std::find_if(kFormats.begin(), kFormats.end(),
                                  [&](const Format& f) { return f.suffix == suffix; });
  return found == kFormats.end() ? nullptr : &*found;
}

std::string unknown_suffix(const std::filesystem::path& file) {
  const std::string suffix = file.extension().string();
  std::string sentence = file.string();
  if (suffix.empty())
    sentence += ": no suffix to tell the format by";
  else
    sentence.append(": '").append(suffix).append(
        "' isn't a format that can be written");
  sentence += "; known are";
  for (const Format& format : kFormats) sentence.append(" ").append(format.suffix);
  return sentence;
}

}  // namespace

std::string writable(const Samples& samples, const std::filesystem::path& file) {
  const Format* format = find_format(file);
  if (format == nullptr) return unknown_suffix(file);
  if (const std::string why = format->misfit(samples); !why.empty())
    return file.string() + ": " + why;
  return missing_folder(file);
}

std::string write_field(const Field& field, const std::filesystem::path& file,
                        const PictureOptions& picture) {
  if (std::string why = writable(field.samples, file); !why.empty()) return why;
  const Format& format = *find_format(file);
  return commit_file(file,
                     [&](std::ostream& out) { format.write(field, picture, out); });
}

std::string write_text(const std::filesystem::path& file, std::string_view text) {
  if (std::string why = missing_folder(file); !why.empty()) return why;
  return commit_file(file, [&](std::ostream& out) { out << text; });
}

}  // namespace delos
