// One process searches a study at a time.
#pragma once

#include <filesystem>

namespace delos {

/// Held while it lives; the system lets go of it when the process ends, however.
class RunLock {
 public:
  /// @throws std::runtime_error another process holds it
  explicit RunLock(const std::filesystem::path& study);
  ~RunLock();
  RunLock(const RunLock&) = delete;
  RunLock& operator=(const RunLock&) = delete;

 private:
  int descriptor_;
};

}  // namespace delos
