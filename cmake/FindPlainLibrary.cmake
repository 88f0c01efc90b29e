# find_plain_library(<Name> <header> <library> [TARGET <target>] [PREFIX <prefix>] [NEEDS <library>...]
#                    [PATH_SUFFIXES <folder of the header>...])
# Target <Name>::<Name>, or <target>, for a C library of Debian that brings no CMake package. Where it
# lies: <prefix>_INCLUDE_DIR and <prefix>_LIBRARY, of what it needs to be linked with
# <LIBRARY>_LIBRARY; <prefix> is <Name> where it is left out.
include(FindPackageHandleStandardArgs)
macro(find_plain_library name header library)
  cmake_parse_arguments(plain "" "TARGET;PREFIX" "NEEDS;PATH_SUFFIXES" TARGET ${name}::${name}
    PREFIX ${name} ${ARGN})
  find_path(${plain_PREFIX}_INCLUDE_DIR ${header} PATH_SUFFIXES ${plain_PATH_SUFFIXES})
  find_library(${plain_PREFIX}_LIBRARY ${library})
  set(plain_variables ${plain_PREFIX}_LIBRARY ${plain_PREFIX}_INCLUDE_DIR)
  set(plain_links "")
  foreach(plain_needed ${plain_NEEDS})
    string(TOUPPER ${plain_needed}_LIBRARY plain_variable)
    find_library(${plain_variable} ${plain_needed})
    list(APPEND plain_variables ${plain_variable})
    list(APPEND plain_links ${${plain_variable}})
  endforeach()
  find_package_handle_standard_args(${name} REQUIRED_VARS ${plain_variables})
  if(${name}_FOUND AND NOT TARGET ${plain_TARGET})
    add_library(${plain_TARGET} UNKNOWN IMPORTED)
    set_target_properties(${plain_TARGET} PROPERTIES
      IMPORTED_LOCATION ${${plain_PREFIX}_LIBRARY}
      INTERFACE_INCLUDE_DIRECTORIES ${${plain_PREFIX}_INCLUDE_DIR}
      INTERFACE_LINK_LIBRARIES "${plain_links}")
  endif()
  mark_as_advanced(${plain_variables})
endmacro()
