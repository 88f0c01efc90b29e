#!/bin/sh
# Kernels, cost against size, many modes, sweeps, memory, a line of superelements, and Plica beside its peers on one mesh, in one run; or parts of it.
#   bench/run.sh [kernels] [size] [sweep] [memory] [many] [line] [peer]
# LARGEST is the size, in unknowns, that `size` goes up to (1e6). MYSTRAN names an executable to stand beside CalculiX.
set -eu
cd "$(dirname "$0")/.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# timed COMMAND...: its seconds by the clock in $seconds; what it prints is not shown.
timed() {
  begin=$(date +%s.%N)
  "$@" >"$work/log" 2>&1 || { cat "$work/log"; return 1; }
  seconds=$(awk -v a="$begin" -v b="$(date +%s.%N)" 'BEGIN {printf "%.1f", b - a}')
}

kernels() {
  build/bench/bench_kernels --benchmark_min_time=0.2
  build/bench/bench_friction
  build/bench/bench_rainflow
  build/bench/bench_line
}

size() { build/bench/bench_solve "${LARGEST:-1e6}"; }

sweep() { bench/sweep.sh 10000; }

memory() { node bench/memory.mjs build/app/plica; }

many() {
  timed build/app/plica run bench/a2_peer.yaml --threads 2 --quiet --only json --no-variants --out "$work/many" \
    --set analyses.modes.count=1000 --set 'parts.bellows.mesh={around: 72, arc: 3, wall: 6}'
  node -e 'const r = JSON.parse(require("fs").readFileSync(process.argv[1]));
    console.log(`${r.modes.length} modes of ${r.model.dofs} unknowns with proof: ${process.argv[2]} s, ${(r.peak_memory / 1e9).toFixed(1)} GB`)' \
    "$work/many/results.json" "$seconds"
}

line() { bench/line.sh; }

calculix() { (cd "$work" && OMP_NUM_THREADS=2 ccx -i a2); }

mystran() {
  build/app/plica run bench/a2_peer.yaml --write-deck nastran --quiet --out "$work/nastran"
  timed "$MYSTRAN" "$work/nastran/model.bdf"
}

# peer_line NAME: its $seconds, and how many times those of Plica they are.
peer_line() {
  awk -v name="$1" -v s="$seconds" -v p="$plica_seconds" \
    'BEGIN {printf "  %-28s %6.1f s, ratio %.1f\n", name, s, s / p}'
}

peer() {
  build/bench/calculix_deck bench/a2_peer.yaml "$work/a2.inp"
  timed build/app/plica run bench/a2_peer.yaml --threads 2 --quiet --out "$work/plica"
  plica_seconds=$seconds
  echo "20,928 quads, 10 modes, 2 threads:"
  peer_line "Plica with statics and proof"
  timed calculix
  peer_line "CalculiX without proof"
  if [ -n "${MYSTRAN:-}" ]; then
    mystran
    peer_line MYSTRAN
  fi
  echo "  CalculiX frequencies, Hz:"
  awk '/E I G E N V A L U E   O U T P U T/ {found=1} found && $1 ~ /^[0-9]+$/ && NF >= 4 {printf "    %s", $4; if (++n == 10) exit} END {print ""}' "$work/a2.dat"
  echo "  Plica frequencies, Hz:"
  awk -F, 'NR > 1 {printf "    %s", $2} END {print ""}' "$work/plica/modes.csv"
}

[ $# -gt 0 ] || set -- kernels size sweep memory many line peer
for part in "$@"; do
  case $part in
    kernels | size | sweep | memory | many | line | peer) "$part" ;;
    *) echo "bench/run.sh: no part is called $part: kernels, size, sweep, memory, many, line, peer" >&2; exit 2 ;;
  esac
done
