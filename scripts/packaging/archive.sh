#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# archive.sh: make build/portable/limn-<version>-linux-<machine>.tar.gz, which runs wherever it is unpacked: the program
# with its plug-ins and libraries, the Python module, man pages, completion; and wheels of the same; and SHA256SUMS.
# Builds in build/archive, which takes little where ccache knows the files of another build. Installs
# what is missing.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
source_dir=$(cd "$here/../.." && pwd)
portable=$source_dir/build/portable
# As deep as build/release: ccache knows its files by relative paths.
build=$source_dir/build/archive

"$source_dir/scripts/setup.sh" patchelf dpkg-dev libopenjp2-7-dev libpng-dev libtiff-dev libwebp-dev
"$here/lean_libraries.sh" "$portable/libraries"
"$here/python_headers.sh" "$portable/python"
export CCACHE_BASEDIR=$source_dir CCACHE_NOHASHDIR=1
cmake -S "$source_dir" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DLIMN_BUILD_TESTS=OFF -DLIMN_WITH_FLANN=ON \
  -DCMAKE_PREFIX_PATH="$portable/libraries" -DLIMN_PYTHON_ROOTS="$portable/python"
cmake --build "$build" --target limn limn_python_package limn_python_modules man_pages

version=$(sed -n 's/^project(limn VERSION \([0-9.]*\).*/\1/p' "$source_dir/CMakeLists.txt")
name=limn-$version-linux-$(uname -m)
stage=$portable/$name
rm -rf "$stage" "$portable"/*.tar.gz "$portable"/*.whl
for component in program plugin_step plugin_mpi; do
  cmake --install "$build" --component "$component" --prefix "$stage" >/dev/null
done
rm -rf "$stage"/share/doc/limn-*
cp -r "$build/python/limn" "$stage/python-limn"
rm -rf "$stage"/python-limn/{_limn.*.so,__pycache__}
cp "$build"/python-modules/*.so "$stage/python-limn/"
mkdir "$stage/python"
mv "$stage/python-limn" "$stage/python/limn"

"$here/bundle.py" "$stage/lib/limn" "$stage/bin/limn" "$stage"/lib/limn/plugins/*.so "$stage"/python/limn/_limn.*.so \
  --search "$portable/libraries/lib" >"$portable/bundled.txt"
mapfile -t bundled <"$portable/bundled.txt"
"$here/third_party_notices.py" --output "$stage/THIRD_PARTY_NOTICES.txt" --npm "$build/src/limn/viewer/page" \
  --users "$build/limn" "$build"/lib/limn/plugins/*.so "$build"/python-modules/*.so -- "${bundled[@]}" ||
  { echo "ERROR: the archive may not be passed on as it is: $stage/THIRD_PARTY_NOTICES.txt" >&2; exit 1; }
cp "$source_dir/LICENSE" "$stage/"
cp "$source_dir/colmap_ext/docs/changelog.md" "$stage/share/doc/limn/"
requires=$("$here/glibc_needed.py" "$stage" | paste -s -d, | sed 's/,/ and /')
cat >"$stage/README.txt" <<END
Limn $version: 3D drawings from COLMAP projects

  bin/limn automatic_drawer --workspace_path my_project
  bin/limn help

In Python: PYTHONPATH=<this folder>/python; needs numpy.
Man pages are in share/man, completion of bash is in share/bash-completion.

Runs on Linux with $requires or newer; tested on Debian 12 and 13. On several
hosts by mpirun it uses the Open MPI 4 of the system (libmpi.so.40). The folder may be moved.
Licenses: LICENSE, and THIRD_PARTY_NOTICES.txt for the libraries in lib/limn.
END

commit_time=$(git -C "$source_dir" log -1 --format=%ct 2>/dev/null || echo 0)
tar --sort=name --mtime="@$commit_time" --owner=0 --group=0 --numeric-owner -C "$portable" -c "$name" | gzip -9n >"$portable/$name.tar.gz"
/usr/bin/python3 "$here/wheels.py" "$stage" "$portable" --commit-time "$commit_time"
(cd "$portable" && sha256sum -- *.tar.gz *.whl >SHA256SUMS && ls -l -- *.tar.gz *.whl)
echo "$requires"
