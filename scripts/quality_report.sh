#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Install, build, measure all available data sets, plot precision-recall curves. Results: build/quality.
# Arguments go to quality_report: `scripts/quality_report.sh --quick 1 --sets sample-day,vase`.
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/setup.sh python3-matplotlib
cmake --preset release
cmake --build --preset release --target quality_report

out=build/quality
build/release/tests/bench/quality_report --output_path $out "$@"
/usr/bin/python3 scripts/plot_quality.py $out/report.json
echo "Look at: $out/report.md, $out/precision-recall-*.png, $out/*/*-beside-pmvs.png"
