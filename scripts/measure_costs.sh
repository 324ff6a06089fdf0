#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds, and measures time and memory of every stage on all available data sets, and the main job beside COLMAP's first steps on
# the sample scene, as a section of datasets/RESULTS.md: build/costs/section.md.
#   scripts/measure_costs.sh [--data_path FOLDER] [--sets sample-day,vase] [--repeat 3]
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/setup.sh
cmake --preset release >/dev/null
cmake --build --preset release --target stage_report >/dev/null
out=build/costs
mkdir -p $out
build/release/tests/bench/stage_report --output_path $out --commit "$(git describe --always --dirty)" "$@"
scripts/compare_colmap.sh datasets/sample/day 3 >$out/colmap.md
/usr/bin/python3 scripts/bench/costs_section.py $out/report.json $out/colmap.md >$out/section.md
echo "Look at: $out/section.md"
