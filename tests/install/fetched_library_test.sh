#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# fetched_library_test.sh <compiler> [all]: a small project that has Limn as a part (FetchContent): it is configured, its own source and one
# module are compiled. With "all" it is built and run.
set -euo pipefail
compiler=$1
here=$(cd "$(dirname "$0")" && pwd)
source_dir=$(cd "$here/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cmake -S "$here/consumer" -B "$work/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER="$compiler" \
  -DFETCHED="$source_dir" -DLIMN_WITH_VIEWER=OFF >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
if grep -q "LIMN_BUILD_TESTS:BOOL=ON" "$work/build/CMakeCache.txt"; then
  echo "FAILED: what only Limn itself needs is built" >&2
  exit 1
fi
if ninja -C "$work/build" -n | grep -E 'colmap_ext/(main|python|plugins)'; then
  echo "FAILED: the project builds what it does not use" >&2
  exit 1
fi
if [[ ${2:-} == all ]]; then
  cmake --build "$work/build" --target consumer
  printf 'view_0%d.jpg\n' 0 1 2 3 4 5 >"$work/images.txt"
  "$work/build/consumer" "$source_dir/datasets/sample/day" "$work/images.txt" "$work/drawing.json"
else
  cmake --build "$work/build" --target CMakeFiles/consumer.dir/main.cc.o limn_util
fi
