#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Build, render the sample scene's long path (once; half an hour), and measure how time and memory of the main job
# grow from 25 to 100 views.
#
#   scripts/measure_scaling.sh [runs]
set -euo pipefail
cd "$(dirname "$0")/.."
cmake --preset release >/dev/null
cmake --build --preset release --target limn >/dev/null
[[ -e build/long/views-100.txt ]] || scripts/sample_scene/build_long.sh build/long
python3 scripts/bench/measure_scaling.py build/release/limn build/long "$@"
