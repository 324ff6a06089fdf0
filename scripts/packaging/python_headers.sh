#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# python_headers.sh <folder>: the headers of the Pythons of Debian 12 and 13, and of Debian 13's pybind11, into
# <folder>/usr/include: for LIMN_PYTHON_ROOTS. Nothing of it is installed. Does nothing if they are there.
set -euo pipefail
mkdir -p "$1"
folder=$(cd "$1" && pwd)
[[ -f $folder/done ]] && exit 0
source "$(dirname "$0")/own_apt.sh"
own_apt "$folder/apt" deb "bookworm trixie"
mkdir -p "$folder/packages"
cd "$folder/packages"
apt_get download libpython3.11-dev/bookworm libpython3.13-dev/trixie pybind11-dev/trixie
for package in *.deb; do dpkg-deb --extract "$package" "$folder/extracted"; done
mkdir -p "$folder/usr"
cp -r "$folder/extracted/usr/include" "$folder/usr/"
rm -rf "$folder/extracted" "$folder/packages" "$folder/apt"
touch "$folder/done"
