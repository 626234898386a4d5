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

# The walks of src/lanes/, once for each instruction set; which one runs is chosen at run time.
function(kerf_add_lanes target)
  set(common -O3 -ffp-contract=fast)
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    # g++ 12 takes the undefined halves inside its own AVX-512 headers for mistakes of their user.
    list(APPEND common -Wno-uninitialized -Wno-maybe-uninitialized)
  endif()
  set(variants baseline)
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    list(APPEND variants avx2)
    target_compile_definitions(${target} PRIVATE KERF_HAS_X86_LANES)
    # With clang 14 masks of 512 bits come out wrong in libstdc++'s <experimental/simd>.
    if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
      list(APPEND variants avx512)
      target_compile_definitions(${target} PRIVATE KERF_HAS_AVX512_LANES)
    endif()
  endif()
  set(flags_avx2 -march=x86-64-v3)
  set(flags_avx512 -march=x86-64-v4 -mprefer-vector-width=512)
  target_sources(${target} PRIVATE ${CMAKE_SOURCE_DIR}/src/lanes/walks.cpp)
  foreach(variant IN LISTS variants)
    set(file ${CMAKE_SOURCE_DIR}/src/lanes/walks_${variant}.cpp)
    target_sources(${target} PRIVATE ${file})
    set_source_files_properties(${file} PROPERTIES COMPILE_OPTIONS "${common};${flags_${variant}}")
  endforeach()
endfunction()

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

# kerf_gpu_engine(target kind sources...): the engine with its loops for a GPU, as a library that the
# program loads (src/gpu/gpu_engine.hpp). kind: cuda or emulated. It shows the linker nothing else of
# Kerf, so that its code and that of the program, from the same sources, are never mixed.
function(kerf_gpu_engine target kind)
  set(own ${CMAKE_SOURCE_DIR}/src/gpu/gpu_engine.cpp ${CMAKE_SOURCE_DIR}/src/gpu/${kind}_gpu.cpp)
  add_library(${target} MODULE ${ARGN} ${own})
  target_link_libraries(${target} PRIVATE kerf_case kerf_thrust_${kind} Eigen3::Eigen)
  target_compile_definitions(${target} PRIVATE KERF_ON_GPU=1)
  set_target_properties(${target} PROPERTIES CXX_VISIBILITY_PRESET hidden
    CUDA_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  target_link_options(${target} PRIVATE -Wl,--exclude-libs,ALL)
  if(kind STREQUAL cuda)  # nvcc takes the sources with particle loops; it stumbles over fmt in others
    list(FILTER ARGN INCLUDE REGEX "/instantiate_")
    set_source_files_properties(${ARGN} ${CMAKE_SOURCE_DIR}/src/gpu/cuda_gpu.cpp
      PROPERTIES LANGUAGE CUDA)
  endif()
endfunction()
