#!/bin/sh
# From nothing to the first plot: a virtual environment, the package installed without a network, one
# line of Python. Fails where that takes more than 60 s of a processor.   python_install.sh PLICA WORK
set -eu
export PLICA="$1"
work=$2
source=$(cd "$(dirname "$0")/../python" && pwd)
rm -rf "$work"
mkdir -p "$work"
cp -r "$source" "$work/python" # pip builds beside the sources
cd "$work"
"$PLICA" run python/tests/cases/bellows.yaml --out out --quiet
begun=$(date +%s)
${PYTHON:-/usr/bin/python3} -m venv --system-site-packages v
v/bin/pip install --quiet --no-build-isolation --no-index ./python
MPLBACKEND=agg v/bin/python -c 'import plica; plica.results("out").plot().figure.savefig("first.png")'
seconds=$(($(date +%s) - begun))
times >times.txt # the last line: user and system of what was run here
processor=$(awk 'END { split($1, u, /[ms]/); split($2, s, /[ms]/);
  printf "%d", 60 * (u[1] + s[1]) + u[2] + s[2] + 0.5 }' times.txt)
test -s first.png
v/bin/python -c 'import plica; print(plica.__file__, plica.options("run")["out"].default)' |
  grep -q "$(pwd -P)/v/.*out"
echo "from nothing to the first plot: $seconds s, $processor s of a processor"
test "$processor" -le 60
