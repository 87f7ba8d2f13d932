// The mesh files of a scene: each is read once.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "delos/geometry/mesh.h"

namespace delos {

class MeshFiles {
 public:
  struct File {
    std::shared_ptr<const TriangleMesh> mesh;  ///< null where it can't be read
    std::string problem;         ///< then: a sentence that starts with the file
    bool defects_known = false;  ///< they have been looked for and reported
  };

  explicit MeshFiles(MeshProgress progress = {}) : progress_(std::move(progress)) {}

  /// @returns what came of reading it now or earlier; stays where it is.
  File& read(const std::filesystem::path& file);

 private:
  MeshProgress progress_;
  std::map<std::filesystem::path, File> files_;
};

}  // namespace delos
