# Cells of CSV files (libcsv-dev).
include(${CMAKE_CURRENT_LIST_DIR}/FindPlainLibrary.cmake)
find_plain_library(Libcsv csv.h csv)
