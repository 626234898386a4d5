// SPDX-License-Identifier: Apache-2.0
// Lane is one of the threads that share a body of a loop: each takes every `count`-th item.
#pragma once

#include <cstdint>

namespace kerf {

struct Lane {
  std::uint32_t number = 0, count = 1;
};

}  // namespace kerf
