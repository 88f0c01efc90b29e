# Fourier transforms (libfftw3-dev).
include(${CMAKE_CURRENT_LIST_DIR}/FindPlainLibrary.cmake)
find_plain_library(Fftw3 fftw3.h fftw3)
