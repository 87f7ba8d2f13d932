// Marks what the kernel's shared library promises to plugins and programs.
#pragma once

#if defined(_WIN32)
#error "Delos builds on systems with ELF shared libraries."
#endif

/// Visible outside the shared library that defines it.
#define DELOS_API __attribute__((visibility("default")))
