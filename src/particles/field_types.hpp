// SPDX-License-Identifier: Apache-2.0
// The types of the fields of particles/fields.hpp.
#pragma once

#include "core/tensor.hpp"
#include "parallel/threads.hpp"

namespace kerf {

// Which particles are ghosts: copies of particles of other ranks that act on those of this one
// (distributed/domain_decomposition.hpp).
struct Ghosts {
  Index first = 0, count = 0;

  KERF_FUNCTION bool has(Index i) const { return i - first < count; }
};

// Contact of a particle of a solid with other bodies (contact/surface_contact.hpp).
template <int D, class T>
struct ContactState {
  T force;              // J, derivative of its energy by the kernel sum phi; 0: no contact
  T energy;             // J
  T slope;              // 1/m, |grad phi|
  Vector<D, T> normal;  // into the other body

  KERF_FUNCTION static ContactState none() { return {T(0), T(0), T(0), Vector<D, T>::zero()}; }
};

// What the sums over the rigid walls beside a fluid particle tell (fluid/smooth_wall.hpp).
template <int D, class T>
struct SmoothWall {
  Vector<D, T> normal;                  // 1, into the fluid; 0: none, an edge or a corner
  T force_excess, volume_excess, room;  // 1
  T centripetal;                        // m/s^2
  bool is_corner, is_edge;

  KERF_FUNCTION static SmoothWall none() {
    return {Vector<D, T>::zero(), T(0), T(0), T(0), T(0), false, false};
  }
};

// What the gradient along a smooth wall adds to a fluid particle, of which the wall takes the
// reaction (fluid/wall_reaction.hpp).
template <int D, class T>
struct WallPush {
  Vector<D, T> acceleration;  // m/s^2
  T inverse_weight;           // m, of the faces beside the particle

  KERF_FUNCTION static WallPush none() { return {Vector<D, T>::zero(), T(0)}; }
};

// The power per unit of mass at which rigid bodies that move work on a particle, W/kg: by pressure,
// by dissipative forces, and by the contact of solids or the repulsion of eq. (43).
template <class T>
struct RigidPower {
  T pressure, dissipation, contact;

  KERF_FUNCTION T total() const { return pressure + dissipation + contact; }
};

template <int D, class P>
struct FieldTypes {
  using Real = typename P::Real;
  using Point = Vector<D, double>;
  using RealVector = Vector<D, Real>;
  using Stress = SymmetricTensor<D, Real>;
  using Gradient = Matrix<D, Real>;
  using Spin = SkewTensor<D, Real>;
  using SurfaceContactState = ContactState<D, Real>;
  using SmoothWallState = SmoothWall<D, Real>;
  using WallPushState = WallPush<D, Real>;
  using RigidPowerState = RigidPower<Real>;
};

}  // namespace kerf
