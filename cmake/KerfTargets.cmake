# SPDX-License-Identifier: Apache-2.0
# How a library of Kerf is made: compiler flags, warnings, sanitizers.
add_library(kerf_flags INTERFACE)
target_include_directories(kerf_flags INTERFACE ${CMAKE_SOURCE_DIR}/src ${CMAKE_BINARY_DIR}/generated)
target_compile_definitions(kerf_flags INTERFACE KERF_VERSION="${PROJECT_VERSION}")
target_compile_options(kerf_flags INTERFACE
  $<$<COMPILE_LANGUAGE:CXX>:-Wall -Wextra -Wpedantic -Wshadow>
  $<$<AND:$<COMPILE_LANGUAGE:CXX>,$<BOOL:${KERF_WERROR}>>:-Werror>
  $<$<COMPILE_LANGUAGE:CXX>:-fno-math-errno -fno-trapping-math -ffp-contract=off>)
if(KERF_SANITIZE)
  # -O1 -g1: half the time to compile of -O2 -g, and a stack still has lines.
  target_compile_options(kerf_flags INTERFACE
    -fsanitize=${KERF_SANITIZE} -fno-omit-frame-pointer -O1 -g1
    # g++ takes what the sanitizers add for reads of uninitialized values, in <regex> among others.
    -Wno-maybe-uninitialized)
  target_link_options(kerf_flags INTERFACE -fsanitize=${KERF_SANITIZE})
endif()

# kerf_library(name folders... SOURCES_FROM folders... [EXCLUDE files...])
function(kerf_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES_FROM;EXCLUDE" ${ARGN})
  set(sources)
  foreach(folder IN LISTS ARG_SOURCES_FROM)
    file(GLOB found CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/${folder}/*.cpp)
    list(APPEND sources ${found})
  endforeach()
  foreach(file IN LISTS ARG_EXCLUDE)
    list(FILTER sources EXCLUDE REGEX "/${file}$")
  endforeach()
  add_library(kerf_${name} STATIC ${sources})
  target_link_libraries(kerf_${name} PUBLIC kerf_flags)
endfunction()
