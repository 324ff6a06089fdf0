#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds, then draws data sets with cameras that are off by 0 to 3 px, as given and refined, and at three sizes. Results: build/ladder.
# A stopped run goes on where it was. Arguments go to pose_ladder.py: `scripts/pose_ladder.sh --sets sample-day,room --errors 0.25,1 --seeds 1,2`.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/setup.sh python3-opencv
cmake --preset release >/dev/null
cmake --build --preset release --target limn pose_noise >/dev/null
/usr/bin/python3 scripts/bench/pose_ladder.py --limn build/release/limn --pose_noise build/release/tests/bench/pose_noise --output_path build/ladder "$@"
