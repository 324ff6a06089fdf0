#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Renders panoramas by day at the places of the sample scene's photographs, with half their resolution: half an hour on
# two cores. Never committed. Needs Debian 12's blender, python3-numpy and python3-opencv. Existing frames are kept.
#
#   scripts/sample_scene/build_panoramas.sh [folder]      default: build/panoramas
#
# Then, against the photographs at the same size of pixels:
#   limn automatic_drawer --workspace_path build/panoramas
#   limn automatic_drawer --workspace_path datasets/sample/day --max_image_size 320 --output_path build/half
set -eu
here=$(cd "$(dirname "$0")" && pwd)
out=${1:-$here/../../build/panoramas}

nice -n 19 blender --background --python "$here/render.py" -- \
  --light day --panorama 2010 --output "$out/frames" --samples 32 | grep -v '^Fra:'
/usr/bin/python3 "$here/panorama_workspace.py" --frames "$out/frames" --output "$out"
