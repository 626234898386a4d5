// SPDX-License-Identifier: Apache-2.0
// A fused kernel applies several loop bodies to each particle, one after the other, in one pass
// through memory. The bodies must not read other particles.
#pragma once

#include "core/host_device.hpp"

namespace kerf {

template <class... Bodies>
struct FusedKernel : Bodies... {
  explicit FusedKernel(const Bodies&... bodies) : Bodies(bodies)... {}

  template <class Index>
  KERF_FUNCTION void operator()(Index i) const {
    (static_cast<const Bodies&>(*this)(i), ...);
  }
};

// Does nothing.
struct NoOp {
  template <class Index>
  KERF_FUNCTION void operator()(Index) const {}
};

}  // namespace kerf
