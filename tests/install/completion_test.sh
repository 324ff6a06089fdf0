#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# completion_test.sh <program>: what the completion of Bash offers.
set -uo pipefail
limn=$1
here=$(cd "$(dirname "$0")" && pwd)
# shellcheck source=../../scripts/packaging/completion.bash
. "$here/../../scripts/packaging/completion.bash"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/my project"
touch "$work/my.ini"
failed=0

# expect <what must be offered, a pattern of all offers> <words before the cursor...>
expect() {
  local expected=$1
  shift
  COMP_WORDS=("$@") COMP_CWORD=$(($# - 1)) COMPREPLY=()
  _limn "$limn" "${COMP_WORDS[COMP_CWORD]}" "${COMP_WORDS[COMP_CWORD - 1]}"
  local offers
  offers=$(IFS='|' && echo "${COMPREPLY[*]}")
  # shellcheck disable=SC2053 # a pattern
  if [[ $offers != $expected ]]; then
    echo "FAILED: limn ${*:2}: offers '$offers', not '$expected'" >&2
    failed=1
  fi
}

complete -p limn >/dev/null || failed=1
expect 'automatic_drawer' limn au
expect '*edge_extractor|*|truth_extractor' limn ''
expect '--workspace_path' limn automatic_drawer --work
expect '*--DrawingRefinement.num_rounds|*' limn automatic_drawer --DrawingR
expect 'low|medium|high' limn automatic_drawer --quality ''
expect 'medium' limn automatic_drawer --quality me
expect 'medium' limn automatic_drawer --quality = me
expect 'low|medium|high' limn automatic_drawer --quality =
expect '0|1' limn automatic_drawer --page ''
expect '' limn automatic_drawer --num_threads ''
expect "$work/my*|$work/my*" limn automatic_drawer --workspace_path "$work/m"
expect "$work/my project" limn automatic_drawer --workspace_path "$work/my p"
expect '*--page*' limn automatic_drawer --quality low --pag
expect '' limn automatic_drawer --quality low --qual
expect '--known_length' limn drawing_aligner --known_length 'link 1 = 2 m' --known
expect '' limn no_such_command --
exit $failed
