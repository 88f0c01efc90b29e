#!/bin/sh
# Kernels, cost against size, and Plica beside CalculiX on one mesh in one run.
set -eu
cd "$(dirname "$0")/.."
build/bench/bench_kernels --benchmark_min_time=0.2
build/bench/bench_friction
build/bench/bench_rainflow
build/bench/bench_line
build/bench/bench_solve "${LARGEST:-1e6}"
bench/sweep.sh 10000
node bench/memory.mjs build/app/plica

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
build/bench/calculix_deck bench/a2_peer.yaml "$work/a2.inp"
seconds() { date +%s.%N; }
a=$(seconds)
build/app/plica run bench/a2_peer.yaml --threads 2 --quiet --out "$work/plica"
b=$(seconds)
(cd "$work" && OMP_NUM_THREADS=2 ccx -i a2 >a2.log 2>&1)
c=$(seconds)
echo "20,928 quads, 10 modes, 2 threads:"
awk -v a="$a" -v b="$b" -v c="$c" 'BEGIN {
  printf "  Plica with statics and proof %6.1f s\n  CalculiX without proof       %6.1f s\n  ratio %.1f\n",
         b - a, c - b, (c - b) / (b - a)}'
echo "  CalculiX frequencies, Hz:"
awk '/E I G E N V A L U E   O U T P U T/ {found=1} found && $1 ~ /^[0-9]+$/ && NF >= 4 {printf "    %s", $4; if (++n == 10) exit} END {print ""}' "$work/a2.dat"
echo "  Plica frequencies, Hz:"
awk -F, 'NR > 1 {printf "    %s", $2} END {print ""}' "$work/plica/modes.csv"
