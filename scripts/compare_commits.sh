#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Builds two commits (in build/compare/<commit>) and measures them alternately on this machine.
#
#   scripts/compare_commits.sh A B [--repeat 3] [--sets sample-day,vase]         stage_report of both
#   scripts/compare_commits.sh A B [--repeat 3] --workspace FOLDER               limn automatic_drawer of both: for
#                                                                   commits that have no stage_report yet
#   scripts/compare_commits.sh A B [--repeat 3] --target T -- COMMAND ...        any command, measured as a whole;
#                                     {build} is the build folder, {new} a fresh folder, T the target to build
#
# Prints the table of scripts/bench/compare_reports.py; the reports stay in build/compare/A..B.
set -euo pipefail
cd "$(dirname "$0")/.."
root=$PWD

usage() {
  sed -n '2,/^set /{/^set /d;/SPDX/d;s/^# \{0,1\}//;p}' "$root/scripts/compare_commits.sh" >&2
  exit 1
}
(($# >= 2)) || usage
commits=("$1" "$2")
shift 2
repeat=3 sets=sample-day workspace='' target='' command=()
while (($#)); do
  case $1 in
    --repeat) repeat=$2 ;;
    --sets) sets=$2 ;;
    --workspace) workspace=$(realpath "$2") ;;
    --target) target=$2 ;;
    --) shift; command=("$@"); break ;;
    *) usage ;;
  esac
  shift 2
done
if [[ -n $workspace ]]; then
  target=limn
  command=('{build}/limn' automatic_drawer --workspace_path "$workspace" --output_path '{new}')
fi
[[ -n $target || ${#command[@]} == 0 ]] || usage

# The folder of a commit with its work tree, kept for later comparisons.
tree_of() {
  local tree=$root/build/compare/$1
  [[ -d $tree ]] || git worktree add --detach "$tree" "$1" >&2
  echo "$tree"
}

build() {
  # Built like in scripts/test.sh, so that ccache has most of it.
  (cd "$1" && cmake --preset release -DLIMN_WARNINGS_AS_ERRORS=ON) >"$1/configure.log"
  nice cmake --build "$1/build/release" --target "${target:-stage_report}" >"$1/build.log" || {
    tail -20 "$1/build.log" >&2
    exit 1
  }
}

# One run of a commit: tree, commit, report.
measure() {
  if [[ ${#command[@]} == 0 ]]; then
    local new
    new=$(mktemp -d)
    "$1/build/release/tests/bench/stage_report" --output_path "$new" --sets "$sets" --commit "$2" \
      --data_path "$root/../shared/data" --sample_path "$root/datasets/sample" >"$3.log"
    mv "$new/report.json" "$3"
    rm -r "$new"
  else
    python3 scripts/bench/command_report.py --output "$3" --commit "$2" \
      --name "$(basename "${workspace:-${command[0]}}")" "${command[@]//'{build}'/$1/build/release}"
  fi
}

hashes=() trees=()
for commit in "${commits[@]}"; do
  hashes+=("$(git rev-parse --short=10 --verify "$commit^{commit}")")
  trees+=("$(tree_of "${hashes[-1]}")")
  build "${trees[-1]}"
done
out=build/compare/${hashes[0]}..${hashes[1]}
rm -rf "$out"
mkdir -p "$out"
for ((i = 1; i <= repeat; ++i)); do
  # Alternates the order, so that a machine that warms up or slows down favors neither.
  order=(0 1)
  ((i % 2)) || order=(1 0)
  for side in "${order[@]}"; do
    letter=$([[ $side == 0 ]] && echo a || echo b)
    measure "${trees[$side]}" "${hashes[$side]}" "$out/$letter-$i.json"
  done
done
python3 scripts/bench/compare_reports.py "$out"
