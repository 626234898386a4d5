// SPDX-License-Identifier: Apache-2.0
#include <cuda_runtime.h>

#include "engine/gpu/this_gpu.hpp"

namespace kerf {
namespace {

__global__ void nothing() {}

std::string clause_of(cudaError_t error) {
  return std::string("CUDA says: ") + cudaGetErrorString(error);
}

}  // namespace

std::string problem_of_gpu() {
  int count = 0;
  if (const auto error = cudaGetDeviceCount(&count); error != cudaSuccess) return clause_of(error);
  if (count == 0) return "there is no NVIDIA GPU";
  // This call fails if the code was compiled for another type of GPU.
  cudaFuncAttributes attributes;
  if (const auto error = cudaFuncGetAttributes(&attributes, nothing); error != cudaSuccess)
    return clause_of(error);
  return "";
}

std::string name_of_gpu() {
  int device = 0;
  cudaDeviceProp properties;
  if (cudaGetDevice(&device) != cudaSuccess ||
      cudaGetDeviceProperties(&properties, device) != cudaSuccess)
    return "unknown GPU";
  return properties.name;
}

}  // namespace kerf
