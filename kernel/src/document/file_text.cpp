#include "document/file_text.h"

#include <cerrno>
#include <fstream>
#include <iterator>
#include <system_error>

namespace delos {

std::optional<std::string> file_text(const std::filesystem::path& file,
                                     std::string& why) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (error) {
    why = error.message();
    return std::nullopt;
  }
  if (!std::filesystem::is_regular_file(status) && std::filesystem::exists(status)) {
    why = std::filesystem::is_directory(status) ? "it is a folder" : "it isn't a file";
    return std::nullopt;
  }
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    why = std::generic_category().message(errno);
    return std::nullopt;
  }
  return std::string{std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace delos
