#include "delos/document/file_commit.h"

#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <system_error>

namespace delos {
namespace {

namespace fs = std::filesystem;

std::string refused(const fs::path& file, const std::string& step, int error) {
  std::string sentence = file.string() + ": " + step;
  // A stream may fail without the system having said why.
  if (error != 0) sentence += ": " + std::generic_category().message(error);
  return sentence;
}

/// Where the bytes go: the end of a chain of symbolic links, or the file itself.
fs::path link_target(const fs::path& file) {
  std::error_code error;
  if (!fs::is_symlink(file, error)) return file;
  const fs::path target = fs::canonical(file, error);
  return error ? file : target;
}

/// @returns whether every byte went out; where not, errno may say why.
bool write_all(const fs::path& file, const std::function<void(std::ostream&)>& fill) {
  std::ofstream stream(file, std::ios::binary | std::ios::trunc);
  if (!stream) return false;
  fill(stream);
  // A full disk may show as late as here: the last buffer leaves on flush and close.
  stream.flush();
  stream.close();
  return !stream.fail();
}

}  // namespace

std::string missing_folder(const fs::path& file) {
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path{"."};
  std::error_code error;
  if (fs::is_directory(folder, error)) return {};
  return file.string() + ": the folder " + folder.string() +
         (fs::exists(folder, error) ? " is a file, not a folder"
                                    : " doesn't exist; create it first");
}

std::string commit_file(const fs::path& file,
                        const std::function<void(std::ostream&)>& fill) {
  const fs::path target = link_target(file);
  std::error_code ignored;
  if (fs::is_other(target, ignored)) {
    // A pipe or a device can't be replaced as a whole: what is asked for is to fill it.
    errno = 0;
    return write_all(target, fill) ? "" : refused(file, "can't be written", errno);
  }
  fs::path temporary = target.parent_path() / ".";
  temporary += target.filename();
  temporary += ".tmp-" + std::to_string(::getpid());

  errno = 0;
  if (!write_all(temporary, fill)) {
    const int error = errno;
    fs::remove(temporary, ignored);
    return refused(file, "can't be written", error);
  }
  std::error_code error;
  fs::rename(temporary, target, error);
  if (!error) return {};
  fs::remove(temporary, ignored);
  return refused(file, "can't be replaced", error.value());
}

}  // namespace delos
