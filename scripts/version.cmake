# limn/version.h, and limn/commit.h with the commit, which is written again when git's log of HEAD changes. Only what
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
