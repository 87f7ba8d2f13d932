// Mesh files: PLY and glTF by readers of our own, the others by CGAL's.
#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/STL.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

#include "delos/geometry/mesh.h"
#include "geometry/mesh/gltf.h"
#include "geometry/mesh/ply.h"
#include "geometry/mesh/soup.h"
#include "text/nearest.h"

namespace delos {
namespace {

using SoupReader = bool (*)(std::istream&, SoupPoints&, SoupPolygons&);

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& why) {
  throw std::runtime_error(file.string() + ": " + why);
}

/// A file that tells how far it has been read.
class WatchedFile : public std::filebuf {
 public:
  WatchedFile(const std::filesystem::path& file,
              const std::function<void(double)>& progress)
      : progress_(progress) {
    pubsetbuf(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    open(file, std::ios::in | std::ios::binary);
    std::error_code failed;
    const auto bytes = std::filesystem::file_size(file, failed);
    if (!failed) bytes_ = static_cast<double>(bytes);
  }

 protected:
  int_type underflow() override {
    const int_type next = std::filebuf::underflow();
    read_ += static_cast<double>(egptr() - eback());
    // A reader that starts again reads some of it twice.
    if (progress_ && bytes_ > 0) progress_(std::min(1.0, read_ / bytes_));
    return next;
  }

 private:
  std::vector<char> buffer_ = std::vector<char>(std::size_t{1} << 20);
  const std::function<void(double)>& progress_;
  double bytes_ = 0, read_ = 0;
};

std::string suffix_of(const std::filesystem::path& file) {
  std::string suffix = file.extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return suffix;
}

/// An OFF file whose vertices have normals, colours or texture coordinates, as one
/// whose vertices have none: CGAL reads past its end where they are missing.
/// @returns empty, and the stream where it was, for any other
/// @throws MeshProblem the header has more in it, of which CGAL reads a part
std::string plain_off(std::istream& in) {
  std::string plain, line, word;
  std::size_t vertices = 0, kept = 0;
  for (bool counted = false; std::getline(in, line);) {
    line.resize(std::min(line.find('#'), line.size()));
    std::istringstream words(line);
    if (plain.empty()) {
      if (!(words >> word)) continue;
      if (word != "COFF" && word != "NOFF" && word != "CNOFF" && word != "STOFF" &&
          word != "STCOFF" && word != "STNOFF" && word != "STCNOFF") {
        if (word != "OFF" && word != "4OFF" && word.find("OFF") != std::string::npos)
          throw MeshProblem{"doesn't begin with a header of OFF"};
        break;
      }
      plain = "OFF\n";
      std::getline(words, line);
      words = std::istringstream(line);
    }
    if (!counted) {
      counted = static_cast<bool>(words >> vertices);
      plain += line + '\n';
    } else if (kept < vertices) {
      int numbers = 0;
      for (; numbers < 3 && words >> word; ++numbers) plain += word + ' ';
      plain += '\n';
      kept += numbers == 3;
    } else {
      plain += line + '\n';
    }
  }
  in.clear();
  in.seekg(0);
  return plain;
}

SoupReader reader_for(const std::filesystem::path& file) {
  const std::string suffix = suffix_of(file);
  if (suffix == ".off") {
    return [](std::istream& in, SoupPoints& p, SoupPolygons& f) {
      std::istringstream plain(plain_off(in));
      return plain.str().empty() ? CGAL::IO::read_OFF(in, p, f)
                                 : CGAL::IO::read_OFF(plain, p, f);
    };
  }
  if (suffix == ".obj") {
    return [](std::istream& in, SoupPoints& p, SoupPolygons& f) {
      return CGAL::IO::read_OBJ(in, p, f);
    };
  }
  if (suffix == ".ply") return read_ply;
  if (suffix == ".stl") {
    return [](std::istream& in, SoupPoints& p, SoupPolygons& f) {
      return CGAL::IO::read_STL(in, p, f);
    };
  }
  if (suffix == ".glb" || suffix == ".gltf") return read_gltf;
  refuse(file, "the suffix '" + file.extension().string() +
                   "' isn't one of .off, .obj, .ply, .stl, .glb and .gltf");
}

/// Why a file that CGAL's reader refused is wrong, as far as can be told.
std::string reason(const std::filesystem::path& file, std::ios::iostate state,
                   const SoupPolygons& polygons) {
  std::ifstream text(file);
  std::string line, word;
  for (int number = 1; std::getline(text, line); ++number) {
    std::istringstream words(line);
    while (words >> word) {
      char* end = nullptr;
      const double value = std::strtod(word.c_str(), &end);
      if (*end == '\0' && !std::isfinite(value)) {
        return "line " + std::to_string(number) + ": '" + word +
               "' isn't a finite number";
      }
    }
  }
  // The OFF reader drops such a face; this state is all that it leaves.
  if (state == std::ios::failbit && !polygons.empty() && !polygons.front().empty()) {
    return "a face names a vertex that doesn't exist";
  }
  return "can't be understood, or ends too early";
}

/// Refuses binary STL with a corner that isn't finite: CGAL would merge it with any
/// other.
void check_binary_stl(const std::filesystem::path& file) {
  constexpr std::size_t kHeader = 84, kTriangle = 50;
  std::ifstream in(file, std::ios::binary);
  std::array<char, kHeader> header;
  std::uint32_t triangles = 0;
  if (!in.read(header.data(), kHeader)) return;
  std::memcpy(&triangles, header.data() + 80, sizeof triangles);
  if (std::filesystem::file_size(file) != kHeader + kTriangle * triangles) return;
  std::array<char, kTriangle> triangle;
  for (std::uint32_t t = 0; in.read(triangle.data(), kTriangle); ++t) {
    std::array<float, 9> corners;  // after the normal
    std::memcpy(corners.data(), triangle.data() + 12, sizeof corners);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (!std::isfinite(corners[i])) {
        refuse(file, "vertex " + std::to_string(i / 3) + " of triangle " +
                         std::to_string(t) + " (counted from 0) isn't finite");
      }
    }
  }
}

/// What a file lists, as CGAL reads it.
struct Soup {
  SoupPoints points;
  SoupPolygons polygons;
};

void check(const std::filesystem::path& file, const Soup& soup) {
  const auto name = [](const char* what, std::size_t i) {
    return what + std::to_string(i) + " (counted from 0)";
  };
  for (std::size_t i = 0; i < soup.points.size(); ++i) {
    const auto& p = soup.points[i];
    if (!std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z())) {
      refuse(file, name("vertex ", i) + " isn't finite");
    }
  }
  for (std::size_t i = 0; i < soup.polygons.size(); ++i) {
    for (const std::size_t vertex : soup.polygons[i]) {
      if (vertex >= soup.points.size()) {
        refuse(file, name("face ", i) + " names a vertex that doesn't exist");
      }
    }
  }
}

/// What may have been meant by the name of a file that isn't there.
std::string meant(const std::filesystem::path& file) {
  std::string slashes = file.string();
  std::replace(slashes.begin(), slashes.end(), '\\', '/');
  if (slashes != file.string()) return "; folders are separated by '/'";
  const std::filesystem::path folder =
      file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
  std::error_code failed;
  if (!std::filesystem::is_directory(folder, failed))
    return "; there is no folder " + folder.string();
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder, failed))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  const std::string likely = nearest(file.filename().string(), names);
  return likely.empty() ? "" : "; did you mean '" + likely + "'?";
}

Soup read_soup(const std::filesystem::path& file,
               const std::function<void(double)>& progress) {
  const SoupReader read = reader_for(file);
  if (!std::filesystem::exists(file)) refuse(file, "no such file" + meant(file));
  if (!std::filesystem::is_regular_file(file)) refuse(file, "isn't a file");
  WatchedFile buffer(file, progress);
  std::istream in(&buffer);
  if (!buffer.is_open() || in.peek() == std::istream::traits_type::eof()) {
    refuse(file, "is empty or can't be read");
  }
  if (suffix_of(file) == ".stl") check_binary_stl(file);
  Soup soup;
  // No format spends less than two bytes on a vertex or a face.
  soup.points.limit = soup.polygons.limit = std::filesystem::file_size(file) / 2;
  bool understood = false;
  try {
    understood = read(in, soup.points, soup.polygons);
  } catch (const MeshProblem& problem) {
    refuse(file, problem.why);
  } catch (const std::length_error&) {
    refuse(file, "announces more than it holds");
  } catch (const std::bad_alloc&) {
    refuse(file, "doesn't fit into memory");
  }
  check(file, soup);
  if (!understood) refuse(file, reason(file, in.rdstate(), soup.polygons));
  return soup;
}

}  // namespace

TriangleMesh read_mesh(const std::filesystem::path& file,
                       const std::function<void(double)>& progress) {
  const Soup soup = read_soup(file, progress);
  TriangleMesh mesh;
  mesh.vertices.reserve(soup.points.size());
  for (const auto& p : soup.points) mesh.vertices.emplace_back(p.x(), p.y(), p.z());
  for (const auto& polygon : soup.polygons) {
    const auto corner = [&](std::size_t i) {
      return static_cast<std::uint32_t>(polygon[i]);
    };
    for (std::size_t i = 2; i < polygon.size(); ++i) {
      mesh.triangles.push_back({corner(0), corner(i - 1), corner(i)});
    }
  }
  if (mesh.triangles.empty()) refuse(file, "has no triangle");
  return mesh;
}

}  // namespace delos
