// One name, one thing: what two headers of one namespace define under one name is
// undefined behaviour as soon as a program links both.
#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <set>

#include "sources.h"

namespace delos::test {
namespace {

/// Comments and texts as blanks, so that braces and words in them don't count.
std::string code_of(const std::string& text) {
  static const std::regex kNoCode(
      R"re(//[^\n]*|/\*[^]*?\*/|"(?:[^"\\\n]|\\.)*"|'(?:[^'\\\n]|\\.)*')re");
  return std::regex_replace(text, kNoCode, " ");
}

/// Types that a source defines in a named namespace, as "delos::riccati::UpdateMap".
/// What stands in a class, a function or an unnamed namespace is its own affair.
std::vector<std::string> types_in(const std::string& text) {
  static const std::regex kToken(
      R"re(namespace\s+([\w:]*)\s*\{|(?:struct|class|enum class|enum)\s+(?:DELOS_API\s+)?(\w+)\s*(?:final\s*)?(?:<[^;{}]*>)?\s*(?::(?!:)[^;{}]*)?\{|\{|\})re");
  const std::string code = code_of(text);
  std::vector<std::string> found;
  std::vector<std::string> scopes;  // names of namespaces; empty: anything else
  for (std::sregex_iterator i(code.begin(), code.end(), kToken), end; i != end; ++i) {
    if (i->str() == "}") {
      if (!scopes.empty()) scopes.pop_back();
      continue;
    }
    bool named = true;
    std::string path;
    for (const std::string& scope : scopes) {
      named = named && !scope.empty();
      path += scope + "::";
    }
    if ((*i)[2].matched && named) found.push_back(path + (*i)[2].str());
    scopes.push_back((*i)[1].matched ? (*i)[1].str() : std::string());
  }
  return found;
}

TEST(Names, AreFoundInTheirNamespaces) {
  const std::vector<std::string> expected = {"a::b::One", "a::Two", "a::Three"};
  EXPECT_EQ(
      types_in("namespace a::b { struct One { struct Inner {}; }; }\n"
               "namespace a { namespace { struct Hidden {}; }\n"
               "class DELOS_API Two final : public One { int x{}; }; // struct No {}\n"
               "enum class Three { x }; struct Declared; void f() { struct L {}; } }"),
      expected);
}

TEST(Names, AreDefinedOnce) {
  std::map<std::string, std::set<std::string>> homes;
  for (const char* folder : {"kernel", "optimizers", "explorer"}) {
    for (const Source& source : sources(folder)) {
      for (const std::string& name : types_in(source.text))
        homes[name].insert(source.path);
    }
  }
  EXPECT_GE(homes.size(), 250u);  // enough to know that they are read
  for (const auto& [name, files] : homes) {
    std::string list;
    for (const std::string& file : files) list += " " + file;
    EXPECT_EQ(files.size(), 1u) << name << " is defined in" << list;
  }
}

/// With its folder on the include path, a header of such a name is found in place of
/// the library's, and nothing compiles.
TEST(Names, OfHeadersAreNotThoseOfTheCLibrary) {
  const std::set<std::string> taken = {
      "assert.h", "complex.h", "ctype.h",    "errno.h",  "fenv.h",   "float.h",
      "limits.h", "locale.h",  "math.h",     "setjmp.h", "signal.h", "stdarg.h",
      "stddef.h", "stdint.h",  "stdio.h",    "stdlib.h", "string.h", "tgmath.h",
      "time.h",   "uchar.h",   "wchar.h",    "wctype.h", "values.h", "search.h",
      "memory.h", "strings.h", "semaphore.h"};
  for (const char* folder : {"kernel/src", "optimizers", "explorer", "plugins"}) {
    for (const Source& source : sources(folder)) {
      const std::string name = source.path.substr(source.path.rfind('/') + 1);
      const bool in_public = source.path.find("/include/delos/") != std::string::npos;
      EXPECT_TRUE(in_public || taken.count(name) == 0) << source.path;
    }
  }
}

}  // namespace
}  // namespace delos::test
