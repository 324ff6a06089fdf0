#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Makes the tables and figures of the paper, and of Limn beside it: datasets/RESULTS.md and its pictures. Takes about two hours on two
# cores, and some more for cameras that are wrong. Needs Debian's python3-opencv.
# Argument: the folder of the data sets of datasets/README.md, by default ../shared/data.
set -euo pipefail
[ $# -le 1 ] || { echo "usage: scripts/reproduce_results.sh [folder of the data sets]" >&2; exit 1; }
data=$(realpath "${1:-$(dirname "$0")/../../shared/data}")
cd "$(dirname "$0")/.."

sets=sample-day,pavilion-midday,pavilion-mixed,room,vase
rm -f build/quality/report.json
scripts/stereo_worth.sh
scripts/quality_report.sh --sets $sets --data_path "$data"
scripts/pose_ladder.sh --data_path "$data"
scripts/measure_street.sh
scripts/benchmark.sh methods
/usr/bin/python3 scripts/bench/results_page.py build/quality/report.json "$(git describe --always --dirty)" datasets build/ladder/ladder.md \
  build/stereo_worth/section.md build/street/section.md build/benchmark/section.md
echo "Look at: datasets/RESULTS.md"
