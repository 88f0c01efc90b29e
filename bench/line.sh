#!/bin/sh
# An exhaust line of fifty superelements with 10 M unknowns behind them: modes below 500 Hz with proof, responses of 20 sensors.
#   bench/line.sh [PARTS] [AROUND]
set -eu
cd "$(dirname "$0")/.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
node bench/line_case.mjs "$work/line.yaml" "${1:-50}" "${2:-400}"
begin=$(date +%s.%N)
build/app/plica run "$work/line.yaml" --threads 2 --quiet --only json --out "$work/out"
end=$(date +%s.%N)
node -e '
  const r = JSON.parse(require("fs").readFileSync(process.argv[1]));
  const n = r.reduction.superelements.length, channels = r.sensors.length;
  console.log(`line of ${n} superelements, ${r.model.dofs} unknowns: ${r.modes.length} modes, ${channels} sensors: `
    + `${Number(process.argv[2]).toFixed(1)} s, ${(r.peak_memory / 1e9).toFixed(2)} GB`
    + `, proved ${r.verification.passed}`);
  console.log("  " + Object.entries(r.timing).sort((a, b) => b[1] - a[1]).slice(0, 7)
    .map(([stage, s]) => `${stage} ${s.toFixed(1)}`).join(", ") + " s");
' "$work/out/results.json" "$(awk -v a="$begin" -v b="$end" 'BEGIN {print b - a}')"
