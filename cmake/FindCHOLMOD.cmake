# CHOLMOD (SuiteSparse, Debian package libsuitesparse-dev): target CHOLMOD::CHOLMOD
include(${CMAKE_CURRENT_LIST_DIR}/FindPlainLibrary.cmake)
find_plain_library(CHOLMOD cholmod.h cholmod NEEDS suitesparseconfig PATH_SUFFIXES suitesparse)
