#!/bin/sh
# A pattern for `ctest -R`: the suites of C++ that cost least in the runs of the tests so far, so many
# that they took SECONDS together; all of them where nothing has run.   cheap_suites.sh BUILD SECONDS
set -eu
costs=$1/Testing/Temporary/CTestCostData.txt
[ -f "$costs" ] || { echo .; exit; }
sed '/^---/q' "$costs" | grep -v -e '^---' -e 'Slow ' | grep -E '^([A-Z][A-Za-z0-9]*)(/[A-Za-z0-9]+)? ' |
  sort -k 3 -g | awk -v most="$2" '
  { spent += $3 }
  spent <= most { all = all (all == "" ? "" : "|") $1 }
  END { print "^(" all ")$" }'
