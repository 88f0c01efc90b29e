# Makes specimens, has them diagnosed where the truth does not exist, and scores the verdicts.
#   cmake -DSEALED=plica_sealed -DPLICA=plica -DWORK=folder -DCASES=smoke|all -DSEED=1 -DDIAGNOSE=ON -P
# With DIAGNOSE off it only makes them.
function(step)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE failed)
  if(failed)
    message(FATAL_ERROR "failed: ${ARGV}")
  endif()
endfunction()

file(REMOVE_RECURSE ${WORK})
step(${SEALED} make --data ${WORK}/data --truth ${WORK}/truth --seed ${SEED} --cases ${CASES})
file(GLOB data ${WORK}/data/*/measured.yaml)
file(GLOB truth ${WORK}/truth/*.json)
list(LENGTH data made)
list(LENGTH truth known)
if(made EQUAL 0 OR NOT made EQUAL known)
  message(FATAL_ERROR "${made} specimens for ${known} truths")
endif()
if(NOT DIAGNOSE)
  return()
endif()

# The truth leaves the file system for the time of the run: an archive outside of the work folder.
execute_process(COMMAND ${CMAKE_COMMAND} -E tar cf ${WORK}.truth.tar truth WORKING_DIRECTORY ${WORK}
  COMMAND_ERROR_IS_FATAL ANY)
file(SHA256 ${WORK}.truth.tar published)
message(STATUS "truth sealed, SHA-256 ${published}")
file(REMOVE_RECURSE ${WORK}/truth)
step(${SEALED} run --data ${WORK}/data --plica ${PLICA} --out ${WORK}/out)
file(SHA256 ${WORK}.truth.tar kept)
if(NOT kept STREQUAL published)
  message(FATAL_ERROR "the truth changed while it was sealed")
endif()
file(ARCHIVE_EXTRACT INPUT ${WORK}.truth.tar DESTINATION ${WORK})
step(${SEALED} score --data ${WORK}/data --truth ${WORK}/truth --out ${WORK}/out --require)
