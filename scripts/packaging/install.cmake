# SPDX-License-Identifier: BSD-3-Clause
# What `cmake --install` puts in place, in components: program (with man pages and completion), plugin_step and plugin_mpi
# (colmap_ext/plugins), python (packages.cmake), library_static or library_shared, and development (headers and
# limn-config.cmake).
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

option(BUILD_SHARED_LIBS "Install shared libraries instead of static ones" OFF)
set(LIMN_LIBRARY_KIND static)
if(BUILD_SHARED_LIBS)
  set(LIMN_LIBRARY_KIND shared)
endif()
# The tests try both.
set(library_kinds ${LIMN_LIBRARY_KIND})
if(LIMN_BUILD_TESTS AND NOT LIMN_SANITIZE)
  set(library_kinds static shared)
endif()
set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/limn)
set(packaging_dir ${CMAKE_CURRENT_LIST_DIR})

# The modules, static libraries all, in subfolders of a folder.
function(limn_modules_in folder result)
  set(modules "")
  get_property(subfolders DIRECTORY ${folder} PROPERTY SUBDIRECTORIES)
  foreach(subfolder ${subfolders})
    get_property(targets DIRECTORY ${subfolder} PROPERTY BUILDSYSTEM_TARGETS)
    list(FILTER targets INCLUDE REGEX "^limn_")
    list(APPEND modules ${targets})
  endforeach()
  set(${result} ${modules} PARENT_SCOPE)
endfunction()

# Other people's libraries that a module links to: those that its users need, too, and those that only it needs.
function(limn_links_of module public_result private_result)
  get_target_property(public ${module} INTERFACE_LINK_LIBRARIES)
  get_target_property(private ${module} LINK_LIBRARIES)
  list(FILTER public EXCLUDE REGEX "^limn_|LINK_ONLY")
  list(FILTER private EXCLUDE REGEX "^limn_")
  # The last consists of headers, which have been compiled in.
  list(REMOVE_ITEM private ${public} nlohmann_json::nlohmann_json)
  set(${public_result} ${public} PARENT_SCOPE)
  set(${private_result} ${private} PARENT_SCOPE)
endfunction()

# limn_installed_library(<name> EXPORT_NAME <name> MODULES <targets...> [DEPENDS <installed libraries...>] [SET <export set>]):
# lib<name>, made of the objects of the modules, which users find as limn::<export name>. A target per kind.
function(limn_installed_library name)
  cmake_parse_arguments(ARG "" "EXPORT_NAME;SET" "MODULES;DEPENDS" ${ARGN})
  if(NOT ARG_SET)
    set(ARG_SET limn)
  endif()
  foreach(kind ${library_kinds})
    set(library ${name}_${kind})
    string(TOUPPER ${kind} type)
    add_library(${library} ${type})
    set_target_properties(${library} PROPERTIES
      OUTPUT_NAME ${name} EXPORT_NAME ${ARG_EXPORT_NAME} LINKER_LANGUAGE CXX
      INSTALL_RPATH "$ORIGIN"  # of the other one
      VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
    target_compile_features(${library} PUBLIC cxx_std_20)
    # Where the project was fetched.
    target_include_directories(${library} INTERFACE "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR};${PROJECT_SOURCE_DIR}/src;${LIMN_GENERATED_HEADERS}>")
    add_dependencies(${library} limn_commit)  # a header
    list(TRANSFORM ARG_DEPENDS APPEND _${kind} OUTPUT_VARIABLE depends)
    target_link_libraries(${library} PUBLIC ${depends})
    foreach(module ${ARG_MODULES})
      target_sources(${library} PRIVATE $<TARGET_OBJECTS:${module}>)
      limn_links_of(${module} public private)
      target_link_libraries(${library} PUBLIC ${public} PRIVATE ${private})
    endforeach()
    set(unless_asked_for EXCLUDE_FROM_ALL)
    if(kind STREQUAL LIMN_LIBRARY_KIND)
      set(unless_asked_for "")
      add_library(limn::${ARG_EXPORT_NAME} ALIAS ${library})
    endif()
    install(TARGETS ${library} EXPORT ${ARG_SET}-${kind}
      LIBRARY COMPONENT library_${kind} NAMELINK_COMPONENT library_${kind} ${unless_asked_for}
      ARCHIVE COMPONENT library_${kind} ${unless_asked_for}
      INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
  endforeach()
endfunction()

limn_modules_in(${PROJECT_SOURCE_DIR}/src/limn modules)
list(REMOVE_ITEM modules limn_step)
limn_installed_library(limn EXPORT_NAME limn MODULES ${modules})
if(LIMN_WITH_STEP)
  limn_installed_library(limn_step EXPORT_NAME step MODULES limn_step DEPENDS limn SET limn-step)
endif()
limn_installed_library(limn_colmap_workspace EXPORT_NAME colmap_workspace
  MODULES limn_colmap_model limn_workspace DEPENDS limn)
foreach(kind ${library_kinds})
  set(unless_asked_for EXCLUDE_FROM_ALL)
  if(kind STREQUAL LIMN_LIBRARY_KIND)
    set(unless_asked_for "")
  endif()
  install(EXPORT limn-${kind} NAMESPACE limn:: DESTINATION ${config_dir} COMPONENT library_${kind} ${unless_asked_for})
  if(LIMN_WITH_STEP)
    install(EXPORT limn-step-${kind} NAMESPACE limn:: DESTINATION ${config_dir} COMPONENT library_${kind} ${unless_asked_for})
  endif()
endforeach()

# Headers, as they are included; but not those that need the headers of libraries that users need not have.
set(private_headers
  paper/pictures page  # folders without any
  limn/evaluation/feature_writers.h limn/evaluation/hss_writers.h limn/files/json_text.h limn/files/json_value.h limn/formats/json_faces.h
  limn/formats/json_place.h limn/formats/json_views.h limn/geometry/kd_tree_of*.h limn/formats/step/border*.h limn/formats/step/curves.h
  limn/formats/step/edges.h limn/formats/step/faces.h limn/formats/step/occt_versions.h limn/formats/step/rods.h limn/formats/step/sheets.h
  limn/formats/step/shells.h limn/formats/step/surfaces.h limn/primitives/shape_solver.h
  limn/refinement/curve_fit.h limn/refinement/pose_fit.h limn/refinement/pull_cost.h limn/refinement/variance_factors.h
  limn/viewer/payload_arrays.h workspace/shrink_image.h)
set(exclude_private "")
foreach(header ${private_headers})
  list(APPEND exclude_private PATTERN ${header} EXCLUDE)
endforeach()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/src/limn ${LIMN_GENERATED_HEADERS}/limn
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development FILES_MATCHING PATTERN "*.h" ${exclude_private})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/colmap_ext/model ${PROJECT_SOURCE_DIR}/colmap_ext/workspace
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/colmap_ext COMPONENT development
  FILES_MATCHING PATTERN "*.h" ${exclude_private})

configure_package_config_file(${packaging_dir}/limn-config.cmake.in ${PROJECT_BINARY_DIR}/limn-config.cmake
  INSTALL_DESTINATION ${config_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/limn-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/limn-config.cmake ${PROJECT_BINARY_DIR}/limn-config-version.cmake
  DESTINATION ${config_dir} COMPONENT development)

# The program, which needs no library of ours, its man pages and its completion.
add_custom_command(
  OUTPUT ${PROJECT_BINARY_DIR}/man.stamp
  COMMAND ${CMAKE_COMMAND} -DLIMN=$<TARGET_FILE:limn> -DFOLDER=${PROJECT_BINARY_DIR}/man
          -P ${packaging_dir}/write_man_pages.cmake
  COMMAND ${CMAKE_COMMAND} -E touch ${PROJECT_BINARY_DIR}/man.stamp
  DEPENDS limn ${packaging_dir}/write_man_pages.cmake
  COMMENT "Man pages"
  VERBATIM)
# Not with sanitizers, which would take their time and tell nothing.
if(NOT LIMN_SANITIZE)
  set(always ALL)
endif()
add_custom_target(man_pages ${always} DEPENDS ${PROJECT_BINARY_DIR}/man.stamp)
install(TARGETS limn COMPONENT program)
install(DIRECTORY ${PROJECT_BINARY_DIR}/man/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
install(FILES ${packaging_dir}/completion.bash RENAME limn
  DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT program)
