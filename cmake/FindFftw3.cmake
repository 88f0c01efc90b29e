# Fourier transforms: target Fftw3::Fftw3 (libfftw3-dev).
find_path(Fftw3_INCLUDE_DIR fftw3.h)
find_library(Fftw3_LIBRARY fftw3)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Fftw3 REQUIRED_VARS Fftw3_LIBRARY Fftw3_INCLUDE_DIR)
if(Fftw3_FOUND AND NOT TARGET Fftw3::Fftw3)
  add_library(Fftw3::Fftw3 UNKNOWN IMPORTED)
  set_target_properties(Fftw3::Fftw3 PROPERTIES IMPORTED_LOCATION ${Fftw3_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${Fftw3_INCLUDE_DIR})
endif()
