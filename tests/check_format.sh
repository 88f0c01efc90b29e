#!/bin/sh
# Every C++ source is laid out as .clang-format says.
set -eu
cd "$1"
find . -path './build*' -prune -o \( -name '*.hpp' -o -name '*.cpp' \) -print |
  xargs clang-format --dry-run --Werror
