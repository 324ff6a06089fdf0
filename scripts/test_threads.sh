#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Build the tests of parallel code with the thread sanitizer, into build/tsan, and run them:
#   scripts/test_threads.sh [test programs ...]
# Suppressions, with reasons, are in tests/tsan_suppressions.txt.
set -euo pipefail
cd "$(dirname "$0")/.."

tests=("$@")
if ((${#tests[@]} == 0)); then
  tests=(limn_util_test edges_test linking_test limn_sketch_test limn_drawing_test limn_refinement_test
    limn_pipeline_test end_to_end_determinism_test)
fi
cmake --preset tsan >/dev/null
cmake --build --preset tsan --target "${tests[@]}"

# Suppressions may match the stack of the older access, which needs a long history.
export TSAN_OPTIONS="suppressions=$PWD/tests/tsan_suppressions.txt halt_on_error=1 history_size=7"
# Minutes by itself; FindsMostOfTheCube runs the same loops.
export GTEST_FILTER=-OriginalSketchTest.CurvesAreSound
names=$(IFS='|' && echo "${tests[*]}")
ctest --preset tsan --no-tests=error -R "^($names)\$"
