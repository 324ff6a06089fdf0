#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Renders the sample scene by day on its long path of 100 views, for scripts/measure_scaling.sh. Never committed.
# Needs Debian 12's blender, python3-numpy and python3-opencv. Existing frames are kept.
#
#   scripts/sample_scene/build_long.sh [folder]      default: build/long
set -eu
here=$(cd "$(dirname "$0")" && pwd)
out=${1:-$here/../../build/long}

nice -n 19 blender --background --python "$here/render.py" -- \
  --light day --long --output "$out/frames" --samples 8 | grep -v '^Fra:'
/usr/bin/python3 "$here/long_workspace.py" --frames "$out/frames" --output "$out"
