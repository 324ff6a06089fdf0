#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds the program without its page, the plug-ins, the Python module and the unit tests in a root of Debian 13 (GCC 14, Boost 1.83, Ceres 2.2,
# OpenCV 4.10, OpenCASCADE 7.8) and runs these tests there: build/debian13. Arguments are names of tests, by default all. Needs root.
set -euo pipefail
cd "$(dirname "$0")/.."
folder=$PWD/build/debian13
root=$folder/root

if [[ ${1:-} == --inside ]]; then
  names=${*:2}
  scripts/setup.sh
  build=$folder/release targets=$folder/targets.txt
  source scripts/other_build.sh
  cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DLIMN_WITH_VIEWER=OFF
  names=${names:-.*_test}
  choose_targets "^(limn|lib/limn/plugins/.*\.so|.*/_limn\..*\.so|tests/(limn|colmap_ext)/(.*/)?(${names// /|}))\$"
  build_targets
  run_tests
  exit
fi

scripts/setup.sh mmdebstrap
source scripts/packaging/own_apt.sh
lasting_root "$root" trixie --variant=apt
mkdir -p "$root$PWD"
cp /etc/resolv.conf "$root/etc/resolv.conf"
# The project is where it is here; this and /proc are gone with the command.
unshare --mount bash -c 'mount -t proc proc "$1/proc" && mount --bind "$2" "$1$2" && exec chroot "$1" env -i HOME=/root \
  PATH=/usr/bin:/bin:/usr/sbin:/sbin LC_ALL=C.UTF-8 "$2/scripts/test_debian13.sh" --inside "${@:3}"' \
  bash "$root" "$PWD" "$@" </dev/null
