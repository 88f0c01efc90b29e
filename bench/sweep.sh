#!/bin/sh
# Variants of the dual pipe assembly that change masses and mounts, on two cores: how long they take, how much they leave.
#   bench/sweep.sh [VARIANTS]
set -eu
cd "$(dirname "$0")/.."
count=${1:-10000}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
a=$(date +%s.%N)
build/app/plica sweep cases/dual_assembly --out "$work/s" --design sobol --count "$count" --jobs 2 --quiet \
  --set analyses.modes.count=12 \
  --vary caps.clamp_1.mass,caps.clamp_4.mass=0.2kg:0.7kg \
  --vary caps.clamp_2.mass,caps.clamp_3.mass=0.2kg:0.7kg \
  --vary caps.edge_left.mass=0.1kg:0.5kg
b=$(date +%s.%N)
times >"$work/times"
awk -v a="$a" -v b="$b" -v n="$count" -v bytes="$(du -sb "$work/s" | cut -f1)" 'END {
  split($1, u, /[ms]/); split($2, s, /[ms]/); cpu = 60 * (u[1] + s[1]) + u[2] + s[2]
  printf "%d variants of a superelement assembly, two jobs: %.1f s, %.1f s of a processor, %.1f ms of one a variant, %.0f bytes a variant\n",
         n, b - a, cpu, 1e3 * cpu / n, bytes / n}' "$work/times"
