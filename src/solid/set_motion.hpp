// SPDX-License-Identifier: Apache-2.0
// TakeMotion sets the positions and velocities of the particles of a solid in their packed bond
// ends.
#pragma once

#include "solid/solid_fields.hpp"

namespace kerf {

// Sets the displacement u = x - X in two parts (solid/simd/packed_bonds.hpp).
template <int D, class P>
KERF_FUNCTION void set_displacement(const SolidView<D, P>& solid, Index i,
                                    const Vector<D, double>& position) {
  using Real = typename P::Real;
  const Vector<D, double> displacement = position - solid.reference[i];
  for (int a = 0; a < D; ++a) {
    Real rounded = static_cast<Real>(displacement[a]);
#if defined(__GNUC__) && !defined(__CUDA_ARCH__)
    asm("" : "+m"(rounded));  // g++ 12 with -O3 takes the remainder for zero otherwise
#endif
    solid.ends[i].displacement[a] = rounded;
    solid.ends[i].remainder[a] = static_cast<Real>(displacement[a] - static_cast<double>(rounded));
  }
}

// Positions and velocities from arrays in the order of the solid; either may be null.
template <int D, class P>
struct MotionInOrder {
  using Real = typename P::Real;
  const Vector<D, double>* position;
  const Vector<D, Real>* velocity;

  KERF_FUNCTION void take(const SolidView<D, P>& solid, Index i) const {
    if (position != nullptr) set_displacement(solid, i, position[i]);
    if (velocity != nullptr) solid.ends[i].velocity = velocity[i];
  }
};

template <int D, class P, class Motion>
struct TakeMotion {
  SolidView<D, P> solid;
  Motion motion;
  KERF_FUNCTION void operator()(Index i) const { motion.take(solid, i); }
};

}  // namespace kerf
