// SPDX-License-Identifier: Apache-2.0
// The field table: every per-particle quantity is listed here once. Storage, the view that loops
// get, reordering, growth and checkpoints all follow from this list.
#pragma once

#include <cstdint>

#include "core/mirror_planes.hpp"
#include "core/tensor.hpp"
#include "exec/exec.hpp"
#include "particles/flags.hpp"
#include "particles/medium.hpp"
#include "particles/touch.hpp"

namespace kerf {

// FIELD(type, name): meaning, unit.
// State: what a checkpoint holds and a reorder moves.
#define KERF_STATE_FIELDS(FIELD)                                                         \
  FIELD(Point, position)               /* m */                                           \
  FIELD(Point, build_position)         /* m, where the neighbour list was built */       \
  FIELD(RealVector, velocity)          /* m/s */                                         \
  FIELD(Real, compression)             /* 1, rho / rho_0 - 1 */                          \
  FIELD(Real, compression_rate)        /* 1/s */                                         \
  FIELD(RealVector, last_acceleration) /* m/s^2, over the last step */                   \
  FIELD(RealVector, wall_normal)       /* 1, of a fluid's wall, towards it; 0 = none */  \
  FIELD(Real, pressure_work)           /* J/kg, done against pressure so far */          \
  FIELD(Real, inlet_speed)             /* m/s, of jet water while it is in its nozzle */ \
  FIELD(std::uint32_t, id)             /* unique, never reused */                        \
  FIELD(std::uint16_t, source)         /* medium, see simulation/levels.hpp */           \
  FIELD(std::uint8_t, fractured)       /* 1 = carries compression only */                \
  FIELD(std::uint8_t, flags)

// Scratch: filled and used within one step.
#define KERF_SCRATCH_FIELDS(FIELD)                                                   \
  FIELD(Point, start_position)             /* m, at the start of the step */         \
  FIELD(RealVector, start_velocity)        /* m/s */                                 \
  FIELD(Real, start_compression)           /* 1 */                                   \
  FIELD(Real, pressure)                    /* Pa */                                  \
  FIELD(RealVector, next_wall_normal)      /* 1, to be the wall_normal */            \
  FIELD(Real, filling)                     /* 1, sum of V W, 1 inside matter */      \
  FIELD(Real, stir)                        /* 1/s, how fast fluid neighbours pass */ \
  FIELD(RealVector, acceleration)          /* m/s^2 */                               \
  FIELD(RealVector, repulsion)             /* m/s^2, the part due to rigid bodies */ \
  FIELD(RealVector, pressure_acceleration) /* m/s^2, part by water's pressure */     \
  FIELD(RealVector, damping_acceleration)  /* m/s^2, the part that dissipates */     \
  FIELD(Real, repulsion_potential)         /* J/kg */                                \
  FIELD(Real, pressure_power)              /* W/kg, now done against pressure */     \
  FIELD(Real, artificial_power)            /* W/kg, artificial viscosity and stress */

// The same of what a run may do without: FIELD(group, type, name).
#define KERF_GROUPED_STATE_FIELDS(FIELD)                                                \
  FIELD(rate_stress, Stress, shear) /* Pa, deviatoric (solid) or viscous (water) */     \
  FIELD(touch, Real, solid_fit)     /* 1, filling by solids at which it touches them */ \
  FIELD(touch, Real, rigid_fit)     /* 1, by rigid bodies */

#define KERF_GROUPED_SCRATCH_FIELDS(FIELD)                                                    \
  FIELD(rate_stress, Stress, start_shear)          /* Pa */                                   \
  FIELD(rate_stress, Gradient, velocity_gradient)  /* 1/s, over the particle's own phase */   \
  FIELD(rate_stress, Spin, spin)                   /* 1/s, skew part of it, of solid */       \
  FIELD(rate_stress, Stress, artificial_stress)    /* m^2/s^2 per kg/m^3: R of Gray et al. */ \
  FIELD(rate_stress, Real, fracture_loss)          /* J, given up by fracture in this step */ \
  FIELD(touch, SurfaceTouch, solid_touch)          /* how it touches other solids */          \
  FIELD(touch, SurfaceTouch, rigid_touch)          /* how it touches rigid bodies */          \
  FIELD(mirrored, RealVector, mirror_acceleration) /* m/s^2, the part due to mirror images */

// Which of them there are.
struct FieldGroups {
  bool rate_stress = true;  // stress that follows from its rate (shinohara2004)
  bool touch = true;        // contact of surfaces of solids (standard)
  bool mirrored = true;     // planes of symmetry
};

template <int D, class P>
struct FieldTypes {
  using Real = typename P::Real;
  using Point = Vector<D, double>;
  using RealVector = Vector<D, Real>;
  using Stress = SymmetricTensor<D, Real>;
  using Gradient = Matrix<D, Real>;
  using Spin = SkewTensor<D, Real>;
  using SurfaceTouch = Touch<D, Real>;
};

// What a loop body gets: plain pointers.
template <int D, class P>
struct ParticleView : FieldTypes<D, P> {
  using typename FieldTypes<D, P>::Real;
  using typename FieldTypes<D, P>::Point;
  using typename FieldTypes<D, P>::RealVector;
  using typename FieldTypes<D, P>::Stress;
  using typename FieldTypes<D, P>::Gradient;
  using typename FieldTypes<D, P>::Spin;
  using typename FieldTypes<D, P>::SurfaceTouch;
#define KERF_FIELD(type, name) type* name;
#define KERF_GROUPED_FIELD(group, type, name) type* name;  // null without its group
  KERF_STATE_FIELDS(KERF_FIELD)
  KERF_SCRATCH_FIELDS(KERF_FIELD)
  KERF_GROUPED_STATE_FIELDS(KERF_GROUPED_FIELD)
  KERF_GROUPED_SCRATCH_FIELDS(KERF_GROUPED_FIELD)
#undef KERF_FIELD
#undef KERF_GROUPED_FIELD
  const Medium<Real>* media;
  MirrorPlanes<D> mirrors;

  KERF_FUNCTION const Medium<Real>& medium(Index i) const {
    return media[source[i]];
  }
  KERF_FUNCTION Real density(Index i) const {
    return medium(i).density * (Real(1) + compression[i]);
  }
  KERF_FUNCTION bool has(Index i, std::uint8_t bits) const {
    return (flags[i] & bits) != 0;
  }
  // It holds on to nothing: water, and solid that broke.
  KERF_FUNCTION bool is_fluid(Index i) const {
    return medium(i).phase == Phase::water || fractured[i] != 0;
  }
  // Its density tells its pressure, or a part of it.
  KERF_FUNCTION bool has_density(Index i) const {
    return is_fluid(i) || medium(i).excess_bulk_modulus > Real(0);
  }
  // Its motion is prescribed: a nozzle's or a clamped body's.
  KERF_FUNCTION bool is_constrained(Index i) const {
    return medium(i).constrained || has(i, flag::upstream);
  }
};

// Owns the fields, on the device of the build.
template <int D, class P>
class Particles : FieldTypes<D, P> {
 public:
  using typename FieldTypes<D, P>::Real;
  using typename FieldTypes<D, P>::Point;
  using typename FieldTypes<D, P>::RealVector;
  using typename FieldTypes<D, P>::Stress;
  using typename FieldTypes<D, P>::Gradient;
  using typename FieldTypes<D, P>::Spin;
  using typename FieldTypes<D, P>::SurfaceTouch;

#define KERF_FIELD(type, name) Array<type> name;
#define KERF_GROUPED_FIELD(group, type, name) Array<type> name;
  KERF_STATE_FIELDS(KERF_FIELD)
  KERF_SCRATCH_FIELDS(KERF_FIELD)
  KERF_GROUPED_STATE_FIELDS(KERF_GROUPED_FIELD)
  KERF_GROUPED_SCRATCH_FIELDS(KERF_GROUPED_FIELD)
#undef KERF_FIELD
#undef KERF_GROUPED_FIELD
  FieldGroups groups;  // to be set before there are particles
  Array<Medium<Real>> media;
  MirrorPlanes<D> mirrors{};

  Index size() const {
    return static_cast<Index>(id.size());
  }

  void resize(Index count) {
#define KERF_FIELD(type, name) name.resize(count);
#define KERF_GROUPED_FIELD(group, type, name) name.resize(groups.group ? count : 0);
    KERF_STATE_FIELDS(KERF_FIELD)
    KERF_SCRATCH_FIELDS(KERF_FIELD)
    KERF_GROUPED_STATE_FIELDS(KERF_GROUPED_FIELD)
    KERF_GROUPED_SCRATCH_FIELDS(KERF_GROUPED_FIELD)
#undef KERF_FIELD
#undef KERF_GROUPED_FIELD
  }

  // visit(name, array) for every field that a checkpoint holds.
  template <class Visit>
  void for_each_state(const Visit& visit) {
#define KERF_FIELD(type, name) visit(#name, name);
#define KERF_GROUPED_FIELD(group, type, name) \
  if (groups.group) visit(#name, name);
    KERF_STATE_FIELDS(KERF_FIELD)
    KERF_GROUPED_STATE_FIELDS(KERF_GROUPED_FIELD)
#undef KERF_FIELD
#undef KERF_GROUPED_FIELD
  }
  template <class Visit>
  void for_each_state(const Visit& visit) const {
#define KERF_FIELD(type, name) visit(#name, name);
#define KERF_GROUPED_FIELD(group, type, name) \
  if (groups.group) visit(#name, name);
    KERF_STATE_FIELDS(KERF_FIELD)
    KERF_GROUPED_STATE_FIELDS(KERF_GROUPED_FIELD)
#undef KERF_FIELD
#undef KERF_GROUPED_FIELD
  }

  ParticleView<D, P> view() {
    ParticleView<D, P> v;
#define KERF_FIELD(type, name) v.name = pointer(name);
#define KERF_GROUPED_FIELD(group, type, name) v.name = groups.group ? pointer(name) : nullptr;
    KERF_STATE_FIELDS(KERF_FIELD)
    KERF_SCRATCH_FIELDS(KERF_FIELD)
    KERF_GROUPED_STATE_FIELDS(KERF_GROUPED_FIELD)
    KERF_GROUPED_SCRATCH_FIELDS(KERF_GROUPED_FIELD)
#undef KERF_FIELD
#undef KERF_GROUPED_FIELD
    v.media = pointer(media);
    v.mirrors = mirrors;
    return v;
  }

  std::size_t bytes_per_particle() const {
    std::size_t bytes = 0;
#define KERF_FIELD(type, name) bytes += sizeof(type);
#define KERF_GROUPED_FIELD(group, type, name) bytes += groups.group ? sizeof(type) : 0;
    KERF_STATE_FIELDS(KERF_FIELD)
    KERF_SCRATCH_FIELDS(KERF_FIELD)
    KERF_GROUPED_STATE_FIELDS(KERF_GROUPED_FIELD)
    KERF_GROUPED_SCRATCH_FIELDS(KERF_GROUPED_FIELD)
#undef KERF_FIELD
#undef KERF_GROUPED_FIELD
    return bytes;
  }
};

}  // namespace kerf
