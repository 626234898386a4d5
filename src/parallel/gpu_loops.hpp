// SPDX-License-Identifier: Apache-2.0
// Particle loops and reductions on an NVIDIA GPU. Loop bodies stay in the constant memory of the
// kernel's parameters (__grid_constant__): as copies of each thread, which Thrust makes, those with
// arrays would take kilobytes of its local memory.
#pragma once

#include "parallel/lane.hpp"

#if defined(__CUDACC__)

#include <cuda_runtime.h>
#include <thrust/device_vector.h>
#include <thrust/system/cuda/error.h>
#include <thrust/system_error.h>

#include <cstdint>

namespace kerf::gpu {

inline constexpr std::uint32_t loop_threads = 128;  // of a block
inline constexpr std::uint32_t values_per_thread = 8;

inline void check(cudaError_t error, const char* what) {
  if (error != cudaSuccess) throw thrust::system_error(error, thrust::cuda_category(), what);
}

template <class Body>
__global__ void __launch_bounds__(loop_threads)
    run_loop(std::uint32_t count, const __grid_constant__ Body body) {
  const std::uint32_t i = blockIdx.x * loop_threads + threadIdx.x;
  if (i < count) body(i);
}

// Calls body(i) for i = 0 .. count - 1, in any order; the host does not wait.
template <class Body>
void for_each_index(std::uint32_t count, const Body& body) {
  if (count == 0) return;
  const std::uint32_t blocks = (count + loop_threads - 1) / loop_threads;
  run_loop<<<blocks, loop_threads, 0, cudaStreamLegacy>>>(count, body);
  check(cudaGetLastError(), "a loop over particles");
}

// The threads of a block add several values each, side by side in memory, and join their results in
// a tree. The order depends on the number of values alone, so that repeated runs agree bit for bit.
// `Fold` has start(), add(i, result) and join(result, other).
template <class T, class Fold>
__global__ void __launch_bounds__(loop_threads, 8)
    fold_blocks(std::uint32_t count, const __grid_constant__ Fold fold, T* partial) {
  extern __shared__ double shared_numbers[];
  T* const results = reinterpret_cast<T*>(shared_numbers);
  const std::uint32_t thread = threadIdx.x;
  T result = fold.start();
  std::uint32_t i = blockIdx.x * loop_threads * values_per_thread + thread;
  for (std::uint32_t k = 0; k < values_per_thread && i < count; ++k, i += loop_threads)
    fold.add(i, result);
  results[thread] = result;
  for (std::uint32_t half = loop_threads / 2; half > 0; half /= 2) {
    __syncthreads();
    if (thread < half) fold.join(results[thread], results[thread + half]);
  }
  if (thread == 0) partial[blockIdx.x] = results[0];
}

// Folds the results of blocks.
template <class T, class Fold>
struct FoldPartial {
  Fold fold;
  const T* partial;

  __device__ T start() const { return fold.start(); }
  __device__ void add(std::uint32_t i, T& result) const { fold.join(result, partial[i]); }
  __device__ void join(T& result, const T& other) const { fold.join(result, other); }
};

// Memory that is kept from call to call; `use` tells apart what is used at once. It is never freed,
// as that of loop_policy.hpp.
template <class T, int use>
thrust::device_vector<T>& kept_array() {
  static auto& memory = *new thrust::device_vector<T>;
  return memory;
}
template <class T, int use = 0>
T* scratch_memory(std::size_t length) {
  auto& memory = kept_array<T, 100 + use>();
  if (memory.size() < length) memory.resize(length);
  return thrust::raw_pointer_cast(memory.data());
}
// One memory for all types, one call after the other.
template <class T>
T* raw_memory(std::size_t length) {
  static_assert(alignof(T) <= 256, "that of memory of the device");
  return reinterpret_cast<T*>(scratch_memory<double>(length * sizeof(T) / sizeof(double) + 1));
}
template <class T>
void copy_on_device(const T* from, std::size_t count, T* to) {
  check(cudaMemcpyAsync(to, from, count * sizeof(T), cudaMemcpyDeviceToDevice, cudaStreamLegacy),
        "a copy of a field");
}

// Returns the fold of 0 .. count - 1.
template <class T, class Fold>
T fold(std::uint32_t count, const Fold& fold) {
  constexpr std::uint32_t per_block = loop_threads * values_per_thread;
  constexpr std::size_t shared = loop_threads * sizeof(T);
  static_assert(shared <= 48 * 1024, "the results of a block fit into its shared memory");
  std::uint32_t blocks = (count + per_block - 1) / per_block;
  T* from = scratch_memory<T>(blocks + blocks / per_block + 3);
  fold_blocks<<<blocks, loop_threads, shared, cudaStreamLegacy>>>(count, fold, from);
  while (blocks > 1) {
    const std::uint32_t joined = (blocks + per_block - 1) / per_block;
    fold_blocks<<<joined, loop_threads, shared, cudaStreamLegacy>>>(
        blocks, FoldPartial<T, Fold>{fold, from}, from + blocks);
    from += blocks;
    blocks = joined;
  }
  check(cudaGetLastError(), "a reduction over particles");
  T result;
  check(cudaMemcpy(&result, from, sizeof(T), cudaMemcpyDeviceToHost), "a reduction over particles");
  return result;
}

// A warp of threads computes parts of body k, combines them in a tree and finishes the result.
template <class T, class Body, class Combine>
__global__ void __launch_bounds__(loop_threads)
    run_groups(std::uint32_t count, const __grid_constant__ Body body, Combine combine,
               T* results) {
  constexpr std::uint32_t lanes = 32;
  extern __shared__ double shared_numbers[];
  T* const parts = reinterpret_cast<T*>(shared_numbers);
  const std::uint32_t thread = threadIdx.x, lane = thread % lanes;
  const std::uint32_t k = (blockIdx.x * loop_threads + thread) / lanes;
  if (k >= count) return;  // all of the warp
  parts[thread] = body.part(k, Lane{lane, lanes});
  for (std::uint32_t half = lanes / 2; half > 0; half /= 2) {
    __syncwarp();
    if (lane < half) parts[thread] = combine(parts[thread], parts[thread + half]);
  }
  if (lane == 0) results[k] = body.finish(k, parts[thread]);
}

// Combines the values of a loop, as reduce_unordered.
template <class T, class Value, class Combine>
struct Combination {
  Value value;
  Combine combine;
  T initial;

  __device__ T start() const { return initial; }
  __device__ void add(std::uint32_t i, T& result) const {
    result = combine(result, static_cast<T>(value(i)));
  }
  __device__ void join(T& result, const T& other) const { result = combine(result, other); }
};

template <class T>
struct ValueOf {
  const T* values;
  __device__ T operator()(std::uint32_t i) const { return values[i]; }
};
// As reduce_in_groups.
template <class T, class Body, class Combine>
T fold_in_groups(std::uint32_t count, const Body& body, T initial, const Combine& combine) {
  constexpr std::uint32_t per_block = loop_threads / 32;
  const std::uint32_t blocks = (count + per_block - 1) / per_block;
  T* const results = scratch_memory<T, 1>(count);
  run_groups<<<blocks, loop_threads, loop_threads * sizeof(T), cudaStreamLegacy>>>(
      count, body, combine, results);
  using Values = Combination<T, ValueOf<T>, Combine>;
  return fold<T>(count, Values{{results}, combine, initial});
}

// Adds values to a sum (parallel/ordered_sum.hpp).
template <class Sum, class Value>
struct Addition {
  Value value;

  __device__ Sum start() const { return Sum::zero(); }
  __device__ void add(std::uint32_t i, Sum& sum) const {
    if constexpr (requires { value.add_all(i, i + 1, sum); })
      value.add_all(i, i + 1, sum);
    else
      value.add(i, sum);
  }
  __device__ void join(Sum& sum, const Sum& other) const { sum.join(other); }
};

}  // namespace kerf::gpu

#endif
