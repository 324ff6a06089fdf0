#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Rebuilds the committed sample scene: about 40 minutes on two cores. For maintainers; users and CI use the
# committed files. Needs Debian 12's blender, colmap, python3-numpy, python3-opencv and python3-scipy.
#
#   scripts/sample_scene/build.sh [folder for frames and COLMAP's databases]
set -eu
here=$(cd "$(dirname "$0")" && pwd)
sample=$(cd "$here/../.." && pwd)/datasets/sample
work=${1:-/tmp/limn-sample}

in_blender() {
  script=$1
  shift
  nice -n 19 blender --background --python "$here/$script" -- "$@" | grep -v '^Fra:'
}

in_blender render.py --light day --output "$work/frames/day" --samples 64
in_blender render.py --light evening --output "$work/frames/evening" --samples 40
in_blender render.py --light lamp --output "$work/frames/lamp" --samples 40
in_blender render.py --light day --distorted --output "$work/frames/distorted" --samples 20
/usr/bin/python3 "$here/make_workspaces.py" --frames "$work/frames" --sample "$sample"
/usr/bin/python3 "$here/sift_points.py" --sample "$sample" --work "$work/colmap" --points
in_blender truth.py --sample "$sample" --depth
/usr/bin/python3 "$here/mesh.py" --output "$sample/truth/mesh.ply"
in_blender verify.py --sample "$sample" --overlays "$work/overlays"
