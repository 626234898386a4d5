// SPDX-License-Identifier: Apache-2.0
// The execution policy of particle loops, and the wait for their end.
#pragma once

#include <thrust/execution_policy.h>

#if THRUST_DEVICE_SYSTEM == THRUST_DEVICE_SYSTEM_CUDA
#include <cuda_runtime_api.h>
#include <thrust/mr/allocator.h>
#include <thrust/mr/disjoint_pool.h>
#include <thrust/mr/new.h>
#include <thrust/system/cuda/execution_policy.h>
#include <thrust/system/cuda/memory_resource.h>
#endif

namespace kerf {

#if THRUST_DEVICE_SYSTEM == THRUST_DEVICE_SYSTEM_CUDA

// Loops follow one another on the GPU without the host waiting for each; what a loop returns, and
// every copy, waits for those before it. Scratch space of Thrust is kept from call to call, so that
// a step allocates none.
inline auto loop_policy() {
  using Memory = thrust::cuda::memory_resource;
  using Pool =
      thrust::mr::disjoint_unsynchronized_pool_resource<Memory, thrust::mr::new_delete_resource>;
  // Never freed: at the end of the process the GPU's context may be gone before it.
  static Pool& pool = *new Pool(thrust::mr::get_global_resource<Memory>(),
                                thrust::mr::get_global_resource<thrust::mr::new_delete_resource>());
  static thrust::mr::allocator<char, Pool> allocator(&pool);
  return thrust::cuda::par_nosync(allocator);
}

// Faults of loops are thrown by the next call that returns something.
inline void wait_for_loops() noexcept {
  static_cast<void>(cudaStreamSynchronize(cudaStreamLegacy));
}

#else

inline const auto& loop_policy() {
  return thrust::device;
}
inline void wait_for_loops() noexcept {}

#endif

}  // namespace kerf
