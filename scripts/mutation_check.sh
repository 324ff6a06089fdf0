#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Do the tests detect a broken stage? Applies the mutations of scripts/mutations.txt one by one to a copy of
# the tree in build/mutations, builds and runs the test that should fail:
#   scripts/mutation_check.sh [--list] [--sample N] [--minutes M] [names ...]
# Exit code 1 if a mutation survives, 2 if the table no longer fits the code. See --help for more.
exec python3 "$(dirname "$0")/mutation_check.py" "$@"
