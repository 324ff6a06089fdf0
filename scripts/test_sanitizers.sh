#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Build with the address and undefined-behavior sanitizers, into build/asan, and run tests:
#   scripts/test_sanitizers.sh [test programs ...]
# All except the slow ones by default.
set -euo pipefail
cd "$(dirname "$0")/.."

# Suppressed leaks of libraries, with reasons. Programs under test must not list them.
export LSAN_OPTIONS="print_suppressions=0:suppressions=$PWD/tests/lsan_suppressions.txt"
cmake --preset asan
if (($# == 0)); then
  cmake --build --preset asan
  ctest --preset asan --label-exclude slow
else
  cmake --build --preset asan --target "$@"
  names=$(IFS='|' && echo "$*")
  ctest --preset asan --no-tests=error -R "^($names)\$"
fi
