#!/bin/sh
# The readers of test data and of cases meet damaged input under AddressSanitizer and UBSan for about
# ten minutes, in the build of the preset `sanitize`.   fuzz_under_sanitizers.sh SOURCE
set -eu
cd "$1"
cmake --preset sanitize >/dev/null
cmake --build --preset sanitize --target plica_tests >/dev/null
PLICA_FUZZ_ROUNDS=4000000 build-sanitize/tests/plica_tests \
  --gtest_filter='BrokenCase*:Csv*:MeasuredData*:Universal*:FuzzCsv*:UniversalFuzz*:DeckFuzz*:BrokenDeck*:SurfaceFile*'
