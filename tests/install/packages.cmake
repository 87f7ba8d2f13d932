# Packages made, unpacked into a root of their own, and used there.
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK}/root)
execute_process(COMMAND ${CPACK} -G DEB --config ${CONFIG} -B ${WORK}/made
  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(GLOB packages ${WORK}/made/*.deb)
foreach(package ${packages})
  execute_process(COMMAND ${DPKG} -x ${package} ${WORK}/root COMMAND_ERROR_IS_FATAL ANY)
endforeach()
list(LENGTH packages count)
if(count LESS 3)
  message(FATAL_ERROR "there are ${count} packages: ${packages}")
endif()
# What each needs is named by dpkg's own search for shared libraries.
file(GLOB runtime ${WORK}/made/delos_*.deb)
execute_process(COMMAND ${DPKG} -f ${runtime} Depends OUTPUT_VARIABLE needs COMMAND_ERROR_IS_FATAL ANY)
foreach(library libnlopt libcairo2 libyaml-cpp)
  if(NOT needs MATCHES ${library})
    message(FATAL_ERROR "delos needs ${library}, but says: ${needs}")
  endif()
endforeach()

set(usr ${WORK}/root/usr)
set(delos ${usr}/bin/delos)
execute_process(COMMAND ${delos} demo --out ${WORK}/demo.png
  OUTPUT_VARIABLE demo COMMAND_ERROR_IS_FATAL ANY)
if(NOT demo MATCHES "root/usr/share/delos/scenes/05-optitrack-lab.yaml" OR NOT EXISTS ${WORK}/demo.png)
  message(FATAL_ERROR "the demo isn't the installed one: ${demo}")
endif()
foreach(file share/man/man1/delos.1 share/bash-completion/completions/delos)
  file(READ ${usr}/${file} text)
  if(NOT text MATCHES "tradeoff")
    message(FATAL_ERROR "${file} knows no tradeoff")
  endif()
endforeach()

# A device of one's own against the packages.
execute_process(COMMAND ${delos} new-device my_sensor ${WORK}/my_sensor
  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} -S ${WORK}/my_sensor -B ${WORK}/my_sensor/build
    -D CMAKE_PREFIX_PATH=${usr} -D CMAKE_CXX_COMPILER=${COMPILER}
    -D CMAKE_FIND_USE_PACKAGE_REGISTRY=OFF
  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${WORK}/my_sensor/build --target delos_device_my_sensor
  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${delos} field ${WORK}/my_sensor/scene.yaml
    --plugin-dir ${WORK}/my_sensor/build/lib/delos
  OUTPUT_VARIABLE field COMMAND_ERROR_IS_FATAL ANY)
if(NOT field MATCHES "819 samples, 819 observable")
  message(FATAL_ERROR "the field isn't that of its scene: ${field}")
endif()

if(PYTHON)
  set(program "import delos\nprint(delos.field('${usr}/share/delos/scenes/01-acoustic.yaml').mean)")
  execute_process(
    COMMAND ${CMAKE_COMMAND} -E env PYTHONPATH=${usr}/lib/python3/dist-packages
      ${PYTHON} -c "${program}"
    OUTPUT_VARIABLE mean COMMAND_ERROR_IS_FATAL ANY)
  if(NOT mean MATCHES "^0.0418916534146")
    message(FATAL_ERROR "Python says ${mean}")
  endif()
endif()
