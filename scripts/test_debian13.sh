#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds the unit tests, hence all but the page, in a root of Debian 13 (GCC 14, Ceres 2.2, OpenCV 4.10, OpenCASCADE 7.8) and runs them there:
# build/debian13. Arguments are names of tests, by default all. Needs root.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/setup.sh mmdebstrap
source scripts/packaging/own_apt.sh
build=$PWD/build/debian13
root=$build/root

if [[ ! -d $root ]]; then
  mkdir -p "$build"
  rm -rf "$root.part"
  mirror=$(debian_mirror Debian)
  mmdebstrap --quiet --variant=apt trixie "$root.part" "${mirror:-http://deb.debian.org/debian}"
  mv "$root.part" "$root"
fi

# The project is where it is here; this and /proc are gone with the command.
unshare --mount bash -s "$root" "$PWD" "$build" "${*:-.*_test}" <<'END'
set -euo pipefail
root=$1 project=$2
mount -t proc proc "$root/proc"
mkdir -p "$root$project"
mount --bind "$project" "$root$project"
cp /etc/resolv.conf "$root/etc/resolv.conf"
exec chroot "$root" env -i HOME=/root PATH=/usr/bin:/bin:/usr/sbin:/sbin LC_ALL=C.UTF-8 bash -s "${@:2}" <<'INNER'
set -euo pipefail
cd "$1"
scripts/setup.sh
build=$2/release targets=$2/targets.txt
source scripts/other_build.sh
cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DLIMN_WITH_VIEWER=OFF
choose_targets "^tests/(limn|colmap_ext)/(.*/)?(${3// /|})\$"
build_targets
run_tests
INNER
END
