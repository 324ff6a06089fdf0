#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Compiles all libraries but the parts for Python, MPI and STEP with clang and libc++, the standard library of macOS and FreeBSD:
# build/libcxx. With --tests it also builds the libraries that Limn needs that way, and runs the unit tests.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/setup.sh clang-19 googletest dpkg-dev libopenjp2-7-dev libpng-dev libtiff-dev libwebp-dev
build=$PWD/build/libcxx targets=$PWD/build/libcxx/targets.txt
source scripts/other_build.sh

# Debian's package cannot be installed beside libunwind-dev, which glog needs.
tools=$build/tools/usr/lib/llvm-19
if [[ ! -e $tools/lib/libunwind.so ]]; then
  mkdir -p "$build/packages"
  (cd "$build/packages" && apt-get download libc++-19-dev libc++1-19 libc++abi-19-dev libc++abi1-19 libunwind-19 &&
    for package in *.deb; do dpkg -x "$package" "$build/tools"; done)
  ln -sf libunwind.so.1 "$tools/lib/libunwind.so"
fi
export CC=clang-19 CXX=clang++-19
# Debian's Boost inherits from what C++17 has removed.
export CXXFLAGS="-stdlib++-isystem $tools/include/c++/v1 -D_LIBCPP_ENABLE_CXX17_REMOVED_UNARY_BINARY_FUNCTION"
export LDFLAGS="-stdlib=libc++ -L$tools/lib -Wl,-rpath,$tools/lib"

options=(-DLIMN_WITH_STEP=OFF -DLIMN_WITH_MPI=OFF -DLIMN_WITH_PYTHON=OFF -DLIMN_WITH_COLMAP=OFF)
wanted='^(src|colmap_ext)/.*\.a$'
if [[ ${1:-} == --tests ]]; then
  scripts/libcxx_libraries.sh "$build/libraries"
  options+=(-DCMAKE_PREFIX_PATH="$build/libraries" -DBoost_NO_BOOST_CMAKE=ON -DBOOST_INCLUDEDIR=/usr/include
    -DBOOST_LIBRARYDIR="$build/libraries/lib")
  wanted='^tests/(limn|colmap_ext)/.*_test$'
fi
# Fresh: libraries that another call found elsewhere are forgotten.
cmake --fresh -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release "${options[@]}"
choose_targets "$wanted"
build_targets
[[ ${1:-} != --tests ]] || LD_LIBRARY_PATH=$build/libraries/lib run_tests
