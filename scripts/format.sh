#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Format all C++ sources, and the viewer's JavaScript if a build has installed prettier. With --check: change
# nothing, fail if something would change.
set -euo pipefail
cd "$(dirname "$0")/.."

mode=(-i)
[[ ${1:-} == --check ]] && mode=(--dry-run -Werror)
git ls-files -z -- '*.cc' '*.h' | xargs -0 clang-format "${mode[@]}"

page=src/limn/viewer/page
prettier=$(find build -path "*/limn/viewer/page/node_modules/.bin/prettier" -print -quit 2>/dev/null || true)
if [[ -n $prettier ]]; then
  mode=(--write)
  [[ ${1:-} == --check ]] && mode=(--check)
  "$prettier" --config $page/.prettierrc.json --log-level warn "${mode[@]}" $page tests/browser/*.mjs \
    tests/bench/*.mjs
fi
