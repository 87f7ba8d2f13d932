#include "session/new_device.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "session/shipped_scenes.h"

namespace delos::session {
namespace {

/// Patterns, and what they become; '@' stands for the id.
constexpr std::pair<const char*, const char*> kPatterns[] = {
    {"device.cpp", "@.cpp"},
    {"CMakeLists.txt", "CMakeLists.txt"},
    {"example.yaml", "example.yaml"},
    {"scene.yaml", "scene.yaml"},
    {"README.md", "README.md"}};

bool is_id(const std::string& id) {
  const auto is_letter = [](char c) { return c >= 'a' && c <= 'z'; };
  return !id.empty() && is_letter(id[0]) &&
         std::all_of(id.begin(), id.end(), [&](char c) {
           return is_letter(c) || (c >= '0' && c <= '9') || c == '_';
         });
}

/// my_sensor → MySensor
std::string class_name(const std::string& id) {
  std::string name;
  bool first = true;
  for (const char c : id) {
    if (c != '_')
      name +=
          first ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    first = c == '_';
  }
  return name;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos;
       at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

}  // namespace

NewDevice write_new_device(const std::string& id, const std::filesystem::path& folder) {
  if (!is_id(id))
    throw std::runtime_error("'" + id +
                             "' isn't an id: small letters, digits and '_', a letter "
                             "first, such as my_sensor");
  const Installation installation = this_installation();
  NewDevice made{{}, installation.prefix};
  for (const auto& [from, to] : kPatterns) {
    made.files.push_back(folder / replaced(to, "@", id));
    if (std::filesystem::exists(made.files.back()))
      throw std::runtime_error(made.files.back().string() +
                               " is there already; nothing was written");
  }
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw std::runtime_error(folder.string() + " can't be made: " + error.message());
  for (std::size_t i = 0; i < made.files.size(); ++i) {
    std::ifstream in(installation.shared("new_device", "cmake/new_device") /
                     kPatterns[i].first);
    std::stringstream text;
    text << in.rdbuf();
    std::ofstream out(made.files[i]);
    out << replaced(
        replaced(replaced(text.str(), "@ID@", id), "@CLASS@", class_name(id)),
        "@PREFIX@", made.prefix.string());
    if (!in || !out.flush())
      throw std::runtime_error(made.files[i].string() + " can't be written");
  }
  return made;
}

}  // namespace delos::session
