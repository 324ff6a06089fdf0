# SPDX-License-Identifier: BSD-3-Clause
# Headers of the standard library, Eigen, nlohmann/json and GoogleTest, compiled once for all targets with the same
# flags. Our own headers are not among them, since a change would recompile everything. Sources still include
# what they use: a build without precompiled headers (LIMN_PRECOMPILED_HEADERS=OFF, sanitizers, clang) must work.
set(compiler_precompiles OFF)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND NOT LIMN_SANITIZE)
  set(compiler_precompiles ON)
endif()
option(LIMN_PRECOMPILED_HEADERS "Precompile the headers that most files include" ${compiler_precompiles})

# ccache and GCC: identify precompiled headers by content.
if(LIMN_PRECOMPILED_HEADERS AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_compile_options(-fpch-preprocess)
endif()

set(LIMN_HEADERS_OF_LIBRARIES
  <algorithm> <array> <charconv> <cmath> <cstdint> <cstring> <filesystem> <fstream> <functional> <limits> <map>
  <memory> <numeric> <optional> <ostream> <set> <span> <sstream> <stdexcept> <string> <string_view> <system_error>
  <tuple> <unordered_map> <utility> <vector>
  <Eigen/Core> <Eigen/Geometry> <Eigen/LU> <nlohmann/json.hpp>)
set(LIMN_HEADERS_OF_TESTS ${LIMN_HEADERS_OF_LIBRARIES} <random> <gtest/gtest.h> <gmock/gmock.h>)

# limn_precompile(<name> HEADERS <headers...> LINKS <targets...> [OPTIONS <flags...>]): headers for
# limn_use_precompiled(<target> <name>), whose flags must be the same.
function(limn_precompile name)
  cmake_parse_arguments(ARG "" "" "HEADERS;LINKS;OPTIONS" ${ARGN})
  if(LIMN_PRECOMPILED_HEADERS)
    file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${name}.cc CONTENT "")
    add_library(${name} OBJECT ${CMAKE_CURRENT_BINARY_DIR}/${name}.cc)
    target_link_libraries(${name} PRIVATE ${ARG_LINKS})
    target_compile_options(${name} PRIVATE ${ARG_OPTIONS})
    target_precompile_headers(${name} PRIVATE ${ARG_HEADERS})
  endif()
endfunction()

function(limn_use_precompiled target name)
  if(LIMN_PRECOMPILED_HEADERS)
    target_precompile_headers(${target} REUSE_FROM ${name})
  endif()
endfunction()
