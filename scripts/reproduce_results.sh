#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Makes the tables and figures of the paper, and of Limn beside it: datasets/RESULTS.md and its pictures. Takes hours.
# Argument: the folder of data sets (datasets/README.md), by default ../shared/data; those that are not there are left out.
set -euo pipefail
[ $# -le 1 ] || { echo "usage: scripts/reproduce_results.sh [folder of the data sets]" >&2; exit 1; }
data=$(realpath -m "${1:-$(dirname "$0")/../../shared/data}")
cd "$(dirname "$0")/.."

# Those of these data sets that are there.
present() {
  local set there=()
  for set in "$@"; do
    if [[ $set == sample-* || -d $data/${set/pavilion-/pavilion/} ]]; then there+=("$set"); else echo "Left out, not in $data: $set" >&2; fi
  done
  (IFS=,; echo "${there[*]}")
}
scripts/setup.sh python3-opencv python3-matplotlib
commit=$(git describe --always --dirty)
rm -f build/quality{,_quick}/report.json
scripts/stereo_worth.sh
scripts/quality_report.sh --data_path "$data" --sets "$(present sample-day pavilion-midday)"
build/release/tests/bench/quality_report --output_path build/quality_quick --quick 1 --data_path "$data" \
  --sets "$(present pavilion-mixed room vase sample-mixed bench abc-00000952 abc-00004926 herz-jesu-p8 desk book)"
scripts/pose_ladder.sh --data_path "$data"
scripts/measure_street.sh
/usr/bin/python3 scripts/bench/false_confidence.py --limn build/release/limn --data_path "$data" --output_path build/false_confidence
scripts/measure_costs.sh --data_path "$data" --sets "$(present sample-day room pavilion-midday vase bench herz-jesu-p8)"
scripts/benchmark.sh methods
cp build/street/scaling.png datasets/results/
/usr/bin/python3 scripts/bench/results_page.py --commit "$commit" --report build/quality/report.json \
  --report build/quality_quick/report.json --section build/ladder/ladder.md --section build/stereo_worth/section.md \
  --section build/false_confidence/section.md --section build/costs/section.md --section build/street/section.md --section build/benchmark/section.md datasets
echo "Look at: datasets/RESULTS.md"
