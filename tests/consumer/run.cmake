# Installs the build tree BUILD into a scratch folder and builds and runs a consumer against it.
set(stage ${BUILD}/consumer-stage)
file(REMOVE_RECURSE ${stage} ${BUILD}/consumer-build)
function(step)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE failed OUTPUT_VARIABLE text ERROR_VARIABLE text)
  if(failed)
    message(FATAL_ERROR "${ARGV}\n${text}")
  endif()
endfunction()
step(${CMAKE_COMMAND} --install ${BUILD} --prefix ${stage})
step(${CMAKE_COMMAND} -S ${SOURCE}/tests/consumer -B ${BUILD}/consumer-build -G Ninja
  -DCMAKE_PREFIX_PATH=${stage} -DCMAKE_BUILD_TYPE=Release)
step(${CMAKE_COMMAND} --build ${BUILD}/consumer-build)
step(${BUILD}/consumer-build/consumer)
# The installed program finds its mesher.
step(${stage}/bin/plica check ${SOURCE}/cases/pipe_with_bracket)
