#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Install the packages for building and testing Limn (Debian 12), and those given as arguments. Does nothing if all
# are installed.
set -euo pipefail

packages=(
  cmake ninja-build ccache g++ python3 clang-format
  libeigen3-dev libopencv-dev libicu-dev libjpeg-dev libceres-dev libgoogle-glog-dev libflann-dev liblz4-dev libnanoflann-dev libtbb-dev zlib1g-dev libsqlite3-dev
  libboost-program-options-dev libboost-mpi-dev libopenmpi-dev openmpi-bin nlohmann-json3-dev libtinygltf-dev libocct-data-exchange-dev
  libfontconfig-dev  # which OpenCASCADE of Debian 13 asks for
  libgtest-dev libgmock-dev libbenchmark-dev
  python3-dev pybind11-dev python3-numpy python3-setuptools python3-wheel python3-venv python3-pip python3-networkx mypy
  colmap
  "$@"
)

# The viewer's page is bundled with node 18 or newer and npm. Debian's are installed only if there are no others.
command -v node >/dev/null || packages+=(nodejs)
command -v npm >/dev/null || packages+=(npm)

missing=()
for package in "${packages[@]}"; do
  status=$(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null || true)
  [[ $status == installed ]] || missing+=("$package")
done
if ((${#missing[@]} == 0)); then
  exit 0
fi

echo "Installing: ${missing[*]}"
as_root=()
((EUID == 0)) || as_root=(sudo)

# apt_get <arguments>: waits up to ten minutes for other installations. apt's own option waits only for dpkg's lock,
# not for that of the package lists.
apt_get() {
  local log status deadline=$((SECONDS + 600))
  log=$(mktemp)
  while true; do
    status=0
    "${as_root[@]}" env LC_ALL=C DEBIAN_FRONTEND=noninteractive \
      apt-get -q -o DPkg::Lock::Timeout=600 -o Acquire::http::Timeout=30 -o Acquire::Retries=3 "$@" 2>&1 | tee "$log" || status=$?
    ((status != 0 && SECONDS < deadline)) || break
    grep -q -E 'Could not get lock|Unable to (acquire|lock)' "$log" || break
    echo "Waiting for another program that holds the lock of apt"
    sleep 5
  done
  rm "$log"
  return "$status"
}

apt_get update
apt_get install -y --no-install-recommends "${missing[@]}"
