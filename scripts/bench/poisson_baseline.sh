#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# What COLMAP makes of the surfaces of the sample scene, as a baseline for faces: depth maps as stereo makes them
# (degrade_depth.py), and exact ones, fused and meshed by COLMAP (Poisson) and scored against the true surfaces.
# Needs colmap, numpy, OpenCV.
#
#   scripts/bench/poisson_baseline.sh LIMN OUT [depth ...]
#
# LIMN is the program, OUT a new folder, which keeps the meshes; depth: of Poisson's octree, 8 and 10 by default.
set -euo pipefail
limn=$(realpath "$1")
out=$(realpath -m "$2")
shift 2
[ $# -gt 0 ] || set -- 8 10
cd "$(dirname "$0")/../.."
sample=$PWD/datasets/sample
export QT_QPA_PLATFORM=offscreen
mkdir "$out"

for kind in stereo exact; do
  dense=$out/$kind
  [ $kind = exact ] && exact=--exact || exact=
  /usr/bin/python3 scripts/sample_scene/degrade_depth.py "$sample/day" "$dense" $exact
  colmap stereo_fusion --workspace_path "$dense" --workspace_format COLMAP --input_type geometric \
    --output_path "$dense/fused.ply" >"$dense/colmap.log" 2>&1
  for depth; do
    colmap poisson_mesher --input_path "$dense/fused.ply" --output_path "$dense/poisson-$depth.ply" \
      --PoissonMeshing.depth "$depth" --PoissonMeshing.trim 5 >>"$dense/colmap.log" 2>&1
    echo "$kind depth maps, Poisson of depth $depth"
    "$limn" drawing_evaluator --workspace_path "$sample/day" --truth_mesh_path "$sample/truth/mesh.ply" \
      --mesh_path "$dense/poisson-$depth.ply" --box=-1.25,1.25,-0.95,0.95,0.04,1.05 \
      --output_json "$dense/poisson-$depth.json"
  done
done
