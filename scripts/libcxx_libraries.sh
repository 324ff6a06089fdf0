#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# libcxx_libraries.sh <folder>: build the libraries that have C++ interfaces into <folder>/lib with clang and libc++, from the
# sources of Debian's packages, for scripts/test_libcxx.sh --tests. Does nothing if they are there.
set -euo pipefail
: "${CXX:?is set by scripts/test_libcxx.sh}"
mkdir -p "$1"
folder=$(cd "$1" && pwd)
here=$(cd "$(dirname "$0")" && pwd)
[[ -f $folder/done ]] && exit 0
source "$here/packaging/own_apt.sh"

own_apt "$folder/apt" deb-src "$(. /etc/os-release && echo "$VERSION_CODENAME")"
mkdir -p "$folder/sources" "$folder/lib"
cd "$folder/sources"
apt_get --download-only source google-glog boost1.74 onetbb
rm -rf glog boost tbb
dpkg-source -x google-glog_*.dsc glog >/dev/null
dpkg-source -x onetbb_*.dsc tbb >/dev/null
mkdir boost
tar -C boost -xf boost1.74_*.orig.tar.* --strip-components=1 --wildcards '*/libs/program_options/src'

# FindBoost looks for its name.
# shellcheck disable=SC2086
"$CXX" $CXXFLAGS $LDFLAGS -std=c++20 -O2 -fPIC -shared -Wl,-soname,libboost_program_options.so.1.74.0 boost/libs/program_options/src/*.cpp \
  -o "$folder/lib/libboost_program_options.so.1.74.0"
ln -sf libboost_program_options.so.1.74.0 "$folder/lib/libboost_program_options.so"
# Exceptions of our loops pass through oneTBB.
for library in glog tbb /usr/src/googletest; do
  cmake -S "$library" -B "$folder/build/${library##*/}" -G Ninja -DCMAKE_BUILD_TYPE=Release -DBUILD_SHARED_LIBS=ON -DCMAKE_INSTALL_LIBDIR=lib \
    -DCMAKE_INSTALL_PREFIX="$folder" -DBUILD_TESTING=OFF -DWITH_GTEST=OFF -DWITH_GFLAGS=OFF -DWITH_UNWIND=OFF \
    -DTBB_TEST=OFF -DTBBMALLOC_BUILD=OFF -Wno-dev
  cmake --build "$folder/build/${library##*/}" --target install
done
CMAKE_PREFIX_PATH=$folder "$here/packaging/lean_libraries.sh" "$folder"
