# SPDX-License-Identifier: Apache-2.0
# Every library that Kerf uses; docs/dependencies.md gives the reason for each choice.
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(fmt REQUIRED)
find_package(spdlog REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(CLI11 REQUIRED)
find_package(TBB REQUIRED)
find_package(Eigen3 REQUIRED)
find_package(Boost REQUIRED COMPONENTS filesystem)
find_package(HDF5 REQUIRED COMPONENTS C)
find_package(ZLIB REQUIRED)
find_package(assimp REQUIRED)
pkg_check_modules(muparser REQUIRED IMPORTED_TARGET muparser)
pkg_check_modules(cairo REQUIRED IMPORTED_TARGET cairo)
find_package(SQLiteCpp REQUIRED)
pkg_check_modules(nlopt REQUIRED IMPORTED_TARGET nlopt_cxx)
# Its flags name the options that the library was built with, on which the size of its types depends.
pkg_check_modules(httplib REQUIRED IMPORTED_TARGET cpp-httplib)
find_path(UDUNITS2_INCLUDE udunits2.h REQUIRED)
find_library(UDUNITS2_LIBRARY udunits2 REQUIRED)
add_library(udunits2 INTERFACE)
target_include_directories(udunits2 SYSTEM INTERFACE ${UDUNITS2_INCLUDE})
target_link_libraries(udunits2 INTERFACE ${UDUNITS2_LIBRARY})

# Particle loops on CPU threads: Debian's Thrust with TBB.
add_library(kerf_thrust INTERFACE)
find_path(THRUST_INCLUDE thrust/version.h REQUIRED)
target_include_directories(kerf_thrust SYSTEM INTERFACE ${THRUST_INCLUDE})
# Debian's TBB is not instrumented for ThreadSanitizer: src/parallel/threads.cpp.
if(KERF_SANITIZE MATCHES thread)
  target_compile_definitions(kerf_thrust INTERFACE
    THRUST_DEVICE_SYSTEM=THRUST_DEVICE_SYSTEM_CPP KERF_TSAN_THREADS=1)
else()
  target_compile_definitions(kerf_thrust INTERFACE THRUST_DEVICE_SYSTEM=THRUST_DEVICE_SYSTEM_TBB)
endif()
target_compile_definitions(kerf_thrust INTERFACE THRUST_IGNORE_DEPRECATED_CPP_DIALECT=1)
target_link_libraries(kerf_thrust INTERFACE TBB::tbb)

# Several ranks: Open MPI, and the recursive coordinate bisection of Zoltan.
if(KERF_MPI)
  find_package(MPI REQUIRED COMPONENTS CXX)
  find_path(ZOLTAN_INCLUDE zoltan.h PATH_SUFFIXES trilinos REQUIRED)
  find_library(ZOLTAN_LIBRARY NAMES trilinos_zoltan zoltan REQUIRED)
  add_library(zoltan INTERFACE)
  target_include_directories(zoltan SYSTEM INTERFACE ${ZOLTAN_INCLUDE})
  target_link_libraries(zoltan INTERFACE ${ZOLTAN_LIBRARY})
endif()

# Particle loops on a GPU: the Thrust of the CUDA toolkit, or that of the CPU in the emulation.
add_library(kerf_thrust_emulated INTERFACE)
target_link_libraries(kerf_thrust_emulated INTERFACE kerf_thrust)
if(KERF_GPU STREQUAL cuda)
  if(NOT CMAKE_CUDA_ARCHITECTURES)
    set(CMAKE_CUDA_ARCHITECTURES 90)
  endif()
  enable_language(CUDA)
  set(CMAKE_CUDA_STANDARD 20)
  if(NOT CMAKE_CUDA20_STANDARD_COMPILE_OPTION)  # CMake 3.25 does not know this flag of nvcc
    set(CMAKE_CUDA20_STANDARD_COMPILE_OPTION "-std=c++20")
    set(CMAKE_CUDA20_EXTENSION_COMPILE_OPTION "-std=c++20")
  endif()
  find_package(CUDAToolkit REQUIRED)
  add_library(kerf_thrust_cuda INTERFACE)
  # Without --Werror a loop body that calls a host function would fail on the GPU at run time. The last
  # three let single-precision divisions and roots be wrong in the last two digits, as those of the SIMD
  # kernels are; exact ones take ten instructions each.
  target_compile_options(kerf_thrust_cuda INTERFACE $<$<COMPILE_LANGUAGE:CUDA>:
    --expt-relaxed-constexpr --Werror=cross-execution-space-call
    -ftz=true -prec-div=false -prec-sqrt=false>)
  target_link_libraries(kerf_thrust_cuda INTERFACE CUDA::cudart_static)
endif()
