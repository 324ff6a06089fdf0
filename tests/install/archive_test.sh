#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# archive_test.sh <folder of scripts/packaging/archive.sh>: unpack the archive in roots of Debian 12 and 13 that have
# nothing else, draw some images of the sample scene there, make a page, export; the same from Python, with numpy 1 and
# 2, and by the wheels in environments of their own. Needs root and mmdebstrap.
set -euo pipefail
portable=$1
here=$(cd "$(dirname "$0")" && pwd)
source "$here/bare_root.sh"
archive=$(find "$portable" -maxdepth 1 -name 'limn-*-linux-*.tar.gz' 2>/dev/null) || true
[[ -n $archive ]] || skip "no archive was made: scripts/packaging/archive.sh"
(cd "$portable" && sha256sum --quiet --check SHA256SUMS) || fail "SHA256SUMS"
(($(stat -c %s "$archive") < 120000000)) || fail "the archive is larger than 120 MB"

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# try <release> <tag of its Python>
try() {
  make_root "$1" "$work/$1" "$work" python3-numpy,python3-venv
  put_project
  mkdir "$root/opt/anywhere"
  tar -C "$root/opt/anywhere" -xzf "$archive"
  mv "$root"/opt/anywhere/limn-* "$root/opt/anywhere/limn"
  ln -s /opt/anywhere/limn/bin/limn "$root/usr/bin/limn"  # found by PATH, and by a link
  in_root limn --version
  in_root limn automatic_drawer "${few_images[@]}" --output_path /root/drawn >"$work/log" || fail "$(cat "$work/log")"
  for file in drawing.json drawing.ply drawing.html; do
    [[ -s $root/root/drawn/$file ]] || fail "Debian $1: $file is missing"
  done
  for format in step glb dxf; do
    in_root limn drawing_exporter --input_path /root/drawn/drawing.json --output_path "/root/drawn/drawing.$format"
  done
  # Without the system's MPI it says what to do.
  if in_root env OMPI_COMM_WORLD_SIZE=2 limn automatic_drawer "${few_images[@]}" --output_path /root/mpi 2>"$work/refused"; then
    fail "Debian $1: MPI without MPI"
  fi
  grep -q -- "--shard i/n" "$work/refused" || fail "$(cat "$work/refused")"
  cat >"$root/root/draw.py" <<'END'
import limn
stored = limn.read_drawing("/root/drawn/drawing.json")
drawing = limn.draw("/root/project", image_list_path="/root/images.txt", quality="low", max_image_size=320)
assert len(drawing.links) == len(stored.links) > 10, drawing
drawing.save("/root/python.step")
END
  in_root env PYTHONPATH=/opt/anywhere/limn/python python3 /root/draw.py
  rm "$root/usr/bin/limn"
  rm -r "$root/opt/anywhere"

  cp "$portable"/limn_colmap-*-"$2"-*.whl "$root/root/"
  in_root python3 -m venv --system-site-packages /root/venv
  in_root sh -c '/root/venv/bin/pip install --no-index /root/limn_colmap-*.whl' >"$work/log" 2>&1 || fail "$(cat "$work/log")"
  in_root /root/venv/bin/python /root/draw.py
  in_root /root/venv/bin/limn automatic_drawer "${few_images[@]}" --output_path /root/by_wheel >"$work/log" || fail "$(cat "$work/log")"
  cmp "$root/root/drawn/drawing.ply" "$root/root/by_wheel/drawing.ply" || fail "Debian $1: the wheel draws something else"
  rm -rf "$root"
  echo "Debian $1: drawn by the archive, in Python, and by the wheel"
}
try bookworm cp311
try trixie cp313
