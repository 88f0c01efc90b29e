# UMFPACK (SuiteSparse, Debian package libsuitesparse-dev): target UMFPACK::UMFPACK
include(${CMAKE_CURRENT_LIST_DIR}/FindPlainLibrary.cmake)
find_plain_library(UMFPACK umfpack.h umfpack PATH_SUFFIXES suitesparse)
