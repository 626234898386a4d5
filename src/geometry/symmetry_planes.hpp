// SPDX-License-Identifier: Apache-2.0
// The faces of a domain that mirror what it holds.
#pragma once

#include "model/shape.hpp"

namespace kerf {

struct SymmetryPlanes {
  Faces planes;
  Box domain;
};

}  // namespace kerf
