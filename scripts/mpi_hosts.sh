#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Demonstrates the main job by MPI on several hosts, on one machine: a host is a network namespace with its own name and
# address and one rank; ranks communicate over TCP through a switch. Draws the sample scene:
#
#   scripts/mpi_hosts.sh [hosts, 2] [options of automatic_drawer]
#
# Prints whether the results are the same bytes as those of one process and the volume of network traffic; exit code 1 if
# they differ. Needs root, iproute2, openmpi-bin and build/release/limn. The hosts are removed at the end; results are in
# build/mpi_hosts.
set -euo pipefail
cd "$(dirname "$0")/.."

hosts=${1:-2}
shift || true
options=("$@")
limn=$PWD/build/release/limn
if [[ ! $hosts =~ ^[0-9]+$ || $EUID != 0 || ! -x $limn ]]; then
  sed -n '2,/^set /{/^set /d;/SPDX/d;s/^# \{0,1\}//;p}' "$0" >&2
  exit 1
fi
out=$PWD/build/mpi_hosts
switch=limn-switch
agent=
names=()
for ((i = 1; i <= hosts; ++i)); do names+=("limn-host$i"); done

remove_hosts() {
  for name in "${names[@]}" $switch; do ip netns del "$name" 2>/dev/null || true; done
  rm -f "$agent"
}

# Host $1 with address $2, joined to the switch by a pair of virtual network cards.
add_host() {
  ip netns add "$1"
  ip -n $switch link add "to-$1" type veth peer name eth0 netns "$1"
  ip -n $switch link set "to-$1" master bridge up
  ip -n "$1" address add "$2/24" dev eth0
  ip -n "$1" link set eth0 up
  ip -n "$1" link set lo up
}

# Instead of ssh: runs a command on a host.
write_agent() {
  agent=$(mktemp)
  cat >"$agent" <<'END'
#!/bin/sh
host=$1
shift
exec ip netns exec "$host" unshare --uts sh -c "hostname $host && $*"
END
  chmod +x "$agent"
}

# mpirun with these arguments on the first host, one rank per host.
run_on_hosts() {
  local arguments
  printf -v arguments '%q ' -n "$hosts" -host "$(IFS=, && echo "${names[*]}")" --mca plm_rsh_agent "$agent" \
    --mca pml ob1 --mca btl tcp,self --mca btl_tcp_if_include eth0 --mca oob_tcp_if_include eth0 "$@"
  OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 "$agent" "${names[0]}" "mpirun $arguments"
}

# Of all hosts together, including headers.
bytes_sent() {
  local sum=0
  for name in "${names[@]}"; do
    sum=$((sum + $(ip netns exec "$name" cat /sys/class/net/eth0/statistics/tx_bytes)))
  done
  echo $sum
}

draw() {
  echo automatic_drawer --workspace_path "$PWD/datasets/sample/day" --output_path "$out/$1" "${options[@]}"
}

ip netns add $switch  # fails if another run is at work
trap remove_hosts EXIT
write_agent
ip -n $switch link add bridge type bridge
ip -n $switch link set bridge up
for ((i = 1; i <= hosts; ++i)); do add_host "${names[i - 1]}" "10.77.0.$i"; done
rm -rf "$out"

idle=$(bytes_sent)
run_on_hosts sh -c 'echo "rank $OMPI_COMM_WORLD_RANK on $(hostname), $(hostname -I)"'
started=$(bytes_sent)
# shellcheck disable=SC2046
run_on_hosts "$limn" $(draw hosts)
drawn=$(bytes_sent)
# shellcheck disable=SC2046
"$limn" $(draw one) >/dev/null

echo
echo "Bytes sent by $hosts hosts: $((drawn - started)) by the drawing, $((started - idle)) by mpirun for a command that does nothing"
# The page has times, the options a path.
if diff -r --exclude=drawing.html --exclude=project.ini "$out/hosts" "$out/one"; then
  echo "The results are the bytes of one process: $(find "$out/hosts" -type f | wc -l) files"
else
  echo "ERROR: the results differ from those of one process" >&2
  exit 1
fi
