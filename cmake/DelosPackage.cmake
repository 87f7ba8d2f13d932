# find_package(delos) for devices out of the tree, alike from the build tree, which needs
# no installing, and from an install tree.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/delos)
set(built_package ${PROJECT_BINARY_DIR}/lib/cmake/delos)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/delosConfig.cmake.in
  ${built_package}/delosConfig.cmake INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${built_package}/delosConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
configure_file(${PROJECT_SOURCE_DIR}/cmake/DelosDevice.cmake ${built_package} COPYONLY)

set_target_properties(delos_kernel PROPERTIES EXPORT_NAME kernel)
install(TARGETS delos_kernel EXPORT delosTargets
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT runtime)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/kernel/include/delos
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT dev)
install(DIRECTORY ${built_package}/ DESTINATION ${package_folder} COMPONENT dev
  PATTERN delosTargets*.cmake EXCLUDE)
# What a device of a project of its own is tested by: delos_add_contract_test().
set(contract ${PROJECT_SOURCE_DIR}/tests)
install(FILES ${contract}/device/contract_test.cpp ${contract}/device/devices.cpp
  ${contract}/device/devices.h
  DESTINATION share/delos/contract/device COMPONENT dev)
install(FILES ${contract}/support/heap_count.cpp ${contract}/support/heap_count.h
  DESTINATION share/delos/contract/support COMPONENT dev)
install(EXPORT delosTargets NAMESPACE delos:: DESTINATION ${package_folder} COMPONENT dev)
export(EXPORT delosTargets NAMESPACE delos:: FILE ${built_package}/delosTargets.cmake)
