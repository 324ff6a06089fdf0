# SPDX-License-Identifier: BSD-3-Clause
# Debian packages by `cpack`: limn, liblimn-dev, and python3-limn where the Python module is built.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_VENDOR "The Limn authors")
set(CPACK_PACKAGE_CONTACT "The Limn authors <limn@localhost>")
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL program development library_${LIMN_LIBRARY_KIND})
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)

# limn_package(<component or group> <package> DESCRIPTION <text> [DEPENDS <packages>]): beside the libraries that
# programs in it are linked to.
macro(limn_package part package)
  cmake_parse_arguments(PACKAGE "" "DESCRIPTION;DEPENDS" "" ${ARGN})
  string(TOUPPER ${part} part_name)
  set(CPACK_DEBIAN_${part_name}_PACKAGE_NAME ${package})
  set(CPACK_DEBIAN_${part_name}_DESCRIPTION "${PACKAGE_DESCRIPTION}")
  set(CPACK_DEBIAN_${part_name}_PACKAGE_DEPENDS "${PACKAGE_DEPENDS}")
endmacro()

limn_package(program limn
  DESCRIPTION "3D drawings from COLMAP projects
 Limn finds the curves in the photographs of a COLMAP project, reconstructs them in space and joins them into a graph.")
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE RENAME copyright
  DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/limn COMPONENT program)
# Its plug-ins, which bring OpenCASCADE and MPI.
set(plugin_of_step "export as STEP files")
set(plugin_of_mpi "runs on several hosts by MPI")
get_property(plugins GLOBAL PROPERTY LIMN_PLUGINS)
foreach(plugin ${plugins})
  list(APPEND CPACK_COMPONENTS_ALL plugin_${plugin})
  list(APPEND recommended limn-${plugin})
  limn_package(plugin_${plugin} limn-${plugin}
    DESCRIPTION "3D drawings from COLMAP projects, ${plugin_of_${plugin}}
 A part of the program limn that it loads when it is needed."
    DEPENDS "limn (= ${PROJECT_VERSION})")
  install(FILES ${PROJECT_SOURCE_DIR}/LICENSE RENAME copyright
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/limn-${plugin} COMPONENT plugin_${plugin})
endforeach()
list(JOIN recommended ", " CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS)

set(dev_packages libeigen3-dev)
if(NOT BUILD_SHARED_LIBS)
  string(APPEND dev_packages ", libceres-dev, libicu-dev, libjpeg-dev, liblz4-dev, libopencv-dev, libsqlite3-dev, libtbb-dev, zlib1g-dev")
endif()
limn_package(library liblimn-dev
  DESCRIPTION "3D drawings from COLMAP projects, library
 Headers, libraries and limn-config.cmake." DEPENDS "${dev_packages}")
if(LIMN_WITH_STEP)
  set(CPACK_DEBIAN_LIBRARY_PACKAGE_SUGGESTS libocct-data-exchange-dev)
endif()
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE RENAME copyright
  DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/liblimn-dev COMPONENT development)

if(LIMN_WITH_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python)
  math(EXPR next_minor "${Python_VERSION_MINOR} + 1")
  limn_package(python python3-limn
    DESCRIPTION "3D drawings from COLMAP projects, Python module
 The package limn for Debian's Python."
    DEPENDS "python3 (>= 3.${Python_VERSION_MINOR}), python3 (<< 3.${next_minor}), python3-numpy")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS limn-step)
  # Where only Debian's Python looks; others install the wheel.
  install(TARGETS limn_python DESTINATION lib/python3/dist-packages/limn COMPONENT python EXCLUDE_FROM_ALL)
  install(DIRECTORY ${PROJECT_BINARY_DIR}/python/limn DESTINATION lib/python3/dist-packages
    COMPONENT python EXCLUDE_FROM_ALL FILES_MATCHING PATTERN *.py PATTERN *.pyi PATTERN py.typed)
  install(FILES ${PROJECT_SOURCE_DIR}/LICENSE RENAME copyright
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/python3-limn COMPONENT python EXCLUDE_FROM_ALL)
endif()

include(CPack)
cpack_add_component_group(library)
cpack_add_component(development GROUP library)
cpack_add_component(library_${LIMN_LIBRARY_KIND} GROUP library)
