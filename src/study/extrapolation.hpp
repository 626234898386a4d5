// SPDX-License-Identifier: Apache-2.0
// Richardson's extrapolation (Phil. Trans. R. Soc. A 210 (1911) 307, there for errors with the
// square) of a value whose error goes with the spacing:  v_0 = v(d) + [v(d) - v(r d)] / (r - 1).
#pragma once

namespace kerf {

// `fine` at a spacing d, `coarse` at r d with `ratio` = r > 1; the value for spacing 0.
inline double at_zero_spacing(double fine, double coarse, double ratio) {
  return fine + (fine - coarse) / (ratio - 1.0);
}

}  // namespace kerf
