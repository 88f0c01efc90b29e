# MATLAB files (libmatio-dev).
include(${CMAKE_CURRENT_LIST_DIR}/FindPlainLibrary.cmake)
find_plain_library(Matio matio.h matio)
