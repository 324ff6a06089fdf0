#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Compiles everything but the parts for Python, MPI and STEP with clang and libc++, the standard library of macOS and FreeBSD: build/libcxx. With --tests also
# builds the libraries that Limn needs that way, and runs the unit tests. Needs clang-19, libc++-19-dev and libc++abi-19-dev,
# which it installs.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/setup.sh clang-19 libc++-19-dev libc++abi-19-dev googletest dpkg-dev
export CXX=clang++-19 CC=clang-19 CXXFLAGS=-stdlib=libc++ LDFLAGS=-stdlib=libc++
libraries=$PWD/build/libcxx/libraries

options=(-DLIMN_WITH_STEP=OFF -DLIMN_WITH_MPI=OFF -DLIMN_WITH_PYTHON=OFF -DLIMN_WITH_COLMAP=OFF -DCMAKE_BUILD_TYPE=Release)
targets='^(src|colmap_ext)/.*\.a$'
if [[ ${1:-} == --tests ]]; then
  scripts/libcxx_libraries.sh "$libraries"
  options+=(-DCMAKE_PREFIX_PATH="$libraries" -DBoost_NO_BOOST_CMAKE=ON -DBOOST_INCLUDEDIR=/usr/include -DBOOST_LIBRARYDIR="$libraries/lib")
  targets='^tests/(limn|colmap_ext)/.*_test$'
fi
cmake -S . -B build/libcxx -G Ninja "${options[@]}"
ninja -C build/libcxx -t targets all | sed 's/: .*//' | grep -E "$targets" >build/libcxx/targets.txt
xargs -a build/libcxx/targets.txt ninja -C build/libcxx
[[ ${1:-} != --tests ]] || LD_LIBRARY_PATH=$libraries/lib ctest --test-dir build/libcxx -j2 --output-on-failure -R "^($(sed 's,.*/,,' build/libcxx/targets.txt | paste -sd'|'))\$"
