# Installs the build tree BUILD into a scratch folder and builds and runs consumers against it: of each
# component, with the packages that neither it nor what it links names made unfindable.
set(stage ${BUILD}/consumer-stage)
file(REMOVE_RECURSE ${stage} ${BUILD}/consumer-build)
function(step)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE failed OUTPUT_VARIABLE text ERROR_VARIABLE text)
  if(failed)
    message(FATAL_ERROR "${ARGV}\n${text}")
  endif()
endfunction()
# Each in a build folder of its own, as many side by side as there are cores; what one says is told if
# it fails.
set(consumers ${BUILD}/consumer-build/build.ninja)
file(WRITE ${consumers} "rule consume
  command = ( ${CMAKE_COMMAND} -S ${SOURCE}/tests/consumer -B $out -G Ninja -DCOMPONENTS=$out $
    -DCMAKE_PREFIX_PATH=${stage} -DCMAKE_BUILD_TYPE=Release $without && $
    ${CMAKE_COMMAND} --build $out -j 1 && ${CMAKE_COMMAND} -E chdir $out ./consumer_$out $
    ) > $out.log 2>&1 || { cat $out.log; false; }
  description = $out\n")
function(consume component)
  list(TRANSFORM ARGN REPLACE "(.+)" "-DCMAKE_DISABLE_FIND_PACKAGE_\\1=ON")
  list(JOIN ARGN " " without)
  file(APPEND ${consumers} "build ${component}: consume\n  without = ${without}\n")
endfunction()

# The components from the bottom to the top, what they link and the packages they name.
file(STRINGS ${BUILD}/plica-config.cmake said REGEX "^set\\(plica_(known|links_of|packages_of)")
foreach(line IN LISTS said)
  cmake_language(EVAL CODE "${line}")
endforeach()
set(lacking ${plica_known})
set(all_packages "")
foreach(component ${plica_known})
  if(EXISTS ${SOURCE}/tests/consumer/${component}.cpp)
    list(REMOVE_ITEM lacking ${component})
  endif()
  set(named_by_${component} ${plica_packages_of_${component}})
  list(TRANSFORM named_by_${component} REPLACE " .*" "")
  foreach(linked ${plica_links_of_${component}})
    list(APPEND named_by_${component} ${named_by_${linked}})
  endforeach()
  list(APPEND all_packages ${named_by_${component}})
endforeach()
list(REMOVE_DUPLICATES all_packages)
if(lacking)
  message(FATAL_ERROR "Components without a consumer: ${lacking}; write tests/consumer/<component>.cpp")
endif()

# What the users of these are spared, whatever they come to link.
set(files VTK HDF5 Matio Libcsv yaml-cpp)
set(searches Ceres Pagmo)
set(spared_by_solve ${files} ${searches} GmshSdk assimp Fftw3 nlohmann_json fmt)
set(spared_by_lab ${files} ${searches} GmshSdk assimp CHOLMOD Spectra nlohmann_json)
set(spared_by_reduction ${spared_by_solve})
set(spared_by_run ${files} ${searches} nlohmann_json)
set(spared_by_compare ${files} nlohmann_json)
set(spared_by_diagnose ${spared_by_compare})

step(${CMAKE_COMMAND} --install ${BUILD} --prefix ${stage})
foreach(component ${plica_known})
  set(unnamed ${all_packages})
  list(REMOVE_ITEM unnamed ${named_by_${component}})
  consume(${component} ${unnamed} ${spared_by_${component}})
endforeach()
find_program(NINJA ninja REQUIRED)
cmake_host_system_information(RESULT cores QUERY NUMBER_OF_LOGICAL_CORES)
step(${NINJA} -C ${BUILD}/consumer-build -j ${cores})
# The installed program finds its mesher.
step(${stage}/bin/plica check ${SOURCE}/cases/pipe_with_bracket)
