# Writes OUT: a test of ctest for every suite of PROGRAM. One process a suite, since a process takes
# longer to start than most tests to run. Suites whose name ends in Slow carry the label slow,
# the others the label suite.
cmake_minimum_required(VERSION 3.25)
execute_process(COMMAND ${PROGRAM} --gtest_list_tests OUTPUT_VARIABLE listed
  COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "(^|\n)[^ \n][^\n]*\\.[^\n]*" suites "${listed}")
set(text "")
foreach(suite IN LISTS suites)
  string(REGEX REPLACE "^\n?([^ ]*)\\..*" "\\1" name "${suite}")
  if(name MATCHES "Slow$")
    set(properties "LABELS slow TIMEOUT 3600")
  else()
    set(properties "LABELS suite TIMEOUT 600")
  endif()
  string(APPEND text "add_test([=[${name}]=] \"${PROGRAM}\" [=[--gtest_filter=${name}.*]=])\n"
    "set_tests_properties([=[${name}]=] PROPERTIES ${properties} ENVIRONMENT [=[PLICA_TABLE=${TABLE}]=])\n")
endforeach()
file(WRITE ${OUT} "${text}")
