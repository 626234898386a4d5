// SPDX-License-Identifier: Apache-2.0
// Particle loops: a thin layer on Thrust, whose device is TBB threads in the program and an NVIDIA
// GPU in the engine for GPUs (src/engine/gpu/). Loop bodies are named functors (nvcc refuses
// extended lambdas inside generic code, and a named functor gives each profile a label).
#pragma once

#include <thrust/binary_search.h>
#include <thrust/copy.h>
#include <thrust/count.h>
#include <thrust/device_vector.h>
#include <thrust/execution_policy.h>
#include <thrust/extrema.h>
#include <thrust/fill.h>
#include <thrust/for_each.h>
#include <thrust/gather.h>
#include <thrust/host_vector.h>
#include <thrust/iterator/counting_iterator.h>
#include <thrust/reduce.h>
#include <thrust/scan.h>
#include <thrust/sequence.h>
#include <thrust/sort.h>
#include <thrust/transform_reduce.h>

#include <cstdint>
#include <vector>

#include "core/host_device.hpp"
#include "parallel/loop_policy.hpp"
#if defined(KERF_TSAN_THREADS)
#include "parallel/tsan_threads.hpp"
#endif

namespace kerf {

using Index = std::uint32_t;

// Whether this is compiled for a GPU, or for the emulation of one (KERF_GPU in CMakeLists.txt).
#if defined(KERF_ON_GPU)
inline constexpr bool on_gpu = true;
#else
inline constexpr bool on_gpu = false;
#endif

template <class T>
using Array = thrust::device_vector<T>;

template <class T>
T* pointer(Array<T>& array) {
  return thrust::raw_pointer_cast(array.data());
}
template <class T>
const T* pointer(const Array<T>& array) {
  return thrust::raw_pointer_cast(array.data());
}

// Calls body(i) for i = 0 .. count - 1, in any order.
template <class Body>
void for_each_index(Index count, const Body& body) {
#if defined(KERF_TSAN_THREADS)
  for_each_index_under_tsan(count, body);
#else
  thrust::for_each(loop_policy(), thrust::counting_iterator<Index>(0),
                   thrust::counting_iterator<Index>(count), body);
#endif
}

// Store and load a flag that loop bodies of other threads may store as well.
KERF_FUNCTION void store_flag(std::uint8_t& flag, std::uint8_t value) {
#if defined(__CUDA_ARCH__)
  flag = value;
#else
  __atomic_store_n(&flag, value, __ATOMIC_RELAXED);
#endif
}
KERF_FUNCTION void set_flag(std::uint8_t& flag) {
  store_flag(flag, 1);
}
KERF_FUNCTION std::uint8_t load_flag(const std::uint8_t& flag) {
#if defined(__CUDA_ARCH__)
  return flag;
#else
  return __atomic_load_n(&flag, __ATOMIC_RELAXED);
#endif
}

// Whether a flag is set.
struct IsSet {
  const std::uint8_t* flag;
  KERF_FUNCTION bool operator()(Index i) const { return flag[i] != 0; }
};

// Combines value(0) .. value(count - 1) with an operator whose result does not depend on order
// (minimum, maximum, or): exact for any number of threads.
template <class T, class Value, class Combine>
T reduce_unordered(Index count, const Value& value, T initial, const Combine& combine) {
  return thrust::transform_reduce(loop_policy(), thrust::counting_iterator<Index>(0),
                                  thrust::counting_iterator<Index>(count), value, initial, combine);
}

// Returns for how many of 0 .. count - 1 the predicate is true.
template <class Predicate>
Index count_indices(Index count, const Predicate& predicate) {
  return static_cast<Index>(thrust::count_if(loop_policy(), thrust::counting_iterator<Index>(0),
                                             thrust::counting_iterator<Index>(count), predicate));
}

// Logical or.
struct Either {
  KERF_FUNCTION bool operator()(bool a, bool b) const { return a || b; }
};

template <class T>
std::vector<T> to_host(const Array<T>& array) {
  std::vector<T> host(array.size());
  if (!host.empty()) thrust::copy(array.begin(), array.end(), host.begin());
  return host;
}

template <class T>
void to_device(const std::vector<T>& host, Array<T>& array) {
  array.resize(host.size());
  if (!host.empty()) thrust::copy(host.begin(), host.end(), array.begin());
}

}  // namespace kerf
