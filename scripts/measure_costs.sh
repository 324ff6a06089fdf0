#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds, and measures time and memory of every stage, and the main job beside COLMAP's first steps, as a section of
# datasets/RESULTS.md: build/costs/section.md.
#   scripts/measure_costs.sh [--data_path FOLDER] [--sets sample-day,vase]     options of stage_report
set -euo pipefail
cd "$(dirname "$0")/.."
cmake --preset release >/dev/null
cmake --build --preset release --target stage_report >/dev/null
out=build/costs
mkdir -p $out
build/release/tests/bench/stage_report --output_path $out --commit "$(git describe --always --dirty)" "$@"
scripts/compare_colmap.sh datasets/sample/day >$out/colmap.md
/usr/bin/python3 scripts/bench/costs_section.py $out/report.json $out/colmap.md >$out/section.md
echo "Look at: $out/section.md"
