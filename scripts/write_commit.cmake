# SPDX-License-Identifier: BSD-3-Clause
# cmake -DGIT=<program> -DSOURCE_DIR=<folder> -DHEADER=<file> -P write_commit.cmake: the header with the commit of the
# sources, or with none where they are no repository of their own.
set(commit "")
if(GIT AND EXISTS ${SOURCE_DIR}/.git)
  execute_process(
    COMMAND ${GIT} rev-parse --short=12 HEAD
    WORKING_DIRECTORY ${SOURCE_DIR} OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()
file(WRITE ${HEADER} "#pragma once\n\n// The commit that this was built from; empty if unknown.\n#define LIMN_COMMIT \"${commit}\"\n")
