#!/bin/sh
# clang-tidy finds nothing in the libraries and the program.
set -eu
cd "$1"
# It cannot read the precompiled headers of GCC: the commands without them.
commands=$(mktemp -d)
trap 'rm -rf "$commands"' EXIT
sed 's/-Winvalid-pch -include [^ ]*cmake_pch.hxx//' "$2/compile_commands.json" \
  >"$commands/compile_commands.json"
find mesh elements solve reduction model diagnose io app -name '*.cpp' |
  xargs -P 2 -n 4 clang-tidy -p "$commands" --quiet
