#!/bin/sh
# Every C++ source is laid out as .clang-format says.
set -eu
cd "$1"
find mesh elements solve reduction model diagnose io app tests bench -name '*.hpp' -o -name '*.cpp' |
  xargs clang-format --dry-run --Werror
