# Build two devices as their author would, then run the contract of devices on them, found
# by way of DELOS_PLUGIN_PATH.
file(REMOVE_RECURSE ${WORK})
if(TREE STREQUAL install)
  execute_process(COMMAND ${CMAKE_COMMAND} --install ${DELOS_BUILD} --prefix ${WORK}/prefix
    OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
  set(prefix ${WORK}/prefix)
else()
  set(prefix ${DELOS_BUILD})
endif()

execute_process(
  COMMAND ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR} -B ${WORK}/build
    -D CMAKE_PREFIX_PATH=${prefix} -D CMAKE_CXX_COMPILER=${COMPILER}
    -D CMAKE_BUILD_TYPE=${CONFIG} -D CMAKE_FIND_USE_PACKAGE_REGISTRY=OFF
  COMMAND_ERROR_IS_FATAL ANY)
file(STRINGS ${WORK}/build/CMakeCache.txt found REGEX "^delos_DIR:")
if(NOT found MATCHES "=${prefix}/")
  message(FATAL_ERROR "found another Delos: ${found}")
endif()
execute_process(COMMAND ${CMAKE_COMMAND} --build ${WORK}/build COMMAND_ERROR_IS_FATAL ANY)

set(ENV{DELOS_PLUGIN_PATH} ${WORK}/build/lib/delos)
foreach(device range_beacon biased_beacon)
  execute_process(COMMAND ${CONTRACT_TEST} --gtest_filter=*${device}*
    OUTPUT_VARIABLE output ECHO_OUTPUT_VARIABLE COMMAND_ERROR_IS_FATAL ANY)
  # A filter that meets no test is a success to GoogleTest.
  if(NOT output MATCHES "PASSED  . [1-9][0-9]* tests")
    message(FATAL_ERROR "the contract met no device ${device}")
  endif()
endforeach()
