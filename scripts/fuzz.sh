#!/usr/bin/env bash
# Build the fuzzers of all readers (clang with libFuzzer and sanitizers: packages clang and libclang-rt-14-dev)
# into build/fuzz and run each for some seconds:
#   scripts/fuzz.sh [seconds per target = 60] [targets ...]
# Inputs that a reader crashes on, hangs on or takes too much memory for go to build/fuzz/findings, and the
# script ends with 1. What was learnt about the formats stays in build/fuzz/corpus.
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
# What the address sanitizer holds back counts as resident memory.
export ASAN_OPTIONS=quarantine_size_mb=32
failed=()
for target in "${targets[@]}"; do
  learnt=build/fuzz/corpus/$target
  log=build/fuzz/$target.log
  mkdir -p "$learnt"
  if "build/fuzz/tests/fuzz/fuzz_$target" -max_total_time="$seconds" -max_len=20000 \
    -rss_limit_mb=512 -malloc_limit_mb=256 -timeout=5 -print_final_stats=1 \
    -artifact_prefix="$findings/$target-" "$learnt" "tests/fuzz/corpus/$target" >"$log" 2>&1; then
    runs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
    echo "$target: no finding in $seconds s, $runs inputs"
  else
    failed+=("$target")
    echo "$target: FINDING, see $log"
    grep -m 3 -E '^SUMMARY|ERROR:|runtime error' "$log" || tail -n 3 "$log"
  fi
done
if ((${#failed[@]} > 0)); then
  echo "ERROR: findings in: ${failed[*]}" >&2
  exit 1
fi
