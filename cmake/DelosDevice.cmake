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
  install(TARGETS delos_device_${id} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/delos)
  set_property(GLOBAL APPEND PROPERTY DELOS_DEVICES ${id})
endfunction()
