# SPDX-License-Identifier: Apache-2.0
# What `cmake --install` copies and CPack packs: the program, its manual page and completions, which
# the program prints itself, cases, materials and docs.
include(GNUInstallDirs)
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME program)

set(kerf_printed ${CMAKE_BINARY_DIR}/generated/printed)
# kerf_print(file arguments...) writes what `kerf arguments` prints into a file.
function(kerf_print file)
  add_custom_command(OUTPUT ${kerf_printed}/${file}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${kerf_printed}
    COMMAND kerf ${ARGN} > ${kerf_printed}/${file}
    DEPENDS kerf
    COMMENT "Printing ${file}"
    VERBATIM)
endfunction()
kerf_print(kerf.1 manual)
kerf_print(kerf.bash completion bash)
kerf_print(_kerf completion zsh)
kerf_print(kerf.fish completion fish)
add_custom_target(kerf_printed_files ALL DEPENDS ${kerf_printed}/kerf.1 ${kerf_printed}/kerf.bash
  ${kerf_printed}/_kerf ${kerf_printed}/kerf.fish)

install(TARGETS kerf RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(FILES ${kerf_printed}/kerf.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${kerf_printed}/kerf.bash RENAME kerf
  DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(FILES ${kerf_printed}/_kerf DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions)
install(FILES ${kerf_printed}/kerf.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
install(DIRECTORY cases materials DESTINATION ${CMAKE_INSTALL_DATADIR}/kerf)
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR} PATTERN site EXCLUDE)  # where README.md links to
# The pages link to cases as they are in the source tree.
file(CREATE_LINK ../../kerf/cases ${CMAKE_BINARY_DIR}/generated/cases SYMBOLIC)
install(FILES ${CMAKE_BINARY_DIR}/generated/cases DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES README.md CHANGELOG.md CONTRIBUTING.md LICENSE CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES python/tutorial.ipynb DESTINATION ${CMAKE_INSTALL_DOCDIR}/python)

if(KERF_HAS_PYTHON)  # a component of its own, which `scripts/wheel` and the package python3-kerf take
  set(KERF_PYTHON_FOLDER lib/python3/dist-packages CACHE STRING "Where the Python package is installed")
  install(TARGETS _kerf LIBRARY DESTINATION ${KERF_PYTHON_FOLDER}/kerf COMPONENT python)
  install(FILES ${kerf_python_files} DESTINATION ${KERF_PYTHON_FOLDER}/kerf COMPONENT python)
endif()

set(CPACK_PACKAGE_VENDOR "The Kerf project")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_RESOURCE_FILE_LICENSE ${CMAKE_SOURCE_DIR}/LICENSE)
set(CPACK_RESOURCE_FILE_README ${CMAKE_SOURCE_DIR}/README.md)
set(CPACK_GENERATOR TGZ)
set(CPACK_STRIP_FILES ON)
# `cpack -G DEB` needs the one who packs: -D CPACK_DEBIAN_PACKAGE_MAINTAINER="NAME <ADDRESS>".
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL program library development)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME kerf)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libkerf${PROJECT_VERSION_MAJOR})
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libkerf-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libkerf${PROJECT_VERSION_MAJOR} (= ${PROJECT_VERSION}-1)")
set(CPACK_COMPONENT_LIBRARY_DESCRIPTION "This is the library for programs in C++: it reads and checks cases, runs
them step by step, and shows their particles.")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "These are the headers of the library for programs in C++, and an example.")
if(KERF_HAS_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-kerf)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  math(EXPR next_python "${Python_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= ${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}), python3 (<< ${Python_VERSION_MAJOR}.${next_python}), python3-numpy")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS kerf)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-pandas, python3-vtk9")
  set(CPACK_COMPONENT_PYTHON_DESCRIPTION "This is the module for Python: it runs cases of Kerf step by step, shows their
particles as NumPy arrays, and reads results.")
endif()
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "ffmpeg, paraview")
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "Kerf computes by smoothed particle hydrodynamics how a water jet splits,
how a solid deforms and fractures under it, whether it is cut through, and
which setting is the best that still cuts.")
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/KerfDebian.cmake)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ
  GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
include(CPack)
