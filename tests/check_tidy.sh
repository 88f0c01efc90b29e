#!/bin/sh
# clang-tidy finds nothing in the libraries and the program.
set -eu
cd "$1"
# Each source by itself, and without the precompiled headers of GCC, which it cannot read.
commands=$(mktemp -d)
trap 'rm -rf "$commands"' EXIT
cmake --preset release -B "$commands" -DCMAKE_UNITY_BUILD=OFF \
  -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON >"$commands/log"
find mesh elements solve reduction model diagnose io app -name '*.cpp' |
  xargs -P 2 -n 4 clang-tidy -p "$commands" --quiet
