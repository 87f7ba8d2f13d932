// Reads what a shared library exports, without opening it as code.
#pragma once

#include <filesystem>
#include <string_view>

namespace delos {

/// What a file turned out to be.
enum class LibraryFile {
  exports,        ///< a shared library that defines the symbol
  lacks_symbol,   ///< a shared library that doesn't
  not_a_library,  ///< something else, or cut short
  unreadable,     ///< errno says why
};

/// Look for a symbol in the table that the dynamic linker uses. No code of the library
/// runs, every offset is checked.
///
/// boost::dll::library_info isn't used: up to Boost 1.74 at least it reads .symtab,
/// which stripped libraries lack, and takes the names from whichever string table is
/// last.
///
/// Source: System V ABI, edition 4.1, chapter 4, "Symbol Table".
[[nodiscard]] LibraryFile inspect_library(const std::filesystem::path& file,
                                          std::string_view symbol);

}  // namespace delos
