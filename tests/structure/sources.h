// The source tree as text.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace delos::test {

/// A source or header.
struct Source {
  std::string path;  ///< from the root: "kernel/src/scene/io.cpp"
  std::string text;
};

/// One #include line.
struct Include {
  std::string file;    ///< what is included
  bool quoted = true;  ///< "file" rather than <file>
};

/// The root of the source tree.
std::filesystem::path root();

/// All .h and .cpp files below a folder of the root, sorted.
std::vector<Source> sources(const std::string& folder);

std::vector<Include> includes(const Source& source);

std::string read(const std::filesystem::path& file);

}  // namespace delos::test
