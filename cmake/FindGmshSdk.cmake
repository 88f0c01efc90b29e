# Gmsh SDK (Debian package libgmsh-dev): target Gmsh::Gmsh
include(${CMAKE_CURRENT_LIST_DIR}/FindPlainLibrary.cmake)
find_plain_library(GmshSdk gmsh.h gmsh TARGET Gmsh::Gmsh PREFIX GMSH)
