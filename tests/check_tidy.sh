#!/bin/sh
# clang-tidy finds nothing in the libraries and the programs, with the warnings of the compiler as
# errors. check_tidy.sh SOURCE: of the sources as the preset `tidy` takes them together, since most of
# its time goes into the headers.
set -eu
cd "$1"
cmake --preset tidy >/dev/null
cmake --build --preset tidy >/dev/null
rooms=$(cut -d ' ' -f 1 build-tidy/rooms.txt | cut -d / -f 1 | sort -u | tr '\n' '|')app
sed -n 's/^  "file": "\(.*\)",*$/\1/p' build-tidy/compile_commands.json |
  grep -v -e '/tests/' -e 'cmake_pch' | sort |
  xargs -P "$(nproc)" -n 2 clang-tidy -p build-tidy --quiet --header-filter="/($rooms|mesher)/.*\.[ch]pp$"
