#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Build, then time the main job and COLMAP's feature_extractor and exhaustive_matcher (CPU) on the same images.
#
#   scripts/compare_colmap.sh WORKSPACE [runs]
set -euo pipefail
cd "$(dirname "$0")/.."
cmake --preset release >/dev/null
cmake --build --preset release --target limn >/dev/null
python3 scripts/bench/compare_colmap.py build/release/limn "$@"
