#!/bin/sh
# clang-tidy finds nothing in the libraries and the program.
set -eu
cd "$1"
# Each source by itself, and without the precompiled headers of GCC, which it cannot read.
cmake --preset dev >/dev/null
cut -d ' ' -f 1 build/rooms.txt | cut -d / -f 1 | sort -u |
  xargs -I {} find {} app mesher -name '*.cpp' | sort -u |
  xargs -P "$(nproc)" -n 4 clang-tidy -p build-dev --quiet
