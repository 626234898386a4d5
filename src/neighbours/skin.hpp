// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace kerf {

// How much farther than they reach particles list their neighbours, in the finest spacings. A
// shorter one asks for more searches, a longer one for more to walk over: in 3D it is the third
// power of the reach that counts.
constexpr double list_skin(int dimension) {
  return dimension == 3 ? 0.22 : 0.35;
}

}  // namespace kerf
