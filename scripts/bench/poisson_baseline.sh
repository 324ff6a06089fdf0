#!/usr/bin/env bash
# What COLMAP makes of the sample scene's surfaces, as a baseline for faces: depth maps as stereo makes them
# (degrade_depth.py), fused and meshed by COLMAP, and scored against the true surfaces. Needs colmap, numpy, OpenCV.
#
#   scripts/bench/poisson_baseline.sh LIMN OUT [trim ...]
#
# LIMN is the program, OUT a new folder; it keeps the meshes. A higher trim cuts more of the surface between the points.
set -euo pipefail
limn=$(realpath "$1")
out=$2
shift 2
trims=("${@:-5}")
cd "$(dirname "$0")/../.."
sample=$PWD/datasets/sample
export QT_QPA_PLATFORM=offscreen
mkdir "$out"

/usr/bin/python3 scripts/sample_scene/degrade_depth.py "$sample/day" "$out/dense"
colmap stereo_fusion --workspace_path "$out/dense" --workspace_format COLMAP --input_type geometric \
  --output_path "$out/dense/fused.ply" >"$out/colmap.log" 2>&1
for trim in ${trims[*]}; do
  colmap poisson_mesher --input_path "$out/dense/fused.ply" --output_path "$out/poisson-$trim.ply" \
    --PoissonMeshing.depth 8 --PoissonMeshing.trim "$trim" >>"$out/colmap.log" 2>&1
  echo "poisson, trim $trim"
  "$limn" drawing_evaluator --workspace_path "$sample/day" --truth_mesh_path "$sample/truth/mesh.ply" \
    --mesh_path "$out/poisson-$trim.ply" --box=-1.25,1.25,-0.95,0.95,0.04,1.05 --output_json "$out/poisson-$trim.json"
done
