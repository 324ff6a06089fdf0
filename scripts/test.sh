#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Install, build with warnings as errors, run all tests: scripts/test.sh [--sanitizers] [options of ctest ...]
# With --sanitizers builds again then and runs the quick tests under the address and undefined-behavior sanitizers.
set -euo pipefail
cd "$(dirname "$0")/.."

sanitizers=false
if [[ ${1:-} == --sanitizers ]]; then
  sanitizers=true
  shift
fi
scripts/setup.sh python3-opencv python3-ezdxf python3-matplotlib librsvg2-bin chromium \
  dpkg-dev man-db mandoc mmdebstrap python3-yaml
cmake --preset release  # the same as in run_sample.sh: nothing is compiled twice
cmake --build --preset release
ctest --preset release --parallel 2 "$@"

! $sanitizers || scripts/test_sanitizers.sh
