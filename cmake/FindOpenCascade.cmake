# OpenCASCADE (Debian package libocct-data-exchange-dev): target OpenCascade::OpenCascade, what reads
# STEP, IGES and BREP and checks shapes. Its own package wants its windows too.
find_path(OPENCASCADE_INCLUDE_DIR STEPControl_Reader.hxx PATH_SUFFIXES opencascade)
set(OpenCascade_LIBRARIES "")
foreach(name TKSTEP TKSTEPBase TKIGES TKXSBase TKShHealing TKTopAlgo TKBRep TKG3d TKMath TKernel)
  find_library(OPENCASCADE_${name} ${name})
  mark_as_advanced(OPENCASCADE_${name})
  list(APPEND OpenCascade_LIBRARIES ${OPENCASCADE_${name}})
endforeach()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OpenCascade REQUIRED_VARS OPENCASCADE_TKSTEP OPENCASCADE_TKIGES
  OPENCASCADE_TKBRep OPENCASCADE_INCLUDE_DIR)
if(OpenCascade_FOUND AND NOT TARGET OpenCascade::OpenCascade)
  add_library(OpenCascade::OpenCascade INTERFACE IMPORTED)
  set_target_properties(OpenCascade::OpenCascade PROPERTIES
    INTERFACE_LINK_LIBRARIES "${OpenCascade_LIBRARIES}"
    INTERFACE_SYSTEM_INCLUDE_DIRECTORIES ${OPENCASCADE_INCLUDE_DIR}
    INTERFACE_INCLUDE_DIRECTORIES ${OPENCASCADE_INCLUDE_DIR})
endif()
mark_as_advanced(OPENCASCADE_INCLUDE_DIR)
