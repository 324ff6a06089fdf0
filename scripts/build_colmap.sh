#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Build COLMAP's library on Debian 12 and install it, for LIMN_WITH_COLMAP (colmap_ext/adapter):
#
#   scripts/build_colmap.sh [--scene-only] <prefix> <checkout or clone of colmap/colmap> [<tag>]
#   scripts/build_colmap.sh /opt/colmap-3.9.1 ~/colmap
#   cmake --preset release -DCMAKE_PREFIX_PATH=/opt/colmap-3.9.1 -DLIMN_WITH_COLMAP=ON
#
# The tag or commit, 3.9.1 unless given, is exported from the repository (bare or not) to a temporary folder; the
# repository is left alone. Needs Debian's packages only, which are installed if missing. Without GUI, CUDA, OpenGL,
# CGAL, ONNX and tests; OpenGL and GLEW are asked for, but not used. 157 files in 3.9.1; --scene-only compiles the part
# that reconstructions need, which is enough for Limn and its tests, and installs the other libraries empty. From 3.12
# on COLMAP downloads PoseLib and faiss; --scene-only needs neither. JOBS=<n> runs so many compilers, OPTIMIZE=-O1
# compiles faster.
set -euo pipefail

scene_only=false
if [[ ${1:-} == --scene-only ]]; then
  scene_only=true
  shift
fi
if (($# < 2 || $# > 3)); then
  sed -n '2,/^set/p' "$0" | sed '/^set/d; /SPDX/d; s/^# \?//'
  exit 1
fi
prefix=$1
repository=$2
tag=${3:-3.9.1}

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
build=$folder/build
mkdir "$folder/source"
git -C "$repository" archive "$tag" | tar -x -C "$folder/source"

# Pictures are read by FreeImage, from 4.0 on by OpenImageIO.
pictures=(libfreeimage-dev)
if grep -q OpenImageIO "$folder/source/cmake/FindDependencies.cmake"; then
  pictures=(libopenimageio-dev openimageio-tools)
fi
"$(dirname "$0")/setup.sh" git libboost-filesystem-dev libboost-graph-dev libboost-program-options-dev libboost-system-dev \
  "${pictures[@]}" libflann-dev liblz4-dev libmetis-dev libgoogle-glog-dev libsqlite3-dev libgl-dev libglew-dev \
  libceres-dev libeigen3-dev

# empty_library <name>: a folder of sources for an empty library.
empty_library() {
  mkdir "$folder/$1"
  printf 'add_library(%s INTERFACE)\nadd_library(%s::%s ALIAS %s)\n' "$1" "$1" "$1" "$1" > "$folder/$1/CMakeLists.txt"
  echo "$folder/$1"
}
scene_options=()
if $scene_only; then
  # The program is an empty file, in which no path can be changed.
  scene_options=(-DFETCHCONTENT_SOURCE_DIR_POSELIB="$(empty_library PoseLib)"
    -DFETCHCONTENT_SOURCE_DIR_FAISS="$(empty_library faiss)" -DCMAKE_SKIP_INSTALL_RPATH=ON)
fi

cmake -S "$folder/source" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX="$prefix" \
  -DGUI_ENABLED=OFF -DOPENGL_ENABLED=OFF -DCUDA_ENABLED=OFF -DCGAL_ENABLED=OFF -DONNX_ENABLED=OFF -DDOWNLOAD_ENABLED=OFF \
  -DTESTS_ENABLED=OFF "${scene_options[@]}" -DCMAKE_CXX_FLAGS_RELEASE="${OPTIMIZE:--O3} -DNDEBUG"

if $scene_only; then
  cmake --build "$build" --parallel "${JOBS:-$(nproc)}" --target colmap_scene
  # What else is installed must exist.
  grep -rhoE "$build/[^\"]*\.a" --include=cmake_install.cmake "$build" | sort -u | while read -r library; do
    [[ -e $library ]] || ar rc "$library"
  done
  touch "$build/src/colmap/exe/colmap"
  cmake --install "$build"
  rm "$prefix/bin/colmap"
  rmdir --ignore-fail-on-non-empty "$prefix/bin"
else
  cmake --build "$build" --parallel "${JOBS:-$(nproc)}"
  cmake --install "$build"
fi
