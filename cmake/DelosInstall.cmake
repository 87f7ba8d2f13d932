# What an installation has, in four parts: the program with its plugins and scenes, what
# devices of one's own are built with, the Python package, the manual. `cpack` makes a
# .deb of each.
include(GNUInstallDirs)
# What is built is what is installed: packing doesn't build tests.
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)

# Programs and libraries find the kernel wherever the tree is put.
set_target_properties(delos_program PROPERTIES
  INSTALL_RPATH "$ORIGIN/../${CMAKE_INSTALL_LIBDIR}")
install(TARGETS delos_program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT runtime)
install(DIRECTORY scenes DESTINATION share/delos COMPONENT runtime)
install(DIRECTORY cmake/new_device DESTINATION share/delos COMPONENT dev)

# What the program wrote of itself when it was built.
set(written ${PROJECT_BINARY_DIR}/share)
install(FILES ${written}/delos.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT runtime)
install(FILES ${written}/delos.bash DESTINATION share/bash-completion/completions
  RENAME delos COMPONENT runtime)

install(DIRECTORY docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT doc)
install(FILES README.md LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT runtime)

if(TARGET delos_python)
  # Where Debian's interpreter looks.
  set(packages lib/python3/dist-packages/delos)
  cmake_path(RELATIVE_PATH CMAKE_INSTALL_LIBDIR BASE_DIRECTORY ${packages} OUTPUT_VARIABLE to_kernel)
  set_target_properties(delos_python PROPERTIES INSTALL_RPATH "$ORIGIN/${to_kernel}")
  install(TARGETS delos_python LIBRARY DESTINATION ${packages} COMPONENT python)
  install(DIRECTORY python/delos/ DESTINATION ${packages} COMPONENT python)
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME delos)
set(CPACK_PACKAGE_CONTACT "The Delos developers <delos@localhost>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL runtime dev doc)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS ON)
set(CPACK_COMPONENT_RUNTIME_DESCRIPTION "${PROJECT_DESCRIPTION}: program, plugins and scenes")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME delos)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_DEPENDS fonts-dejavu-core)
set(CPACK_COMPONENT_DEV_DESCRIPTION "What devices of one's own are built with")
set(CPACK_COMPONENT_DEV_DEPENDS runtime)
set(CPACK_DEBIAN_DEV_PACKAGE_NAME delos-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "libeigen3-dev, cmake, g++")
set(CPACK_COMPONENT_DOC_DESCRIPTION "The manual of Delos")
set(CPACK_DEBIAN_DOC_PACKAGE_NAME delos-doc)
if(TARGET delos_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
  set(CPACK_COMPONENT_PYTHON_DESCRIPTION "Delos from Python")
  set(CPACK_COMPONENT_PYTHON_DEPENDS runtime)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-delos)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3, python3-numpy")
endif()
if(TARGET delos_crew_mpi)
  list(APPEND CPACK_COMPONENTS_ALL mpi)
  set(CPACK_COMPONENT_MPI_DESCRIPTION "Searches by many machines, with Open MPI")
  set(CPACK_COMPONENT_MPI_DEPENDS runtime)
  set(CPACK_DEBIAN_MPI_PACKAGE_NAME delos-mpi)
  set(CPACK_DEBIAN_MPI_PACKAGE_SHLIBDEPS ON)
endif()
include(CPack)
