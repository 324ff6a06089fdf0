#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Install, build, measure time, memory and accuracy of every stage on all available data sets.
# Results: build/stages. Arguments go to stage_report: `scripts/stage_report.sh --repeat 3 --sets sample-day,vase`.
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/setup.sh
cmake --preset release
cmake --build --preset release --target stage_report

out=build/stages
mkdir -p $out
build/release/tests/bench/stage_report --output_path $out --commit "$(git describe --always --dirty)" "$@"
cat $out/report.md
