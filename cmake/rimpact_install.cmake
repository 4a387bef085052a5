# What `cmake --install` and the Debian package (`cpack -G DEB`) hold. Programs find their data in ../share/rimpact, so the prefix
# may be moved; the build folder has links of the same form to the source tree.
include(GNUInstallDirs)
set(data ${CMAKE_INSTALL_DATADIR}/rimpact)
# Where Debian's python3 looks; for another prefix, PYTHONPATH=PREFIX/lib/python3/dist-packages.
set(RIMPACT_PYTHON_FOLDER lib/python3/dist-packages CACHE STRING "Where the Python package is installed, under the prefix")
file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/share/rimpact/data)
file(CREATE_LINK ${PROJECT_SOURCE_DIR}/report ${CMAKE_BINARY_DIR}/share/rimpact/report SYMBOLIC)
foreach(kept studies thesis references reliability words)
  file(CREATE_LINK ${PROJECT_SOURCE_DIR}/data/${kept} ${CMAKE_BINARY_DIR}/share/rimpact/data/${kept} SYMBOLIC)
endforeach()

# The component `reduced` is all that the pip package holds (pyproject.toml): the program, its data, the Python package.
install(TARGETS rimpact RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT reduced)
if(RIMPACT_FE)
  install(TARGETS rimpact-fe rimpact-gmsh RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
install(DIRECTORY report DESTINATION ${data} COMPONENT reduced PATTERN __pycache__ EXCLUDE)
install(DIRECTORY data/studies DESTINATION ${data}/data COMPONENT reduced FILES_MATCHING PATTERN *.json PATTERN before EXCLUDE)
install(DIRECTORY data/thesis data/references data/reliability data/words DESTINATION ${data}/data COMPONENT reduced)
install(DIRECTORY docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/docs PATTERN __pycache__ EXCLUDE)
install(FILES README.md CHANGELOG.md CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY examples DESTINATION ${CMAKE_INSTALL_DOCDIR})

# Completion and man pages are what the program says of itself.
set(words ${CMAKE_BINARY_DIR}/words)
add_custom_command(OUTPUT ${words}/completion/rimpact ${words}/man/rimpact.1
  COMMAND ${CMAKE_COMMAND} -DPROGRAM=$<TARGET_FILE:rimpact> -DOUTPUT=${words} -DVERSION=${PROJECT_VERSION} -DFE=${RIMPACT_FE}
          -P ${PROJECT_SOURCE_DIR}/cmake/rimpact_words.cmake
  DEPENDS rimpact ${PROJECT_SOURCE_DIR}/cmake/rimpact_words.cmake VERBATIM)
add_custom_target(rimpact_words ALL DEPENDS ${words}/completion/rimpact ${words}/man/rimpact.1)
if(RIMPACT_FE)
  add_dependencies(rimpact_words rimpact-fe)
endif()
# What ./run builds: all that is installed.
add_custom_target(product DEPENDS rimpact rimpact_words)
if(RIMPACT_PYTHON)
  add_dependencies(product rimpact_python)
endif()
install(FILES ${words}/completion/rimpact DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(FILES ${words}/completion/_rimpact DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions)
install(FILES ${words}/completion/rimpact.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
install(DIRECTORY ${words}/man/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES cmake/debian/copyright DESTINATION ${CMAKE_INSTALL_DOCDIR})

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME rimpact)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT "rimpact maintainers <maintainers@users.noreply.h-seed-fe5eb5a0.example>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "impacts of friction-pendulum bearings on their rim")
set(CPACK_PACKAGE_DESCRIPTION
"Finite-element reference curves of friction-pendulum bearings whose slider
hits the restraining rim, impact laws calibrated to them, reduced models that
fly them in milliseconds, sweeps, and a report.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# What no shared library tells: the report's Python, and a BLAS that is fast.
set(CPACK_DEBIAN_PACKAGE_DEPENDS
  "python3 (>= 3.11), python3-h5py, python3-matplotlib, python3-pil, python3-jinja2, python3-numpy, python3-pandas, libopenblas0-pthread")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "chromium, paraview, python3-openturns")
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA "${PROJECT_SOURCE_DIR}/cmake/debian/postinst;${PROJECT_SOURCE_DIR}/cmake/debian/prerm")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
include(CPack)
