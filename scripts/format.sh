#!/usr/bin/env bash
# Format all C++ sources. With --check: change nothing, fail if something would change.
set -euo pipefail
cd "$(dirname "$0")/.."

mode=(-i)
[[ ${1:-} == --check ]] && mode=(--dry-run -Werror)
git ls-files -z -- '*.cc' '*.h' | xargs -0 clang-format "${mode[@]}"
