#include "bundle/page_file.h"

#include <cstddef>

// The bytes of a file of the bundle between two labels of the read-only data.
#define DELOS_PAGE_FILE(label, name)                                           \
  __asm__(".section .rodata\n" #label                                          \
          "_begin:\n"                                                          \
          ".incbin \"" DELOS_PAGE_FOLDER "/" name "\"\n" #label                \
          "_end:\n"                                                            \
          ".previous\n");                                                      \
  extern "C" const char label##_begin[] __attribute__((visibility("hidden"))); \
  extern "C" const char label##_end[] __attribute__((visibility("hidden")))

DELOS_PAGE_FILE(delos_page_index, "index.html");
DELOS_PAGE_FILE(delos_page_script, "explorer.js");
DELOS_PAGE_FILE(delos_page_style, "explorer.css");
DELOS_PAGE_FILE(delos_page_icon, "icon.svg");
DELOS_PAGE_FILE(delos_page_licences, "licences.txt");

namespace delos::bundle {

std::optional<PageFile> page_file(std::string_view path) {
  struct Row {
    std::string_view path, type;
    const char *begin, *end;
  };
  static const Row kTable[] = {
      {"/", "text/html; charset=utf-8", delos_page_index_begin, delos_page_index_end},
      {"/explorer.js", "text/javascript; charset=utf-8", delos_page_script_begin,
       delos_page_script_end},
      {"/explorer.css", "text/css; charset=utf-8", delos_page_style_begin,
       delos_page_style_end},
      {"/icon.svg", "image/svg+xml", delos_page_icon_begin, delos_page_icon_end},
      {"/licences.txt", "text/plain; charset=utf-8", delos_page_licences_begin,
       delos_page_licences_end},
  };
  for (const Row& row : kTable)
    if (row.path == path)
      return PageFile{row.type,
                      {row.begin, static_cast<std::size_t>(row.end - row.begin)}};
  return std::nullopt;
}

}  // namespace delos::bundle
