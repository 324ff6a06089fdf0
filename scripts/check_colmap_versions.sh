#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Compile what links COLMAP's library (colmap_ext/adapter and its tests) with the headers of other versions of COLMAP,
# without building these:
#
#   scripts/check_colmap_versions.sh <build tree of Limn> <clone of colmap/colmap> <tag or commit>...
#   scripts/check_colmap_versions.sh build/release ~/colmap 3.9.1 3.10 3.11.1 3.12.6 3.13.0 4.0.4 4.1.1 main
#
# Versions from 3.9 on. From 4.2 on COLMAP has two kinds of hash tables; these are the standard library's (the others
# need Boost 1.84). Needs Debian's packages that scripts/setup.sh installs, and libopenimageio-dev.
set -euo pipefail

if (($# < 3)); then
  sed -n '2,/^set/p' "$0" | sed '/^set/d; /SPDX/d; s/^# \?//'
  exit 1
fi
build=$(realpath "$1")
repository=$(realpath "$2")
shift 2
cd "$(dirname "$0")/.."
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

glog=$(dpkg-query --show --showformat='${Version}' libgoogle-glog-dev)
flags=(-std=c++20 -fsyntax-only -Wall -Wextra -Werror
  "-DGLOG_VERSION_MAJOR=${glog%%.*}" "-DGLOG_VERSION_MINOR=$(cut -d . -f 2 <<< "${glog%%-*}")" -DCOLMAP_HASH_STD
  -I. -Isrc -Itests "-I$build/include" '-DLIMN_SAMPLE_DIR="datasets/sample"')
for version in "$@"; do
  mkdir -p "$folder/$version"
  git -C "$repository" archive "$version" src | tar -x -C "$folder/$version"
  for source in colmap_ext/adapter/*.cc tests/colmap_ext/adapter/*.cc; do
    g++ "${flags[@]}" -isystem "$folder/$version/src" -isystem /usr/include/eigen3 -isystem /usr/include/opencv4 "$source"
  done
  echo "$version: compiles"
done
