# SPDX-License-Identifier: Apache-2.0
# The C++ library kerf::kerf for other programs: libkerf.so, the headers that src/library/kerf.hpp
# includes, and the files by which CMake and pkg-config find them. docs/cpp.md, examples/library/.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

add_library(kerf_shared SHARED $<TARGET_OBJECTS:kerf_library>)
target_link_libraries(kerf_shared PRIVATE kerf_library)
target_include_directories(kerf_shared INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
target_compile_features(kerf_shared INTERFACE cxx_std_20)
set_target_properties(kerf_shared PROPERTIES OUTPUT_NAME kerf EXPORT_NAME kerf
  VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR})

# kerf_public_header(header) copies a header of src/ and those that it includes to the folder that is
# installed, where "folder/header.hpp" is <kerf/folder/header.hpp>, and src/library/ is <kerf/>.
set(kerf_public_headers ${CMAKE_BINARY_DIR}/generated/include)
function(kerf_public_header header)
  string(REGEX REPLACE "^library/" "" installed ${header})
  set(copy ${kerf_public_headers}/kerf/${installed})
  get_property(copied GLOBAL PROPERTY KERF_PUBLIC_HEADERS)
  if(header IN_LIST copied)
    return()
  endif()
  set_property(GLOBAL APPEND PROPERTY KERF_PUBLIC_HEADERS ${header})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/src/${header})
  file(READ ${CMAKE_SOURCE_DIR}/src/${header} text)
  string(REGEX MATCHALL "#include \"[^\"]+\"" includes "${text}")
  string(REGEX REPLACE "#include \"(library/)?" "#include \"kerf/" text "${text}")
  string(REPLACE "KERF_VERSION" "\"${PROJECT_VERSION}\"" text "${text}")
  file(CONFIGURE OUTPUT ${copy} CONTENT "${text}" @ONLY)
  foreach(include IN LISTS includes)
    string(REGEX REPLACE "#include \"([^\"]+)\"" "\\1" include ${include})
    kerf_public_header(${include})
  endforeach()
endfunction()
kerf_public_header(library/kerf.hpp)

set(kerf_cmake_folder ${CMAKE_INSTALL_LIBDIR}/cmake/kerf)
set(kerf_generated ${CMAKE_BINARY_DIR}/generated/library)
file(CONFIGURE OUTPUT ${kerf_generated}/kerfConfig.cmake
  CONTENT "include(\${CMAKE_CURRENT_LIST_DIR}/kerfTargets.cmake)\n" ESCAPE_QUOTES @ONLY)
write_basic_package_version_file(${kerf_generated}/kerfConfigVersion.cmake COMPATIBILITY SameMinorVersion)
file(CONFIGURE OUTPUT ${kerf_generated}/kerf.pc @ONLY CONTENT [[
prefix=@CMAKE_INSTALL_PREFIX@
libdir=${prefix}/@CMAKE_INSTALL_LIBDIR@
includedir=${prefix}/@CMAKE_INSTALL_INCLUDEDIR@

Name: kerf
Description: @PROJECT_DESCRIPTION@
Version: @PROJECT_VERSION@
Libs: -L${libdir} -lkerf
Cflags: -I${includedir}
]])

install(TARGETS kerf_shared EXPORT kerf
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library NAMELINK_COMPONENT development)
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME development)
install(EXPORT kerf NAMESPACE kerf:: FILE kerfTargets.cmake DESTINATION ${kerf_cmake_folder})
install(FILES ${kerf_generated}/kerfConfig.cmake ${kerf_generated}/kerfConfigVersion.cmake
  DESTINATION ${kerf_cmake_folder})
install(FILES ${kerf_generated}/kerf.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
install(DIRECTORY ${kerf_public_headers}/kerf DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY examples/library DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libkerf-dev/examples)
unset(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME)
