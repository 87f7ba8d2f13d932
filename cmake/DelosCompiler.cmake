# How every binary of the project is compiled: language, warnings, reproducible floating
# point, sanitizers and the folders that the products go to.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()

set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/lib)

# Same input, same bytes: no contraction into fused operations, which differ by machine.
# Nobody reads errno or floating-point traps: without them, loops become vector instructions.
add_compile_options(-ffp-contract=off -fno-math-errno -fno-trapping-math -Wall -Wextra -Wpedantic -Wshadow=local)
# Known false alarms of GCC 12 in inlined library code.
add_compile_options(-Wno-restrict -Wno-maybe-uninitialized)
# Designated initialisers leave out what keeps its default: that is their use.
add_compile_options(-Wno-missing-field-initializers)

if(DELOS_SANITIZE)
  # Without what the address sanitizer and the processor see anyhow, whose checks of every
  # access are a third of the time that compiling takes.
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=undefined
                      -fno-sanitize=null,alignment,object-size,vptr
                      -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
endif()
