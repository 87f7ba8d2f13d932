#include "geometry/mesh/mesh_files.h"

#include <exception>

namespace delos {

MeshFiles::File& MeshFiles::read(const std::filesystem::path& file) {
  const auto [at, is_new] = files_.try_emplace(file.lexically_normal());
  if (!is_new) return at->second;
  try {
    std::function<void(double)> progress;
    if (progress_) progress = [&](double fraction) { progress_(file, fraction); };
    at->second.mesh = std::make_shared<const TriangleMesh>(read_mesh(file, progress));
  } catch (const std::exception& e) {
    at->second.problem = e.what();
  }
  return at->second;
}

}  // namespace delos
