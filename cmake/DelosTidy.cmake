# The target `tidy`: clang-tidy, told by .clang-tidy, over every unit of the build. What
# only the tests of broken plugins and of single headers compile is left out, and the
# explorer's server: Clang 14 reads no coroutines of Boost.Asio.
find_program(DELOS_RUN_CLANG_TIDY run-clang-tidy REQUIRED)
# Where GCC keeps <omp.h>, after all folders of Clang's own.
execute_process(COMMAND ${CMAKE_CXX_COMPILER} -print-file-name=include
  OUTPUT_VARIABLE compiler_headers OUTPUT_STRIP_TRAILING_WHITESPACE)
add_custom_target(tidy
  COMMAND ${DELOS_RUN_CLANG_TIDY} -p ${PROJECT_BINARY_DIR} -quiet
    -extra-arg=-idirafter${compiler_headers} -extra-arg=-Wno-unknown-warning-option
    "^(?!.*/(alone|bad|server|delos_server.dir)/)"
  WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} USES_TERMINAL VERBATIM)
