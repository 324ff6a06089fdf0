#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Build, and measure how time and memory of the stages after the image curves grow from 25 to 1,000 views of a generated
# street (tests/bench/large_scene.cc), as a section of datasets/RESULTS.md: build/street/section.md. Some ten minutes.
set -euo pipefail
cd "$(dirname "$0")/.."
cmake --preset release >/dev/null
cmake --build --preset release --target large_scene >/dev/null
for views in 25 100 400 1000; do
  build/release/tests/bench/large_scene --views $views --accuracy 0 --tile_views 150 --output_path build/street/$views
done
/usr/bin/python3 scripts/bench/street_section.py build/street build/street/scaling.png >build/street/section.md
echo "Look at: build/street/section.md, scaling.png"
