#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Install, build, draw the sample scene and compare the drawing with the truth. Results: build/sample.
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/setup.sh
cmake --preset release
cmake --build --preset release --target limn

limn=build/release/limn
scene=datasets/sample
out=build/sample
$limn automatic_drawer --workspace_path $scene/day --output_path $out --overwrite 1
echo
echo "The drawing against the visible truth, distances in pixels where they are seen:"
$limn drawing_evaluator --input_path $out/drawing.json \
  --truth_path $scene/truth/curves-visible.ply --junctions_path $scene/truth/junctions.json \
  --dont_care_path $scene/truth/dont-care.ply --box=-1.25,1.25,-0.95,0.95,0.04,1.05 \
  --unit footprint --workspace_path $scene/day --taus 1,2,4
echo
echo "Look at: $out/drawing.ply (any mesh viewer), $out/curves/overlays/"
