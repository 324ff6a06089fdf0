#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# installed_library_test.sh <build folder> <static or shared> <compiler>: install, move what was installed, build
# a small project with it alone, and draw some images of the sample scene. Without the program and its pages, which are
# large: package_test.sh has these.
set -euo pipefail
build=$1 kind=$2 compiler=$3
here=$(cd "$(dirname "$0")" && pwd)
source_dir=$(cd "$here/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

fail() {
  echo "FAILED: $*" >&2
  exit 1
}

for component in development "library_$kind"; do
  cmake --install "$build" --component "$component" --prefix "$work/first" >/dev/null
done
mv "$work/first" "$work/prefix"
prefix=$work/prefix

if grep -r -n -F -e "$source_dir" -e "$build" -e "$work/first" -e pch "$prefix"/lib*/*/cmake "$prefix/include" \
  "$prefix"/lib*/cmake 2>/dev/null; then
  fail "these lines name folders that users do not have"
fi
if grep -r -n -E '#include <(ceres|flann|nanoflann|nlohmann|opencv2|boost|tbb|Step|Geom)' "$prefix/include"; then
  fail "these headers need headers of libraries that users need not have"
fi

headers=OFF
[[ $kind == shared ]] || headers=ON
cmake -S "$here/consumer" -B "$work/build" -G Ninja -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_COMPILER="$compiler" \
  -DCMAKE_PREFIX_PATH="$prefix" -DALL_HEADERS=$headers >"$work/configure.log" ||
  { cat "$work/configure.log"; fail "the project is not configured"; }
cmake --build "$work/build" || fail "the project is not built"

printf 'view_0%d.jpg\n' 0 1 2 3 4 5 >"$work/images.txt"
"$work/build/consumer" "$source_dir/datasets/sample/day" "$work/images.txt" "$work/drawing.json" | tee "$work/said"
grep -q -E '^limn 0\.3\.[0-9]+: [1-9][0-9]+ links in 6 images$' "$work/said" || fail "too little was drawn"

if [[ -n $(find "$prefix" -name "limn-step-$kind.cmake") ]]; then
  head -c 13 "$work/drawing.json.step" | grep -q 'ISO-10303-21;' || fail "limn::step writes no STEP file"
fi

# It is the library of the program.
"$build/limn" automatic_drawer --workspace_path "$source_dir/datasets/sample/day" --image_list_path "$work/images.txt" \
  --quality low --max_image_size 320 --page 0 --output_path "$work/program" >"$work/log" || fail "$(cat "$work/log")"
cmp <(grep -v '^"options"' "$work/drawing.json") <(grep -v '^"options"' "$work/program/drawing.json") ||
  fail "the program draws something else"

if [[ $kind == shared ]]; then
  # Not through a pipe, which grep closes before ldd has ended.
  ldd "$work/build/consumer" >"$work/libraries"
  grep -q 'liblimn\.so\.0\.3 => '"$prefix" "$work/libraries" || fail "it does not use the shared library"
fi
