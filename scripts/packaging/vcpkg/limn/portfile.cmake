# SPDX-License-Identifier: BSD-3-Clause
# Port of vcpkg: see vcpkg.json. The marks are filled in by scripts/packaging/fill_recipes.py.
set(release "https://github.com/@LIMN_REPOSITORY@/releases/download/v${VERSION}")
vcpkg_download_distfile(archive
  URLS "${release}/limn-${VERSION}.tar.gz"
  FILENAME "limn-${VERSION}.tar.gz"
  SHA512 @LIMN_SHA512@)
vcpkg_extract_source_archive(source_path ARCHIVE "${archive}")

vcpkg_check_features(OUT_FEATURE_OPTIONS feature_options FEATURES viewer LIMN_WITH_VIEWER)
if("viewer" IN_LIST FEATURES)
  # npm's cache, so that the build itself needs no network.
  vcpkg_download_distfile(npm_archive
    URLS "${release}/limn-${VERSION}-npm-cache.tar.gz"
    FILENAME "limn-${VERSION}-npm-cache.tar.gz"
    SHA512 @LIMN_NPM_CACHE_SHA512@)
  vcpkg_extract_source_archive(npm_cache ARCHIVE "${npm_archive}")
  set(ENV{npm_config_cache} "${npm_cache}")
  set(ENV{npm_config_offline} true)
endif()

vcpkg_cmake_configure(
  SOURCE_PATH "${source_path}"
  OPTIONS
    ${feature_options}
    -DLIMN_BUILD_TESTS=OFF
    -DLIMN_WITH_PYTHON=OFF
    -DLIMN_WITH_COLMAP=OFF
    -DLIMN_WITH_STEP=OFF
    -DLIMN_WITH_MPI=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/limn)
vcpkg_copy_tools(TOOL_NAMES limn AUTO_CLEAN)
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")

set(licenses "${source_path}/LICENSE")
if("viewer" IN_LIST FEATURES)
  # three.js, in the page.
  list(APPEND licenses "${CURRENT_BUILDTREES_DIR}/${TARGET_TRIPLET}-rel/src/limn/viewer/page/node_modules/three/LICENSE")
endif()
vcpkg_install_copyright(FILE_LIST ${licenses})
