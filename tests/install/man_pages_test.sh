#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# man_pages_test.sh <folder of pages> <program>: they are displayed without warnings and tell every option.
set -euo pipefail
pages=$1 limn=$2
command -v man >/dev/null || { echo "SKIPPED: man is not installed"; exit 77; }

failed=0
fail() {
  echo "FAILED: $*" >&2
  failed=1
}
for command in $("$limn" help --help_format words); do
  page=$pages/limn-$command.1
  [[ -s $page ]] || { fail "$page is missing"; continue; }
  text=$(MANWIDTH=200 man -l -E ascii "$page" | col -bx)
  for option in $("$limn" "$command" --help_format words | grep -o '^--[A-Za-z_.]*'); do
    grep -q -E -- " $option( |\$)" <<<"$text" || fail "$page does not tell $option"
  done
done
for page in "$pages"/*.1; do
  warnings=$(LC_ALL=C.UTF-8 man --warnings -l -E UTF-8 "$page" 2>&1 >/dev/null)
  if command -v mandoc >/dev/null; then
    # The same version makes the same page on any day.
    warnings+=$(mandoc -T lint -W warning "$page" | grep -v 'missing date' || true)
  fi
  [[ -z $warnings ]] || fail "$warnings"
done
exit $failed
