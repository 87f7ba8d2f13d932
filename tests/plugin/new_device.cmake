# What a newcomer types: a project of his own, built against an installation, tested, and
# its field.
file(REMOVE_RECURSE ${WORK})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${DELOS_BUILD} --prefix ${WORK}/prefix
  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
set(folder ${WORK}/my_sensor)
execute_process(COMMAND ${PROGRAM} new-device my_sensor ${folder}
  OUTPUT_VARIABLE typed COMMAND_ERROR_IS_FATAL ANY)
if(NOT typed MATCHES "cmake -S ${folder} -B ${folder}/build -D CMAKE_PREFIX_PATH=${DELOS_BUILD}\n")
  message(FATAL_ERROR "new-device doesn't say how to build: ${typed}")
endif()

execute_process(
  COMMAND ${CMAKE_COMMAND} -S ${folder} -B ${folder}/build
    -D CMAKE_PREFIX_PATH=${WORK}/prefix -D CMAKE_CXX_COMPILER=${COMPILER}
    -D CMAKE_FIND_USE_PACKAGE_REGISTRY=OFF
  COMMAND_ERROR_IS_FATAL ANY)
file(STRINGS ${folder}/build/CMakeCache.txt found REGEX "^delos_DIR:")
if(NOT found MATCHES "=${WORK}/prefix/")
  message(FATAL_ERROR "found another Delos: ${found}")
endif()
execute_process(COMMAND ${CMAKE_COMMAND} --build ${folder}/build COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_CTEST_COMMAND} --test-dir ${folder}/build --no-tests=error
    --output-on-failure
  COMMAND_ERROR_IS_FATAL ANY)

set(see ${folder}/scene.yaml --plugin-dir ${folder}/build/lib/delos)
execute_process(COMMAND ${PROGRAM} field ${see} --out ${folder}/field.png
  OUTPUT_VARIABLE field COMMAND_ERROR_IS_FATAL ANY)
if(NOT field MATCHES "819 samples, 819 observable" OR NOT EXISTS ${folder}/field.png)
  message(FATAL_ERROR "the field isn't that of its scene: ${field}")
endif()
execute_process(COMMAND ${PROGRAM} optimize ${see} --evaluations 30
  OUTPUT_VARIABLE search COMMAND_ERROR_IS_FATAL ANY)
if(NOT search MATCHES "evaluations with slopes")
  message(FATAL_ERROR "the search had no slopes: ${search}")
endif()
