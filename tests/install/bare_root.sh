# SPDX-License-Identifier: BSD-3-Clause
# Sourced by the tests beside it: Debian roots that have nothing but apt, of the mirror of the machine's apt.

source "$(dirname "${BASH_SOURCE[0]}")/../../scripts/packaging/own_apt.sh"

skip() {
  echo "SKIPPED: $*"
  exit 77
}
fail() {
  echo "FAILED: $*" >&2
  exit 1
}
command -v mmdebstrap >/dev/null || skip "mmdebstrap is not installed"
((EUID == 0)) || skip "a root of its own needs root"

proxies=()
for name in http_proxy https_proxy no_proxy; do
  [[ -z ${!name:-} ]] || proxies+=("$name=${!name}")
done

# make_root <release> <folder> <folder of logs> [<packages, separated by commas>]
make_root() {
  local mirror more=()
  mirror=$(debian_mirror Debian)
  [[ -z ${4:-} ]] || more=(--include="$4")
  timeout 300 mmdebstrap --quiet --variant=apt --aptopt='Acquire::Retries "2"' --aptopt='Acquire::http::Timeout "30"' "${more[@]}" \
    "$1" "$2" "${mirror:-http://deb.debian.org/debian}" 2>"$3/mmdebstrap.log" ||
    { cat "$3/mmdebstrap.log"; skip "no root of Debian $1 can be made here"; }
  root=$2
}

# With /proc, by which programs know where they are, for the time of the command.
in_root() {
  timeout 600 unshare --mount sh -c 'mount -t proc proc "$1/proc" && shift && exec "$@"' in_root "$root" chroot "$root" env -i "${proxies[@]}" PATH=/usr/bin:/bin:/usr/sbin:/sbin HOME=/root DEBIAN_FRONTEND=noninteractive "$@"
}

# Six images of the sample scene.
put_project() {
  local sample
  sample=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../datasets/sample/day" && pwd)
  mkdir "$root/root/project"
  cp -r "$sample/images" "$sample/sparse" "$root/root/project/"
  printf 'view_0%d.jpg\n' 0 1 2 3 4 5 >"$root/root/images.txt"
}
# Options to draw them quickly.
few_images=(--workspace_path /root/project --image_list_path /root/images.txt --quality low --max_image_size 320)
