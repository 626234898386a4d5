// SPDX-License-Identifier: Apache-2.0
// Loop bodies that look at no other particle than their own, one after the other on each: one pass
// through memory serves them all.
#pragma once

#include "exec/host_device.hpp"

namespace kerf {

template <class... Bodies>
struct InTurn : Bodies... {
  explicit InTurn(const Bodies&... bodies) : Bodies(bodies)... {}

  template <class Index>
  KERF_FUNCTION void operator()(Index i) const {
    (static_cast<const Bodies&>(*this)(i), ...);
  }
};

// Does nothing.
struct Idle {
  template <class Index>
  KERF_FUNCTION void operator()(Index) const {}
};

}  // namespace kerf
