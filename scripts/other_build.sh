# SPDX-License-Identifier: BSD-3-Clause
# Sourced by scripts that build in a way of their own: $build is the folder, $targets a file in it with the paths of targets.

# choose_targets <extended regular expression of paths>
choose_targets() {
  ninja -C "$build" -t targets all | sed 's/: .*//' | grep -E "$1" >"$targets" || { echo "ERROR: no target is $1" >&2; exit 1; }
}

build_targets() {
  xargs -a "$targets" ninja -C "$build" -k 0
}

# run_tests: those whose programs are the targets.
run_tests() {
  ctest --test-dir "$build" -j2 --output-on-failure -R "^($(sed 's,.*/,,' "$targets" | paste -sd'|'))\$"
}
