#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The sample scene as a benchmark for any method that makes curves of photographs (datasets/README.md):
#   scripts/benchmark.sh inputs                     make its inputs, build/benchmark/<rung>
#   scripts/benchmark.sh score <rung> my.ply        score a PLY or OBJ file of curves
#   scripts/benchmark.sh methods                    the expected numbers of four methods; takes an hour on two cores
set -euo pipefail
here=$(cd "$(dirname "$0")/.." && pwd)
"$here/scripts/setup.sh" python3-opencv
(cd "$here" && cmake --preset release >/dev/null && cmake --build --preset release --target limn pose_noise >/dev/null)
exec /usr/bin/python3 "$here/scripts/bench/benchmark.py" "$@"
