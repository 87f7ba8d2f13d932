# delos_add_device(<id> <sources>...)
#   Build <sources> into the loadable device plugin <id>.so and put it where the kernel
#   looks for plugins. The contract tests that every device obeys run on all of them.
function(delos_add_device id)
  add_library(delos_device_${id} MODULE ${ARGN})
  target_link_libraries(delos_device_${id} PRIVATE delos::kernel)
  set_target_properties(delos_device_${id} PROPERTIES
    OUTPUT_NAME ${id} PREFIX ""
    CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON
    LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/lib/delos)
  target_link_options(delos_device_${id} PRIVATE LINKER:--no-undefined)
  set_property(GLOBAL APPEND PROPERTY DELOS_DEVICES ${id})
endfunction()
