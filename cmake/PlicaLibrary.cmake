# plica_library(<folder> SOURCES ... LINKS ... PRIVATE_LINKS ...)
# One library per folder, target plica::<folder>. The link list is the rule of what it may include.
# -Wno-restrict and the two after it: GCC 12 warns of std::string concatenation without cause (GCC
# bug 105651), more so from precompiled headers.
add_library(plica_options INTERFACE)
target_compile_options(plica_options INTERFACE
  $<BUILD_INTERFACE:-Wall;-Wextra;-Wshadow;-Wconversion;-Wno-sign-conversion;-Wno-restrict;-Wno-stringop-overflow;-Wno-array-bounds>)
# Of sources compiled together GCC says what is none of theirs.
if(CMAKE_UNITY_BUILD)
  target_compile_options(plica_options INTERFACE -Wno-shadow -Wno-subobject-linkage)
endif()
target_compile_features(plica_options INTERFACE cxx_std_20)
if(PLICA_SANITIZE)
  target_compile_options(plica_options INTERFACE -fsanitize=address,undefined -fno-omit-frame-pointer)
  target_link_options(plica_options INTERFACE -fsanitize=address,undefined)
endif()

# What nearly every source includes, read once per library; from solve/ on, which holds them, with
# the decompositions that are compiled once.
set(plica_precompiled <Eigen/Dense> <Eigen/Sparse> <algorithm> <cmath> <functional> <map> <optional>
  <string> <vector>)
set(plica_precompiled_from_solve ${plica_precompiled}
  ${PROJECT_SOURCE_DIR}/solve/decompositions.hpp)

function(plica_library name)
  cmake_parse_arguments(arg "" "" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
  add_library(plica_${name} STATIC ${arg_SOURCES})
  add_library(plica::${name} ALIAS plica_${name})
  set_target_properties(plica_${name} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(plica_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/plica>)
  target_link_libraries(plica_${name} PUBLIC ${arg_LINKS} PRIVATE
    $<BUILD_INTERFACE:plica_options> ${arg_PRIVATE_LINKS})
  target_compile_features(plica_${name} PUBLIC cxx_std_20)
  if(name MATCHES "^(words|mesh|elements|lab|files|matlab|universal|lab_files)$")
    target_precompile_headers(plica_${name} PRIVATE ${plica_precompiled})
  else()
    target_precompile_headers(plica_${name} PRIVATE ${plica_precompiled_from_solve})
  endif()
  set_property(GLOBAL APPEND PROPERTY PLICA_LIBRARIES plica_${name})
endfunction()
