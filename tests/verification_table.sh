#!/bin/sh
# Prints docs/verification_table.md: what the tests of mechanics found beside what sources outside of
# the code say, from the lines that they left in FOLDER when they ran last. With a file as second
# argument: says where that differs, and fails.
set -eu
folder=$1
table=$(mktemp)
trap 'rm -f "$table"' EXIT
{
  echo '# Verification table'
  echo
  echo 'Written by `make table` from what the tests print. Source, mesh and reason of each tolerance stand'
  echo 'beside it in the test of that name; [verification](verification.md) says what is proved where.'
  echo
  echo '| test | what | Plica | source | difference | allowed |'
  echo '|---|---|---|---|---|---|'
  # By the names of the tests: their order is that in which sources are linked.
  cat "$folder"/*.md | sed 's/-0\.00 %/+0.00 %/' |
    LC_ALL=C sort --stable --field-separator='|' --key=2,2
} >"$table"
if [ $# -gt 1 ]; then diff -u "$2" "$table"; else cat "$table"; fi
