#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Build the fuzzers of all readers (clang with libFuzzer and sanitizers: packages clang and libclang-rt-14-dev)
# into build/fuzz and run each for some seconds:
#   scripts/fuzz.sh [seconds per target = 60] [targets ...]
# Inputs that make a reader crash, hang or use too much memory are stored in build/fuzz/findings, and the exit code
# is 1. The grown corpus stays in build/fuzz/corpus.
set -euo pipefail
cd "$(dirname "$0")/.."

seconds=${1:-60}
targets=("${@:2}")
if ((${#targets[@]} == 0)); then
  for folder in tests/fuzz/corpus/*/; do targets+=("$(basename "$folder")"); done
fi

cmake --preset fuzz >/dev/null
cmake --build --preset fuzz
findings=build/fuzz/findings
mkdir -p "$findings"
# The address sanitizer's quarantine counts as resident memory.
export ASAN_OPTIONS=quarantine_size_mb=32

# run <target> <arguments ...>
run() {
  "build/fuzz/tests/fuzz/fuzz_$1" -max_len=20000 -rss_limit_mb=512 -malloc_limit_mb=256 -timeout=5 "${@:2}"
}
# Whether an input still fails: on a busy machine five seconds of wall time pass easily.
still_fails() {
  for input in "$findings/$1"-*; do
    [[ -e $input ]] || continue
    run "$1" "$input" >>"$2" 2>&1 || return 0
    rm "$input"
  done
  return 1
}

failed=()
for target in "${targets[@]}"; do
  learnt=build/fuzz/corpus/$target
  log=build/fuzz/$target.log
  mkdir -p "$learnt"
  run "$target" -max_total_time="$seconds" -print_final_stats=1 -artifact_prefix="$findings/$target-" \
    "$learnt" "tests/fuzz/corpus/$target" >"$log" 2>&1 && outcome="no finding" || outcome="stopped"
  if still_fails "$target" "$log" || { [[ $outcome == stopped ]] && ! grep -a -q "libFuzzer: timeout" "$log"; }; then
    failed+=("$target")
    echo "$target: FINDING, see $log"
    grep -a -m 3 -E '^SUMMARY|ERROR:|runtime error' "$log" || tail -n 3 "$log"
  else
    runs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
    echo "$target: no finding in $seconds s, $runs inputs"
  fi
done
if ((${#failed[@]} > 0)); then
  echo "ERROR: findings in: ${failed[*]}" >&2
  exit 1
fi
