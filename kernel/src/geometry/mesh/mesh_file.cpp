// Mesh files, by CGAL's readers.
#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
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
#include "geometry/mesh/kernel.h"

namespace delos {
namespace {

/// A vector that grows at once to what a file can hold, but not to what it claims: CGAL
/// makes room for as many vertices, faces and corners as the file announces.
template <class T>
struct Claimed : std::vector<T> {
  std::size_t limit = 1'000'000;

  void resize(std::size_t n) {
    if (n > limit) throw std::length_error("announced");
    std::vector<T>::resize(n);
  }
};

using Points = Claimed<Kernel::Point_3>;
using Polygons = Claimed<Claimed<std::size_t>>;
using Reader = bool (*)(std::istream&, Points&, Polygons&);

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

Reader reader_for(const std::filesystem::path& file) {
  const std::string suffix = suffix_of(file);
  if (suffix == ".off") {
    return [](std::istream& in, Points& p, Polygons& f) {
      return CGAL::IO::read_OFF(in, p, f);
    };
  }
  if (suffix == ".obj") {
    return [](std::istream& in, Points& p, Polygons& f) {
      return CGAL::IO::read_OBJ(in, p, f);
    };
  }
  if (suffix == ".ply") {
    return [](std::istream& in, Points& p, Polygons& f) {
      return CGAL::IO::read_PLY(in, p, f, CGAL::parameters::verbose(false));
    };
  }
  if (suffix == ".stl") {
    return [](std::istream& in, Points& p, Polygons& f) {
      return CGAL::IO::read_STL(in, p, f);
    };
  }
  refuse(file, "the suffix '" + file.extension().string() +
                   "' isn't one of .off, .obj, .ply and .stl");
}

/// Why a file that CGAL's reader refused is wrong, as far as can be told.
std::string reason(const std::filesystem::path& file, std::ios::iostate state,
                   const Polygons& polygons) {
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
  Points points;
  Polygons polygons;
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

Soup read_soup(const std::filesystem::path& file,
               const std::function<void(double)>& progress) {
  const Reader read = reader_for(file);
  if (!std::filesystem::exists(file)) refuse(file, "no such file");
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
