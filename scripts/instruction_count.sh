#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Count the CPU instructions of a small run, which hardly depend on the machine and its load, and compare them with
# scripts/bench/instructions.txt. Fails if they differ by more than 5 %: after a change that is meant to cost or save
# that much, write the new number with --update.
#
#   scripts/instruction_count.sh [--update]
set -euo pipefail
cd "$(dirname "$0")/.."
committed=scripts/bench/instructions.txt
limn=build/release/limn

# The inner loops have two versions; the committed number is of that for AVX2.
if ! grep -qw avx2 /proc/cpuinfo; then
  echo "WARNING: no AVX2 here: instructions were not counted"
  exit
fi
scripts/setup.sh valgrind

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/project"
cp -r datasets/sample/day/sparse "$work/project/sparse"
ln -s "$PWD/datasets/sample/day/images" "$work/project/images"
ls datasets/sample/day/images | head -6 >"$work/names"
valgrind --tool=callgrind --callgrind-out-file="$work/callgrind" --log-file="$work/log" \
  "$limn" automatic_drawer --workspace_path "$work/project" --image_list_path "$work/names" --max_image_size 400 \
  --quality low --num_threads 1 >"$work/output" || {
  cat "$work/output" "$work/log"
  exit 1
}
counted=$(sed -n 's/.*Collected : \([0-9]*\).*/\1/p' "$work/log")
if [[ ${1:-} == --update ]]; then
  echo "$counted" >"$committed"
  echo "$counted instructions, written to $committed"
  exit
fi
awk -v counted="$counted" -v committed="$(cat $committed)" 'BEGIN {
  change = 100 * (counted / committed - 1)
  printf "%.2f billion instructions, %+.1f %% of the committed number\n", counted / 1e9, change
  exit (change > 5 || change < -5)
}' || {
  echo "If that is meant: scripts/instruction_count.sh --update" >&2
  exit 1
}
