#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Cross-compiles the unit tests, hence all but the parts for Python, MPI and STEP, for aarch64 and runs them under qemu-user: build/aarch64.
# Arguments are names of tests, by default all.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/setup.sh g++-aarch64-linux-gnu qemu-user-static mmdebstrap
source scripts/packaging/own_apt.sh
source scripts/other_build.sh
build=$PWD/build/aarch64 targets=$PWD/build/aarch64/targets.txt
root=$build/root

# The packages of scripts/setup.sh that are compiled against, for the other machine.
packages=libc6-dev,libstdc++-12-dev,libeigen3-dev,libopencv-dev,libicu-dev,libjpeg-dev,libceres-dev,libgoogle-glog-dev,libflann-dev,liblz4-dev
packages+=,libnanoflann-dev,libtbb-dev,zlib1g-dev,libsqlite3-dev,libboost-program-options-dev,nlohmann-json3-dev,libtinygltf-dev
packages+=,libgtest-dev,libgmock-dev,libbenchmark-dev
lasting_root "$root" bookworm --variant=extract --architectures=arm64 --include=$packages
# qemu looks paths up in the root first: what tests write must not be there.
rm -rf "$root/tmp"
libraries=$root/usr/lib/aarch64-linux-gnu
# As Debian's alternatives would.
for library in blas lapack; do
  for name in "lib$library.so" "lib$library.so.3"; do ln -sfn "$library/lib$library.so.3" "$libraries/$name"; done
done
# Ceres names libraries by their absolute paths.
sed -i "s,\([;\"]\)\(/usr/lib/[^;\"]*\.so\),\1$root\2,g" "$libraries/cmake/Ceres/CeresTargets.cmake"

cat >"$build/toolchain.cmake" <<END
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_SYSROOT $root)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_LIBRARY_ARCHITECTURE aarch64-linux-gnu)
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64-static -L $root)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
foreach(kind LIBRARY INCLUDE PACKAGE)
  set(CMAKE_FIND_ROOT_PATH_MODE_\${kind} ONLY)
endforeach()
END
cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_TOOLCHAIN_FILE="$build/toolchain.cmake" \
  -DLIMN_WITH_STEP=OFF -DLIMN_WITH_MPI=OFF -DLIMN_WITH_PYTHON=OFF -DLIMN_WITH_COLMAP=OFF
names=${*:-.*_test}
choose_targets "^tests/(limn|colmap_ext)/(.*/)?(${names// /|})\$"
build_targets
run_tests
