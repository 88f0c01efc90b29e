# Builds the tests of bad input under AddressSanitizer and UndefinedBehaviorSanitizer and runs them;
# the readers of test data are fuzzed for about ten minutes.
set(build ${BINARY}/asan)
set(suites BrokenCase YamlTree ReadCase ReadMeasured ReadBenchmark Schema Results* Csv MeasuredData
  Universal* FuzzCsv* UniversalFuzz* BrokenDeck SurfaceFile)
list(TRANSFORM suites APPEND ".*")
list(JOIN suites ":" filter)
function(step)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE failed OUTPUT_VARIABLE text ERROR_VARIABLE text)
  if(failed)
    message(FATAL_ERROR "${ARGV}\n${text}")
  endif()
endfunction()
step(${CMAKE_COMMAND} -S ${SOURCE} -B ${build} -G Ninja -DCMAKE_BUILD_TYPE=RelWithDebInfo
  -DCMAKE_UNITY_BUILD=ON -DPLICA_SANITIZE=ON)
step(${CMAKE_COMMAND} --build ${build} --target plica_tests)
set(ENV{PLICA_FUZZ_ROUNDS} 4000000)
step(${build}/tests/plica_tests --gtest_filter=${filter})
