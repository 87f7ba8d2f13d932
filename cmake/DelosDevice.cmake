# delos_add_device(<id> <sources>...)
#   Build <sources> into the loadable device plugin <id>.so and put it into lib/delos of the
#   build tree; installed, it goes to lib/delos too. That is where the kernel of the same
#   tree looks; of others, DELOS_PLUGIN_PATH tells it. The contract tests that every device
#   obeys run on all of them, with the parameters of plugins/<id>/example.yaml: a list of
#   maps, needed where parameters have no default.
include(GNUInstallDirs)

function(delos_add_device id)
  add_library(delos_device_${id} MODULE ${ARGN})
  target_link_libraries(delos_device_${id} PRIVATE delos::kernel)
  # As the kernel is built: no fused operations, which differ by machine, and nothing that
  # keeps loops from vector instructions.
  target_compile_options(delos_device_${id} PRIVATE
    -ffp-contract=off -fno-math-errno -fno-trapping-math)
  set_target_properties(delos_device_${id} PROPERTIES
    OUTPUT_NAME ${id} PREFIX ""
    CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON
    LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/lib/delos)
  target_link_options(delos_device_${id} PRIVATE LINKER:--no-undefined)
  install(TARGETS delos_device_${id} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/delos
    COMPONENT runtime)
  set_property(GLOBAL APPEND PROPERTY DELOS_DEVICES ${id})
endfunction()

# delos_add_contract_test(<id> <examples>)
#   The contract that every device obeys, on one device of this project, as a test of
#   ctest. <examples> is a file with a list of maps of parameters. Without GoogleTest and
#   yaml-cpp there is a message and no test.
function(delos_add_contract_test id examples)
  find_package(GTest QUIET)
  find_package(yaml-cpp QUIET)
  if(NOT GTest_FOUND OR NOT yaml-cpp_FOUND)
    message(STATUS "No contract test of ${id}: it needs GoogleTest and yaml-cpp")
    return()
  endif()
  configure_file(${examples} contract/${id}/example.yaml COPYONLY)
  set(test ${id}_contract_test)
  add_executable(${test} ${DELOS_CONTRACT_FOLDER}/device/contract_test.cpp
    ${DELOS_CONTRACT_FOLDER}/device/devices.cpp ${DELOS_CONTRACT_FOLDER}/support/heap_count.cpp)
  target_include_directories(${test} PRIVATE ${DELOS_CONTRACT_FOLDER})
  target_compile_definitions(${test} PRIVATE
    DELOS_DEVICES="${id}" DELOS_PLUGIN_SOURCES="${CMAKE_CURRENT_BINARY_DIR}/contract")
  target_link_libraries(${test} PRIVATE delos::kernel GTest::gtest_main yaml-cpp)
  # Plugins must find this program's malloc before the C library's.
  set_target_properties(${test} PROPERTIES ENABLE_EXPORTS ON)
  add_test(NAME ${test} COMMAND ${test} --gtest_filter=*/${id}_*)
  # A filter that meets no test is a success to GoogleTest.
  set_tests_properties(${test} PROPERTIES
    ENVIRONMENT DELOS_PLUGIN_PATH=${CMAKE_BINARY_DIR}/lib/delos
    FAIL_REGULAR_EXPRESSION "Running 0 tests")
endfunction()
