// SPDX-License-Identifier: Apache-2.0
// Precision is a type: positions are always double, so that differences of close particles stay
// exact; every other field and all pair arithmetic is `Real`.
#pragma once

namespace kerf {

struct Mixed {
  using Real = float;
  static constexpr const char* name = "mixed";
};

struct Double {
  using Real = double;
  static constexpr const char* name = "double";
};

}  // namespace kerf
