# plica_library(<name> [RUNS] [BASIC] [OWN_HEADERS] SOURCES ... LINKS ... PRIVATE_LINKS ... PACKAGES ...)
# One library per room, target plica::<name>, the component <name> of the installed package. The link
# list is the rule of what it may include; PACKAGES are what a user of the component must find, as
# find_dependency() takes them. RUNS: tests under sanitizers wait for it. BASIC: it stands below solve/.
# OWN_HEADERS: it is compiled by other options than the rooms beside it.
add_library(plica_options INTERFACE)
target_compile_options(plica_options INTERFACE
  $<BUILD_INTERFACE:-Wall;-Wextra;-Wshadow;-Wconversion;-Wno-sign-conversion>)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC 12 warns of std::string concatenation without cause (GCC bug 105651), more so from precompiled
  # headers.
  target_compile_options(plica_options INTERFACE
    $<BUILD_INTERFACE:-Wno-restrict;-Wno-stringop-overflow;-Wno-array-bounds>)
  # Its garbage is collected from 2 GB on: a twentieth of the time.
  target_compile_options(plica_options INTERFACE
    $<BUILD_INTERFACE:--param=ggc-min-heapsize=2000000>)
endif()
if(CMAKE_UNITY_BUILD)
  # What one source names, another that is compiled with it may name too; locals are nobody else's.
  target_compile_options(plica_options INTERFACE
    $<IF:$<CXX_COMPILER_ID:GNU>,-Wno-shadow;-Wshadow=local;-Wno-subobject-linkage,-Wno-shadow>)
endif()
if(PLICA_WERROR)
  target_compile_options(plica_options INTERFACE -Werror)
endif()
target_compile_features(plica_options INTERFACE cxx_std_20)
if(PLICA_SANITIZE)
  # Little is optimised, and only what is run, no lines are noted, and pointers are left to
  # AddressSanitizer: the build takes half the time.
  target_compile_options(plica_options INTERFACE -fsanitize=address,undefined
    -fno-sanitize=null,alignment,vptr,object-size -fno-sanitize-recover=undefined
    -fno-omit-frame-pointer $<IF:$<BOOL:$<TARGET_PROPERTY:PLICA_RUNS>>,-O1,-O0>
    $<$<CXX_COMPILER_ID:Clang>:-fsanitize-ignorelist=${PROJECT_SOURCE_DIR}/cmake/not_sanitized.txt>)
  target_link_options(plica_options INTERFACE -fsanitize=address,undefined)
endif()

# What nearly every source includes, read once for the rooms below solve/ and once for those above,
# with the decompositions that solve/ compiles.
set(plica_precompiled <Eigen/Dense> <Eigen/Sparse> <algorithm> <cmath> <functional> <map> <optional>
  <string> <vector>)
set(plica_precompiled_from_solve ${plica_precompiled}
  ${PROJECT_SOURCE_DIR}/solve/decompositions.hpp)

# From the room that has them for those like it; under sanitizers one that is optimised has none for
# one that is not.
function(plica_precompile name runs is_basic has_own)
  if(is_basic)
    set(headers ${plica_precompiled})
    set(first elements)
    set(first_of_idle words)
  else()
    set(headers ${plica_precompiled_from_solve})
    set(first solve)
    set(first_of_idle description)
  endif()
  if(PLICA_SANITIZE AND NOT runs)
    set(first ${first_of_idle})
  endif()
  if(has_own OR name STREQUAL first)
    target_precompile_headers(plica_${name} PRIVATE ${headers})
  else()
    target_precompile_headers(plica_${name} REUSE_FROM plica_${first})
  endif()
endfunction()

# The rooms, what each links and where it lies, for the rule of includes: build/rooms.txt.
set_property(GLOBAL PROPERTY PLICA_ROOMS "")

function(plica_library name)
  cmake_parse_arguments(arg "RUNS;BASIC;OWN_HEADERS" "" "SOURCES;LINKS;PRIVATE_LINKS;PACKAGES" ${ARGN})
  add_library(plica_${name} STATIC ${arg_SOURCES})
  add_library(plica::${name} ALIAS plica_${name})
  set_target_properties(plica_${name} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(plica_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_link_libraries(plica_${name} PUBLIC ${arg_LINKS} PRIVATE
    $<BUILD_INTERFACE:plica_options> ${arg_PRIVATE_LINKS})
  target_compile_features(plica_${name} PUBLIC cxx_std_20)
  set_target_properties(plica_${name} PROPERTIES PLICA_RUNS ${arg_RUNS})
  plica_precompile(${name} "${arg_RUNS}" "${arg_BASIC}" "${arg_OWN_HEADERS}")
  set_property(GLOBAL APPEND PROPERTY PLICA_LIBRARIES ${name})
  set_property(TARGET plica_${name} PROPERTY PLICA_LINKS ${arg_LINKS})
  set_property(TARGET plica_${name} PROPERTY PLICA_PACKAGES ${arg_PACKAGES})
  file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR})
  string(JOIN " " links ${arg_LINKS})
  set_property(GLOBAL APPEND_STRING PROPERTY PLICA_ROOMS "${folder} plica::${name} ${links}\n")
endfunction()
