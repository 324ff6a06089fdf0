#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds, then measures what refined cameras are worth to dense stereo: the sample scene with cameras that are off by 1 and 3 px, as given
# and refined, against its exact depth maps. Results: build/stereo_worth/section.md. Needs Debian's python3-opencv. Takes some minutes.
set -euo pipefail
cd "$(dirname "$0")/.."
/usr/bin/python3 -c "import cv2" 2>/dev/null || { echo "ERROR: scripts/stereo_worth.sh needs OpenCV for Python: apt-get install python3-opencv" >&2; exit 1; }
cmake --preset release >/dev/null
cmake --build --preset release --target limn pose_noise >/dev/null

out=build/stereo_worth
rm -rf $out
models=()
for px in 1 3; do
  build/release/tests/bench/pose_noise --set sample-day --error_px $px --seed 1 --output_path $out/given-$px
  build/release/limn camera_refiner --workspace_path $out/given-$px --output_path $out/refined-$px
  models+=(--model "given, $px px=$out/given-$px/sparse/0" --model "refined, $px px=$out/refined-$px/refined")
done
/usr/bin/python3 scripts/bench/stereo_before_after.py --workspace_path datasets/sample/day "${models[@]}" --output_path $out \
  --depth_range 1.3,7 --baseline 0.3,1.2 --planes z=0
{
  cat <<'EOF'
## What better cameras are worth

Written by `scripts/stereo_worth.sh`: dense stereo of the sample scene (OpenCV's semi-global matcher, the same pairs for all cameras; COLMAP's own needs
CUDA), with exact cameras, with cameras that are off, and with these refined by curves. *Right*: depth within 1 % of the exact one; *error*: of the
depth, where exact cameras also match; *layers*: how far depths of one pixel from several pairs are apart; *confirmed*: by another pair, within 1 %;
*plane*: distance from the table; *walls_apart*: how far pairs place it differently; in units of the model. Pairs are median / 90 %.

EOF
  cat $out/stereo.md
} > $out/section.md
