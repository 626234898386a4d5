# SPDX-License-Identifier: Apache-2.0
# Functions that define the libraries of Kerf: compiler flags, warnings, sanitizers.
add_library(kerf_flags INTERFACE)
target_include_directories(kerf_flags INTERFACE ${CMAKE_BINARY_DIR}/generated)
configure_file(${CMAKE_SOURCE_DIR}/src/parallel/build_options.hpp.in
  ${CMAKE_BINARY_DIR}/generated/build_options.hpp)
target_compile_definitions(kerf_flags INTERFACE KERF_VERSION="${PROJECT_VERSION}")
target_compile_options(kerf_flags INTERFACE
  $<$<COMPILE_LANGUAGE:CXX>:-Wall -Wextra -Wpedantic -Wshadow>
  $<$<AND:$<COMPILE_LANGUAGE:CXX>,$<BOOL:${KERF_WERROR}>>:-Werror>
  $<$<COMPILE_LANGUAGE:CXX>:-fno-math-errno -fno-trapping-math -ffp-contract=off>)
set(KERF_INSTRUCTION_SETS baseline)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  list(APPEND KERF_INSTRUCTION_SETS avx2)
  target_compile_definitions(kerf_flags INTERFACE KERF_HAS_X86_SIMD)
  # With clang 14 the 512-bit masks of <experimental/simd> of libstdc++ are wrong.
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    list(APPEND KERF_INSTRUCTION_SETS avx512)
    target_compile_definitions(kerf_flags INTERFACE KERF_HAS_AVX512_SIMD)
  endif()
endif()
if(KERF_SANITIZE)
  # -O1 -g1 compiles in half the time of -O2 -g, and stack traces still have line numbers.
  target_compile_options(kerf_flags INTERFACE
    -fsanitize=${KERF_SANITIZE} -fno-omit-frame-pointer -O1 -g1
    $<$<BOOL:${KERF_FUZZ}>:-fno-sanitize-recover=all>
    # g++ mistakes code of the sanitizers for reads of uninitialized values, for instance in <regex>.
    $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  target_link_options(kerf_flags INTERFACE -fsanitize=${KERF_SANITIZE})
  if(KERF_SANITIZE MATCHES thread AND CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    # g++ warns that ThreadSanitizer does not see the fences of Boost.Asio.
    set_source_files_properties(src/study/child_process.cpp PROPERTIES COMPILE_OPTIONS -Wno-tsan)
  endif()
endif()

# kerf_precompile_headers(name HEADERS ... LIBRARIES ... OPTIONS ... LAYERS ...) compiles headers once for layers
# that have the same compiler flags: they are most of what a source of a hundred lines costs to compile. g++ takes
# the level of optimization from precompiled headers, so the options are those of the layers as well.
function(kerf_precompile_headers name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "HEADERS;LIBRARIES;OPTIONS;LAYERS")
  file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/generated/${name}.cpp CONTENT "")
  add_library(kerf_${name} OBJECT ${CMAKE_BINARY_DIR}/generated/${name}.cpp)
  target_link_libraries(kerf_${name} PRIVATE kerf_flags ${arg_LIBRARIES})
  target_precompile_headers(kerf_${name} PRIVATE <algorithm> <array> <cmath> <cstdint> <filesystem> <functional>
    <map> <memory> <optional> <span> <string> <string_view> <vector> ${arg_HEADERS})
  target_compile_options(kerf_${name} PRIVATE ${arg_OPTIONS})
  foreach(layer IN LISTS arg_LAYERS)
    target_precompile_headers(kerf_${layer} REUSE_FROM kerf_${name})
    target_compile_options(kerf_${layer} PRIVATE ${arg_OPTIONS})
  endforeach()
endfunction()

# kerf_layer(name) builds the library kerf_name from the sources of src/name/. Its include path is a folder of
# links to this folder and to the folders below it in KERF_LAYERS, so it cannot include files of higher layers.
# The sources of layers whose compile time is mostly that of JSON, TOML and CLI11 are compiled several at a time,
# so the compiler refuses a name that two of their anonymous namespaces define.
# Joined with others, g++ 12 takes a value of Boost.Geometry in one of them for uninitialized.
set_source_files_properties(src/input/shape_section.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
set(KERF_JOINED_LAYERS input analysis output report verification study app)
function(kerf_layer name)
  kerf_layer_folder(${name} folder)
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/src/${name}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "/main.cpp$")
  add_library(kerf_${name} STATIC ${sources})
  target_include_directories(kerf_${name} PRIVATE ${folder})
  target_link_libraries(kerf_${name} PUBLIC kerf_flags)
  if(name IN_LIST KERF_JOINED_LAYERS)
    set_target_properties(kerf_${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 12)
  endif()
endfunction()

# Builds the kernels of src/*/simd/ once for each instruction set. The program chooses one at run time
# (src/simd/instruction_set.hpp).
function(kerf_add_simd)
  set(common -O3 -ffp-contract=fast)
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    # g++ 12 warns about the undefined halves of registers inside its own AVX-512 headers.
    list(APPEND common -Wno-uninitialized -Wno-maybe-uninitialized)
  endif()
  set(flags_baseline "")
  set(flags_avx2 -march=x86-64-v3)
  set(flags_avx512 -march=x86-64-v4 -mprefer-vector-width=512)
  kerf_layer_folder(fluid folder)
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/src/*/simd/*.cpp)
  set_source_files_properties(${sources} PROPERTIES COMPILE_OPTIONS "${common}")  # after kerf_flags
  foreach(set IN LISTS KERF_INSTRUCTION_SETS)
    add_library(kerf_simd_${set} STATIC ${sources})
    target_include_directories(kerf_simd_${set} PRIVATE ${folder})
    target_compile_options(kerf_simd_${set} PRIVATE ${flags_${set}})
    target_compile_definitions(kerf_simd_${set} PRIVATE KERF_SIMD=${set})
    target_link_libraries(kerf_simd_${set} PUBLIC kerf_simd kerf_thrust)
    if(NOT set STREQUAL baseline)
      target_link_libraries(kerf_simd_baseline PUBLIC kerf_simd_${set})
    endif()
  endforeach()
endfunction()

# Adds what several ranks need (src/*/mpi/) to the libraries of its layers, and the library that divides space.
function(kerf_add_mpi)
  if(NOT KERF_MPI)
    return()
  endif()
  kerf_layer_folder(distributed folder)
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/src/distributed/mpi/*.cpp)
  add_library(kerf_distributed STATIC ${sources})
  target_include_directories(kerf_distributed PRIVATE ${folder})
  target_link_libraries(kerf_distributed PUBLIC kerf_parallel PRIVATE zoltan MPI::MPI_CXX)
  foreach(layer parallel engine)
    file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/src/${layer}/mpi/*.cpp)
    target_sources(kerf_${layer} PRIVATE ${sources})
  endforeach()
  target_link_libraries(kerf_parallel PRIVATE MPI::MPI_CXX)
  target_link_libraries(kerf_engine PUBLIC kerf_distributed)
endfunction()

# kerf_gpu_engine(target kind sources...) builds the engine with its loops for a GPU as a library that the
# program loads (src/engine/gpu/gpu_engine.hpp). kind: cuda or emulated. The library exports no other symbols of
# Kerf, so its code and the code of the program, built from the same sources, are never mixed.
function(kerf_gpu_engine target kind)
  set(gpu ${CMAKE_SOURCE_DIR}/src/engine/gpu)
  add_library(${target} MODULE ${ARGN} ${gpu}/gpu_engine.cpp ${gpu}/${kind}_gpu.cpp)
  kerf_layer_folder(engine folder)
  target_include_directories(${target} PRIVATE ${folder})
  target_link_libraries(${target} PRIVATE kerf_input kerf_thrust_${kind} Eigen3::Eigen)
  target_compile_definitions(${target} PRIVATE KERF_ON_GPU=1)
  set_target_properties(${target} PROPERTIES CXX_VISIBILITY_PRESET hidden
    CUDA_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  target_link_options(${target} PRIVATE -Wl,--exclude-libs,ALL)
  if(kind STREQUAL cuda)  # nvcc compiles the sources with particle loops; it fails on fmt in others
    list(FILTER ARGN INCLUDE REGEX "/instantiate_")
    set_source_files_properties(${ARGN} ${gpu}/cuda_gpu.cpp
      PROPERTIES LANGUAGE CUDA)
  endif()
endfunction()
