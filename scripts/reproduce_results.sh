#!/usr/bin/env bash
# Makes the tables and figures of the paper, and of Limn beside it: datasets/RESULTS.md and its pictures. Needs the data sets of
# datasets/README.md below ../shared/data (or --data_path). Takes about an hour on two cores.
set -euo pipefail
cd "$(dirname "$0")/.."

sets=pavilion-midday,pavilion-mixed,vase,sample-day,sample-mixed,room
scripts/quality_report.sh --sets $sets "$@"
/usr/bin/python3 scripts/bench/results_page.py build/quality/report.json "$(git rev-parse --short HEAD)" datasets
echo "Look at: datasets/RESULTS.md"
