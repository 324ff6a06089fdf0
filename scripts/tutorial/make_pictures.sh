#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The commands of colmap_ext/docs/tutorial.md on the sample scene, in build/tutorial, and their pictures: datasets/tutorial/.
# Needs the build with its tests (whose browser it takes) and, by scripts/setup.sh: chromium colmap python3-opencv
# python3-ezdxf python3-matplotlib librsvg2-bin.
set -euo pipefail
cd "$(dirname "$0")/../.."

limn=$PWD/build/release/limn
here=$PWD/scripts/tutorial
out=$PWD/build/tutorial
pictures=$PWD/datasets/tutorial
project=$out/my_project
rm -rf "$out" && mkdir -p "$out" "$pictures"

# Dense results, as stereo leaves them: depth maps need a GPU.
/usr/bin/python3 scripts/sample_scene/degrade_depth.py datasets/sample/day "$project"
QT_QPA_PLATFORM=offscreen colmap stereo_fusion --workspace_path "$project" --input_type geometric \
  --output_path "$project/fused.ply" >"$out/colmap.log" 2>&1

$limn automatic_drawer --workspace_path "$project" --align auto
python3 "$here/edits.py" "$project/drawing.json" "$out/edits.json"
$limn drawing_editor --workspace_path "$project" --edits "$out/edits.json" --overwrite 1
length=$(python3 "$here/known_length.py" "$project/drawing.json")
$limn drawing_aligner --workspace_path "$project" --known_length "$length"
$limn drawing_surfacer --workspace_path "$project" --overwrite 1
$limn drawing_fuser --workspace_path "$project"
$limn drawing_viewer --workspace_path "$project" --overwrite 1
$limn drawing_exporter --workspace_path "$project" --output_path "$out/plan.dxf" --section 0.3 --detail coarse
$limn drawing_exporter --workspace_path "$project" --output_path "$out/view.svg" --aligned 1 --view axonometric \
  --colors kind --detail coarse

/usr/bin/python3 "$here/draw_pictures.py" "$project" "$out" "$pictures"
LIMN_BROWSER_PACKAGES=$PWD/build/release/tests/browser/packages LIMN_PAGES=$project \
  node "$here/page_pictures.mjs" "$out"
/usr/bin/python3 "$here/draw_pictures.py" --shrink "$out" "$pictures"
ls -l "$pictures"
