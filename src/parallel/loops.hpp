// SPDX-License-Identifier: Apache-2.0
// Particle loops: a thin layer on Thrust, whose device is TBB threads in the program and an NVIDIA
// GPU in the engine for GPUs (src/engine/gpu/), and for plain loops and reductions on TBB itself
// and on kernels of parallel/gpu_loops.hpp. Loop bodies are named functors (nvcc refuses extended
// lambdas inside generic code, and a named functor gives each profile a label).
#pragma once

#include <thrust/binary_search.h>
#include <thrust/copy.h>
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

#include <array>
#include <cstdint>
#include <vector>

#include "core/host_device.hpp"
#include "parallel/gpu_loops.hpp"
#include "parallel/loop_policy.hpp"
#include "parallel/threads.hpp"

namespace kerf {

// Whether this is compiled for a GPU, or for the emulation of one (KERF_GPU in CMakeLists.txt).
#if defined(KERF_ON_GPU)
inline constexpr bool on_gpu = true;
#else
inline constexpr bool on_gpu = false;
#endif

// Memory of the device that runs the loops. Where that is the processor, a thrust::device_vector
// would instantiate the scheduler of TBB for each type, as for_each_index says below.
template <class T>
#if THRUST_DEVICE_SYSTEM == THRUST_DEVICE_SYSTEM_CUDA
using Array = thrust::device_vector<T>;
#else
using Array = std::vector<T>;
#endif

template <class T>
T* pointer(Array<T>& array) {
  return thrust::raw_pointer_cast(array.data());
}
template <class T>
const T* pointer(const Array<T>& array) {
  return thrust::raw_pointer_cast(array.data());
}

#if defined(__CUDACC__)

// Calls body(i) for i = 0 .. count - 1, in any order.
template <class Body>
void for_each_index(Index count, const Body& body) {
  gpu::for_each_index(count, body);
}

// Combines value(0) .. value(count - 1) and `initial` with an operator whose result depends neither
// on the order nor on how often `initial` is combined (minimum, maximum, or).
template <class T, class Value, class Combine>
T reduce_unordered(Index count, const Value& value, T initial, const Combine& combine) {
  if (count == 0) return initial;
  return gpu::fold<T>(count, gpu::Combination<T, Value, Combine>{value, combine, initial});
}

// As reduce_unordered, of bodies so long that several threads share each: the value of k is
//   body.finish(k, combination of body.part(k, lane) over the lanes).
template <class T, class Body, class Combine>
T reduce_in_groups(Index count, const Body& body, T initial, const Combine& combine) {
  if (count == 0) return initial;
  return gpu::fold_in_groups<T>(count, body, initial, combine);
}

#else

template <class Body>
void for_each_index(Index count, const Body& body) {
  for_each_on_threads(count, body);
}

// The values of one of at most `most` pieces of a loop, combined.
template <class T, class Value, class Combine>
struct ReducePiece {
  static constexpr Index most = 64;
  const Value& value;
  const Combine& combine;
  Index count, length;
  std::array<T, most>& partial;

  void operator()(Index piece) const {
    const Index begin = piece * length;
    const Index end = count - begin < length ? count : begin + length;
    T result = partial[piece];
    for (Index i = begin; i < end; ++i) result = combine(result, static_cast<T>(value(i)));
    partial[piece] = result;
  }
};

template <class T, class Value, class Combine>
T reduce_unordered(Index count, const Value& value, T initial, const Combine& combine) {
  using Piece = ReducePiece<T, Value, Combine>;
  std::array<T, Piece::most> partial;
  partial.fill(initial);
  const Index length = count / Piece::most + 1;
  const Index pieces = (count + length - 1) / length;
  for_each_index(pieces, Piece{value, combine, count, length, partial});
  for (Index piece = 0; piece < pieces; ++piece) initial = combine(initial, partial[piece]);
  return initial;
}

template <class Body, class Combine>
struct InLanes {
  static constexpr std::uint32_t count = on_gpu ? 3 : 1;  // some, where a GPU is emulated
  const Body& body;
  const Combine& combine;
  auto operator()(Index k) const {
    auto result = body.part(k, Lane{0, count});
    for (std::uint32_t lane = 1; lane < count; ++lane)
      result = combine(result, body.part(k, Lane{lane, count}));
    return body.finish(k, result);
  }
};
template <class T, class Body, class Combine>
T reduce_in_groups(Index count, const Body& body, T initial, const Combine& combine) {
  return reduce_unordered(count, InLanes<Body, Combine>{body, combine}, initial, combine);
}

#endif

// A temporary array of indices. On a GPU its memory is kept, since allocation waits for all loops;
// `use` tells apart what is used at once.
template <int use>
class TemporaryIndices {
 public:
  Array<Index>& operator*() { return indices_; }
  Array<Index>* operator->() { return &indices_; }

 private:
#if defined(__CUDACC__)
  Array<Index>& indices_ = gpu::kept_array<Index, use>();
#else
  Array<Index> indices_;
#endif
};

#if defined(__CUDACC__)
template <class T>
struct GatherBody {
  const Index* order;
  const T* from;
  T* to;
  KERF_FUNCTION void operator()(Index k) const { to[k] = from[order[k]]; }
};
#endif
// Replaces the array by array[order[0]], array[order[1]], ...
template <class T>
void gather_in_place(const Array<Index>& order, Array<T>& array) {
#if defined(__CUDACC__)
  const auto count = static_cast<Index>(order.size());
  if (count == 0) return array.clear();
  T* const gathered = gpu::raw_memory<T>(count);
  for_each_index(count, GatherBody<T>{pointer(order), pointer(array), gathered});
  array.resize(count);
  gpu::copy_on_device(gathered, count, pointer(array));
#else
  Array<T> gathered(order.size());
  thrust::gather(loop_policy(), order.begin(), order.end(), array.begin(), gathered.begin());
  array.swap(gathered);
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

struct AddCounts {
  KERF_FUNCTION Index operator()(Index a, Index b) const { return a + b; }
};

// 1 where the predicate is true, else 0.
template <class Predicate>
struct CountsAsOne {
  Predicate predicate;
  KERF_FUNCTION Index operator()(Index i) const { return predicate(i) ? 1 : 0; }
};

// Returns for how many of 0 .. count - 1 the predicate is true.
template <class Predicate>
Index count_indices(Index count, const Predicate& predicate) {
  return reduce_unordered(count, CountsAsOne<Predicate>{predicate}, Index(0), AddCounts{});
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
