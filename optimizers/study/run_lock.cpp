#include "study/run_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>
#include <system_error>

namespace delos {

// A file of its own: SQLite's own locks on the study would be lost with any descriptor
// of it that is closed.
RunLock::RunLock(const std::filesystem::path& study)
    : descriptor_(open((study.string() + ".lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC,
                       0644)) {
  if (descriptor_ < 0)
    throw std::runtime_error(study.string() +
                             ".lock: " + std::generic_category().message(errno));
  if (flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return;
  close(descriptor_);
  throw std::runtime_error(
      study.string() + " is being searched by another process; stop that one first");
}

RunLock::~RunLock() { close(descriptor_); }

}  // namespace delos
