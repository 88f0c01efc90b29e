# Builds the tests of bad input under AddressSanitizer and UndefinedBehaviorSanitizer and runs them;
# the readers of test data are fuzzed for about ten minutes.
set(build ${BINARY}/asan)
set(tests test_case_file test_schema test_results_output test_measured_data test_universal_file
  test_universal_quirks test_universal_damage fuzz_csv_table fuzz_universal_file)
function(step)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE failed OUTPUT_VARIABLE text ERROR_VARIABLE text)
  if(failed)
    message(FATAL_ERROR "${ARGV}\n${text}")
  endif()
endfunction()
step(${CMAKE_COMMAND} -S ${SOURCE} -B ${build} -G Ninja -DCMAKE_BUILD_TYPE=RelWithDebInfo
  -DPLICA_SANITIZE=ON)
step(${CMAKE_COMMAND} --build ${build} --target ${tests})
set(ENV{PLICA_FUZZ_ROUNDS} 4000000)
foreach(test ${tests})
  step(${build}/tests/${test})
endforeach()
