# The Python package as component `python`, Debian package python3-plica.
set(plica_python lib/python3/dist-packages)
set(plica_python_doc ${CMAKE_INSTALL_DATADIR}/doc/python3-plica)
configure_file(python/debian/METADATA.in ${PROJECT_BINARY_DIR}/python/METADATA @ONLY)
install(DIRECTORY python/plica DESTINATION ${plica_python} COMPONENT python
  FILES_MATCHING PATTERN "*.py" PATTERN py.typed
  PATTERN __pycache__ EXCLUDE)
install(FILES ${PROJECT_BINARY_DIR}/python/METADATA
  DESTINATION ${plica_python}/plica-${PROJECT_VERSION}.dist-info COMPONENT python)
install(DIRECTORY python/examples DESTINATION ${plica_python_doc} COMPONENT python
  PATTERN __pycache__ EXCLUDE)
install(FILES docs/python.md ${PROJECT_BINARY_DIR}/changelog.gz
  DESTINATION ${plica_python_doc} COMPONENT python)
install(FILES cmake/debian_copyright RENAME copyright
  DESTINATION ${plica_python_doc} COMPONENT python)

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-plica)
set(CPACK_DEBIAN_PYTHON_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS OFF)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= 3.11), python3-numpy")
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "plica, python3-pandas, python3-xarray, python3-scipy, \
python3-h5py, python3-matplotlib, python3-yaml, python3-tqdm")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS python3-meshio)
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
  "${PROJECT_SOURCE_DIR}/python/debian/postinst;${PROJECT_SOURCE_DIR}/python/debian/prerm")
set(CPACK_DEBIAN_PYTHON_DESCRIPTION "Reads the results of plica as tables, arrays and meshes, runs its
 commands with errors as exceptions, exchanges responses and superelements with
 other packages and draws plots with the look of the report.")
