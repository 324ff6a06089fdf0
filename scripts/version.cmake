# SPDX-License-Identifier: BSD-3-Clause
# limn/version.h, limn/libraries.h, and limn/commit.h with the commit, which is written again when git's log of HEAD changes. Only what
# prints the commit includes the latter, so that a commit does not recompile the library.
set(LIMN_GENERATED_HEADERS ${PROJECT_BINARY_DIR}/include)
configure_file(${PROJECT_SOURCE_DIR}/src/limn/version.h.in ${LIMN_GENERATED_HEADERS}/limn/version.h @ONLY)

add_library(limn_version INTERFACE)
target_include_directories(limn_version INTERFACE ${LIMN_GENERATED_HEADERS})

find_package(Git QUIET)
set(log_of_head "")
if(GIT_FOUND AND EXISTS ${PROJECT_SOURCE_DIR}/.git)
  execute_process(
    COMMAND ${GIT_EXECUTABLE} rev-parse --git-path logs/HEAD
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE log_of_head OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  cmake_path(ABSOLUTE_PATH log_of_head BASE_DIRECTORY ${PROJECT_SOURCE_DIR})
  if(NOT EXISTS ${log_of_head})
    set(log_of_head "")
  endif()
endif()
add_custom_command(
  OUTPUT ${LIMN_GENERATED_HEADERS}/limn/commit.h
  COMMAND ${CMAKE_COMMAND} -DGIT=${GIT_EXECUTABLE} -DSOURCE_DIR=${PROJECT_SOURCE_DIR}
          -DHEADER=${LIMN_GENERATED_HEADERS}/limn/commit.h -P ${PROJECT_SOURCE_DIR}/scripts/write_commit.cmake
  DEPENDS ${log_of_head} ${PROJECT_SOURCE_DIR}/scripts/write_commit.cmake
  VERBATIM)
add_custom_target(limn_commit DEPENDS ${LIMN_GENERATED_HEADERS}/limn/commit.h)

# limn/libraries.h: what this is built with; after all libraries were found.
function(limn_write_libraries)
  set(libraries "OpenCV ${OpenCV_VERSION}" "Ceres ${Ceres_VERSION}" "Eigen ${Eigen3_VERSION}" "oneTBB ${TBB_VERSION}"
      "ICU ${ICU_VERSION}" "SQLite ${SQLite3_VERSION}" "zlib ${ZLIB_VERSION_STRING}" "Boost ${Boost_VERSION_STRING}")
  if(LIMN_WITH_STEP)
    list(APPEND libraries "OpenCASCADE ${OpenCASCADE_VERSION} (plug-in)")
  endif()
  list(JOIN libraries ", " LIMN_LIBRARIES)
  string(REPLACE GNU GCC compiler ${CMAKE_CXX_COMPILER_ID})
  set(LIMN_COMPILER "${compiler} ${CMAKE_CXX_COMPILER_VERSION}")
  configure_file(${PROJECT_SOURCE_DIR}/src/limn/libraries.h.in ${LIMN_GENERATED_HEADERS}/limn/libraries.h @ONLY)
endfunction()
limn_write_libraries()
