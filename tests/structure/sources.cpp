#include "sources.h"

#include <algorithm>
#include <fstream>
#include <regex>
#include <sstream>

namespace delos::test {

std::filesystem::path root() { return DELOS_ROOT; }

std::string read(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

std::vector<Source> sources(const std::string& folder) {
  std::vector<Source> list;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(root() / folder)) {
    const std::string suffix = entry.path().extension().string();
    if (suffix != ".h" && suffix != ".cpp") continue;
    list.push_back(
        {entry.path().lexically_relative(root()).generic_string(), read(entry.path())});
  }
  std::sort(list.begin(), list.end(),
            [](const Source& a, const Source& b) { return a.path < b.path; });
  return list;
}

std::vector<Include> includes(const Source& source) {
  static const std::regex kLine(R"re(^\s*#\s*include\s*([<"])([^>"]+)[>"])re");
  std::vector<Include> list;
  std::istringstream lines(source.text);
  for (std::string line; std::getline(lines, line);) {
    std::smatch match;
    if (std::regex_search(line, match, kLine)) {
      list.push_back({match[2].str(), match[1].str() == "\""});
    }
  }
  return list;
}

}  // namespace delos::test
