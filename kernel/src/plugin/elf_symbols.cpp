#include "plugin/elf_symbols.h"

#include <link.h>

#include <cstring>
#include <fstream>
#include <vector>

namespace delos {
namespace {

/// Read `count` records at an offset; false where the file ends before them.
template <class T>
bool read_at(std::ifstream& file, std::uint64_t offset, std::uint64_t count,
             std::vector<T>& out) {
  file.seekg(0, std::ios::end);
  const auto size = static_cast<std::uint64_t>(file.tellg());
  if (offset > size || count > (size - offset) / sizeof(T)) return false;
  out.resize(count);
  file.seekg(static_cast<std::streamoff>(offset));
  file.read(reinterpret_cast<char*>(out.data()),
            static_cast<std::streamsize>(count * sizeof(T)));
  return file.good();
}

bool is_shared_library(const ElfW(Ehdr) & header) {
  return std::memcmp(header.e_ident, ELFMAG, SELFMAG) == 0 &&
         header.e_ident[EI_CLASS] == (sizeof(void*) == 8 ? ELFCLASS64 : ELFCLASS32) &&
         header.e_type == ET_DYN && header.e_shentsize == sizeof(ElfW(Shdr));
}

bool defines(const ElfW(Sym) & entry, const std::vector<char>& names,
             std::string_view symbol) {
  if (entry.st_shndx == SHN_UNDEF || entry.st_name >= names.size()) return false;
  const char* name = names.data() + entry.st_name;
  return std::string_view(name, strnlen(name, names.size() - entry.st_name)) == symbol;
}

}  // namespace

LibraryFile inspect_library(const std::filesystem::path& file,
                            std::string_view symbol) {
  std::error_code error;
  if (std::filesystem::exists(file, error) &&
      !std::filesystem::is_regular_file(file, error))
    return LibraryFile::not_a_library;  // nor is it opened: a pipe would never answer
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return LibraryFile::unreadable;

  std::vector<ElfW(Ehdr)> header;
  std::vector<ElfW(Shdr)> sections;
  if (!read_at(stream, 0, 1, header) || !is_shared_library(header[0]) ||
      !read_at(stream, header[0].e_shoff, header[0].e_shnum, sections)) {
    return LibraryFile::not_a_library;
  }
  for (const ElfW(Shdr) & section : sections) {
    if (section.sh_type != SHT_DYNSYM) continue;
    std::vector<ElfW(Sym)> entries;
    std::vector<char> names;
    if (section.sh_link >= sections.size() ||
        !read_at(stream, section.sh_offset, section.sh_size / sizeof(ElfW(Sym)),
                 entries) ||
        !read_at(stream, sections[section.sh_link].sh_offset,
                 sections[section.sh_link].sh_size, names)) {
      return LibraryFile::not_a_library;
    }
    for (const ElfW(Sym) & entry : entries) {
      if (defines(entry, names, symbol)) return LibraryFile::exports;
    }
  }
  return LibraryFile::lacks_symbol;
}

}  // namespace delos
