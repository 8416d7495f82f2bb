#!/bin/sh
# bench/peers/step_vs_lammps.sh [OPTION...]: installs Debian's LAMMPS, then measures one time step of ours
# against one of LAMMPS': same settled packing of 10,000 grains, the nearest law it has, slow shear, two MPI ranks against
# two threads, seven pairs of windows in turn. What is the same and what is not: bench/peers/lammps_peer.py.
# Options go to step.py: --at-least RATIO, --pairs N, --packing FILE.csv.gz, --program FILE, ...
set -eu
root=$(cd "$(dirname "$(readlink -f "$0")")/../.." && pwd)
# shellcheck source=bench/peers/common.sh
. "$root/bench/peers/common.sh"
ready lammps openmpi-bin
compare step lammps "$@"
