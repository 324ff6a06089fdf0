#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The main job on a Slurm cluster as a job array. Needs only a shared file system; if a node dies, the last job makes
# its shard.
#
#   scripts/slurm/shards.sh WORKSPACE SHARDS [options of automatic_drawer]
#
# The jobs run `limn` from the PATH, or $LIMN.
set -euo pipefail
(($# >= 2)) || { sed -n '2,/^set /{/^set /d;/SPDX/d;s/^# \{0,1\}//;p}' "$0" >&2; exit 1; }
workspace=$(realpath "$1") shards=$2
shift 2
limn=${LIMN:-limn}

printf -v line '%q ' "$limn" automatic_drawer --workspace_path "$workspace" "$@"
printf -v shard '%s ' --shard "\$SLURM_ARRAY_TASK_ID/$shards" --shard_stage

# Submit job $1 with the command line $2 and more options of sbatch.
submit() {
  local name=$1 command=$2
  shift 2
  sbatch --parsable --job-name="limn-$name" --cpus-per-task="${CPUS:-4}" --mem="${MEM:-8G}" "$@" --wrap="$command"
}

curves=$(submit curves "$line$shard curves" --array="1-$shards")
sketches=$(submit sketches "$line$shard sketches" --array="1-$shards" --dependency="afterany:$curves")
drawing=$(submit drawing "$line" --dependency="afterany:$sketches")
echo "jobs: image curves $curves, sketches $sketches, drawing $drawing"
