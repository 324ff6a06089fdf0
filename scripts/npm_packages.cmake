# SPDX-License-Identifier: BSD-3-Clause
# cmake -DNPM=<npm> -DSOURCE_DIR=<with package.json and its lock> -DBUILD_DIR=<where node_modules goes>
#       -P npm_packages.cmake
# Packages in npm's cache are not fetched again, so that later builds work without a network.
file(MAKE_DIRECTORY ${BUILD_DIR})
file(COPY ${SOURCE_DIR}/package.json ${SOURCE_DIR}/package-lock.json DESTINATION ${BUILD_DIR})
execute_process(
  COMMAND ${NPM} ci --prefer-offline --ignore-scripts --no-audit --no-fund --loglevel=error
          --fetch-timeout=30000 --fetch-retries=2
  TIMEOUT 600
  WORKING_DIRECTORY ${BUILD_DIR}
  RESULT_VARIABLE result)
if(NOT result STREQUAL "0")
  message(FATAL_ERROR "npm cannot install the packages of ${SOURCE_DIR}/package.json. Without network "
    "and without npm's cache of an earlier build, configure with -DLIMN_WITH_VIEWER=OFF")
endif()
file(TOUCH ${BUILD_DIR}/npm.stamp)
