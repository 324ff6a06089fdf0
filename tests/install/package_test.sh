#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# package_test.sh <build folder> <1 or 0: with Python>: make the packages and install them with apt into a Debian
# root that has nothing else; there, draw some images of the sample scene by the program and from Python. With
# LIMN_BUILD_IN_ROOT=1 also install a compiler and the library there (370 MB) and build a program with it; without, only
# see that its packages can be had. Needs root, mmdebstrap and the mirror of the machine's apt.
set -euo pipefail
build=$1 with_python=$2
here=$(cd "$(dirname "$0")" && pwd)
source "$here/bare_root.sh"

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

(cd "$work" && cpack --config "$build/CPackConfig.cmake" -B "$work/packages" >"$work/cpack.log") ||
  { cat "$work/cpack.log"; fail "cpack"; }
version=$(sed -n 's/^set(CPACK_PACKAGE_VERSION "\(.*\)")$/\1/p' "$build/CPackConfig.cmake")
package=limn_${version}_amd64.deb
[[ -f $work/packages/$package ]] || fail "there is no $package: $(ls "$work/packages")"
dpkg-deb --info "$work/packages/$package"

make_root bookworm "$work/root" "$work"
install_package() {
  cp "$work/packages/$1" "$root/root/"
  in_root apt-get install -y -q --no-install-recommends "/root/$1" >"$work/apt.log" 2>&1 ||
    { cat "$work/apt.log"; fail "apt does not install $1"; }
}
in_root apt-get update -q >"$work/apt.log" 2>&1 || { cat "$work/apt.log"; skip "the mirror does not answer"; }
install_package "$package"

in_root limn --version | tee "$work/version"
grep -q "^limn $version" "$work/version" || fail "another version"
for file in man/man1/limn.1 man/man1/limn-automatic_drawer.1 bash-completion/completions/limn doc/limn/copyright; do
  [[ -s $root/usr/share/$file ]] || fail "/usr/share/$file is missing"
done

put_project
in_root limn automatic_drawer "${few_images[@]}" --output_path /root/drawn
for file in drawing.json drawing.ply drawing.obj; do
  [[ -s $root/root/drawn/$file ]] || fail "$file is missing"
done
in_root limn drawing_exporter --input_path /root/drawn/drawing.json --output_path /root/drawn/drawing.glb
# OpenCASCADE and MPI come with the plug-ins.
if in_root sh -c 'ldconfig -p | grep -q -E "libTK|libmpi"'; then fail "the program brings OpenCASCADE or MPI"; fi
in_root limn drawing_exporter --input_path /root/drawn/drawing.json --output_path /root/drawn/drawing.step 2>"$work/refused" &&
  fail "STEP without its plug-in"
grep -q "has no part limn_step.so beside it: install the package limn-step" "$work/refused" || fail "$(cat "$work/refused")"
for plugin in "$work"/packages/limn-*_amd64.deb; do
  [[ -e $plugin ]] || continue
  install_package "$(basename "$plugin")"
done
[[ ! -f $work/packages/limn-step_${version}_amd64.deb ]] ||
  in_root limn drawing_exporter --input_path /root/drawn/drawing.json --output_path /root/drawn/drawing.step

if [[ $with_python == 1 ]]; then
  install_package "python3-limn_${version}_amd64.deb"
  in_root python3 -c '
import limn
stored = limn.read_drawing("/root/drawn/drawing.json")
drawing = limn.draw("/root/project", image_list_path="/root/images.txt", quality="low", max_image_size=320)
assert len(drawing.links) == len(stored.links) > 10, drawing
'
  [[ ! -f $work/packages/limn-step_${version}_amd64.deb ]] ||
    in_root python3 -c 'import limn; limn.read_drawing("/root/drawn/drawing.json").save("/root/python.step")'
fi

cp "$work/packages/liblimn-dev_${version}_amd64.deb" "$root/root/"
in_root apt-get install -s -q --no-install-recommends "/root/liblimn-dev_${version}_amd64.deb" >"$work/apt.log" 2>&1 ||
  { cat "$work/apt.log"; fail "apt would not install the library"; }
[[ ${LIMN_BUILD_IN_ROOT:-0} == 1 ]] || exit 0

# What the package of the library does not bring is missing here.
in_root apt-get install -y -q --no-install-recommends cmake g++ make >"$work/apt.log" 2>&1 ||
  { cat "$work/apt.log"; fail "apt does not install a compiler"; }
install_package "liblimn-dev_${version}_amd64.deb"
cp -r "$here/consumer" "$root/root/"
in_root cmake -S /root/consumer -B /root/build >"$work/configure.log" ||
  { cat "$work/configure.log"; fail "the project is not configured"; }
in_root cmake --build /root/build || fail "the project is not built"
in_root /root/build/consumer /root/project /root/images.txt /root/drawing.json
[[ -s $root/root/drawing.json ]] || fail "the project draws nothing"
