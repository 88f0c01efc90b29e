# Builds the tests of bad input under AddressSanitizer and UndefinedBehaviorSanitizer and runs them.
set(build ${BINARY}/asan)
function(step)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE failed OUTPUT_VARIABLE text ERROR_VARIABLE text)
  if(failed)
    message(FATAL_ERROR "${ARGV}\n${text}")
  endif()
endfunction()
step(${CMAKE_COMMAND} -S ${SOURCE} -B ${build} -G Ninja -DCMAKE_BUILD_TYPE=RelWithDebInfo
  -DPLICA_SANITIZE=ON)
step(${CMAKE_COMMAND} --build ${build} --target test_case_file test_schema test_results_output test_universal_file test_universal_quirks
  test_universal_damage fuzz_universal_file)
foreach(test test_case_file test_schema test_results_output test_universal_file test_universal_quirks
  test_universal_damage fuzz_universal_file)
  step(${build}/tests/${test})
endforeach()
