# Installs the program, the libraries with their headers, the cases, and a CMake package:
#   find_package(plica) ... target_link_libraries(mine plica::solve)
include(CMakePackageConfigHelpers)

get_property(plica_libraries GLOBAL PROPERTY PLICA_LIBRARIES)
set(plica_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/plica)

install(TARGETS plica RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS ${plica_libraries} EXPORT plica-targets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}/plica)
foreach(folder mesh elements solve reduction model diagnose io)
  install(DIRECTORY ${folder} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/plica
    FILES_MATCHING PATTERN "*.hpp")
endforeach()
install(DIRECTORY cases DESTINATION ${CMAKE_INSTALL_DATADIR}/plica)
install(FILES README.md LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

install(EXPORT plica-targets NAMESPACE plica:: DESTINATION ${plica_package_dir})
configure_package_config_file(cmake/plica-config.cmake.in
  ${PROJECT_BINARY_DIR}/plica-config.cmake INSTALL_DESTINATION ${plica_package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/plica-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/plica-config.cmake
  ${PROJECT_BINARY_DIR}/plica-config-version.cmake
  cmake/FindCHOLMOD.cmake cmake/FindFftw3.cmake cmake/FindGmshSdk.cmake cmake/FindLibcsv.cmake cmake/FindMatio.cmake cmake/FindPlainLibrary.cmake
  cmake/FindUMFPACK.cmake DESTINATION ${plica_package_dir})
