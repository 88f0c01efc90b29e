# Installs the program with its manual, completions and cases (component `program`, also a Debian
# package by `cpack`), and the libraries with their headers and a CMake package (`development`):
#   find_package(plica) ... target_link_libraries(mine plica::solve)
include(CMakePackageConfigHelpers)

get_property(plica_libraries GLOBAL PROPERTY PLICA_LIBRARIES)
set(plica_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/plica)

# Debian wants manual and changelog packed, without a time in them.
add_custom_command(OUTPUT ${PROJECT_BINARY_DIR}/plica.1.gz ${PROJECT_BINARY_DIR}/plica.bash
  COMMAND plica manual > ${PROJECT_BINARY_DIR}/plica.1
  COMMAND gzip -9nkf ${PROJECT_BINARY_DIR}/plica.1
  COMMAND plica completion bash > ${PROJECT_BINARY_DIR}/plica.bash
  DEPENDS plica)
add_custom_target(plica_manual ALL DEPENDS ${PROJECT_BINARY_DIR}/plica.1.gz)
configure_file(cmake/debian_changelog.in ${PROJECT_BINARY_DIR}/changelog @ONLY)
execute_process(COMMAND gzip -9nkf ${PROJECT_BINARY_DIR}/changelog COMMAND_ERROR_IS_FATAL ANY)

install(TARGETS plica RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
install(TARGETS plica_mesher RUNTIME DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/plica COMPONENT program)
install(FILES ${PROJECT_BINARY_DIR}/plica.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1
  COMPONENT program)
install(FILES ${PROJECT_BINARY_DIR}/plica.bash RENAME plica
  DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT program)
install(DIRECTORY cases DESTINATION ${CMAKE_INSTALL_DATADIR}/plica COMPONENT program)
install(FILES README.md LICENSE ${PROJECT_BINARY_DIR}/changelog.gz
  DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
install(FILES cmake/debian_copyright RENAME copyright
  DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)

# Every room is a component with its own targets, so that a user of one need not have what others
# use. Of every component: what it links, and the packages it needs.
set(plica_components "")
foreach(name ${plica_libraries})
  install(TARGETS plica_${name} EXPORT plica-${name}
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}/plica COMPONENT development)
  install(EXPORT plica-${name} NAMESPACE plica:: DESTINATION ${plica_package_dir}
    COMPONENT development)
  get_target_property(links plica_${name} PLICA_LINKS)
  get_target_property(packages plica_${name} PLICA_PACKAGES)
  list(FILTER links INCLUDE REGEX "^plica::")
  string(REPLACE "plica::" "" links "${links}")
  if(NOT packages)
    set(packages "")
  endif()
  string(APPEND plica_components
    "set(plica_links_of_${name} \"${links}\")\nset(plica_packages_of_${name} \"${packages}\")\n")
endforeach()

# Headers lie in include/plica and include each other from there: a user writes
# #include "plica/solve/modes.hpp".
foreach(folder words life mesh elements solve reduction lab model run compare diagnose io)
  install(DIRECTORY ${folder} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/plica
    COMPONENT development FILES_MATCHING PATTERN "*.hpp" PATTERN web EXCLUDE)
endforeach()
install(CODE "set(headers \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_INCLUDEDIR}/plica\")"
  COMPONENT development)
install(SCRIPT cmake/prefix_includes.cmake COMPONENT development)
configure_package_config_file(cmake/plica-config.cmake.in
  ${PROJECT_BINARY_DIR}/plica-config.cmake INSTALL_DESTINATION ${plica_package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/plica-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/plica-config.cmake
  ${PROJECT_BINARY_DIR}/plica-config-version.cmake
  cmake/FindCHOLMOD.cmake cmake/FindFftw3.cmake cmake/FindGmshSdk.cmake cmake/FindLibcsv.cmake
  cmake/FindMatio.cmake cmake/FindPlainLibrary.cmake cmake/FindUMFPACK.cmake
  DESTINATION ${plica_package_dir} COMPONENT development)

include(cmake/PythonPackage.cmake)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME plica)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT "The developers of Plica <plica@example.org>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_COMPONENTS_ALL program python)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME plica)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION
  "Turns the drawing of a flexible exhaust pipe into a shell model, gives its static
stiffness and its modes with a proof that none is missing, the response on a
shaker table and a superelement for a larger model, and says where and why a
test differs from it.")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS libopenblas0-pthread)
set(CPACK_STRIP_FILES ON)
include(CPack)
