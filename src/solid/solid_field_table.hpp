// SPDX-License-Identifier: Apache-2.0
// The fields of the total Lagrangian solid with one entry per particle, as lists from which
// solid/solid_fields.hpp makes its views, its memory and its archive.
#pragma once

// Fields with one entry per particle that are not given at set-up. FIELD(type, name): meaning.
#define KERF_SOLID_RESULTS(FIELD)                                                              \
  FIELD(std::uint8_t, detached)         /* 1: has no bonds, carries no stress */               \
  FIELD(std::uint8_t, has_broken_bonds) /* 1: has lost bonds */                                \
  FIELD(std::uint8_t, changed)          /* 1: its correction is outdated */                    \
  FIELD(std::uint8_t, multi_material)   /* 1: has bonds to other media, or to images */        \
  FIELD(std::uint8_t, several_bodies)   /* 1: has bonds to other bodies, or to images */       \
  FIELD(std::uint8_t, unlike_media)     /* bits of unlike_media.hpp: beside which it is */     \
  FIELD(std::uint8_t, held)             /* 1: by a clamp, hold_clamped.hpp */                  \
  FIELD(std::uint8_t, asleep)           /* 1: undeformed, at rest and not computed */          \
  FIELD(std::uint8_t, strained)         /* 1: one of its bonds may break */                    \
  FIELD(Real, stretch)                  /* largest lambda^2 - 1 of its bonds, if they break */ \
  FIELD(Packed, ends)                   /* displacement, velocity, traction and others */      \
  FIELD(Correction, correction)         /* B_i / V_i, 1/m^D */                                 \
  FIELD(Tensor, gradient)               /* H = F - 1 */                                        \
  FIELD(Real, elastic_share)            /* s of limit_break_energy.hpp, 1 without breaks */    \
  FIELD(Real, criterion)                /* of the fracture criterion */                        \
  FIELD(Speed, acceleration)            /* m/s^2 */                                            \
  FIELD(Real, viscous_power)            /* W, dissipated by the bond viscosity */
// Those that only solids beside planes of symmetry have.
#define KERF_SOLID_MIRRORED(FIELD) \
  FIELD(Speed, mirror_acceleration) /* m/s^2, the part due to mirror images */
// Those that only solids have of which some part softens (fracture/softening.hpp).
#define KERF_SOLID_SOFTENING(FIELD)                                 \
  FIELD(Real, strain_start)     /* k at the start of the step, 1 */ \
  FIELD(Real, current_strain)   /* at the current deformation */    \
  FIELD(double, softening_loss) /* of hourglass control in the last step, J */
// Those that only solids have of which some part has a strength that depends on the rate of strain.
#define KERF_SOLID_RATE(FIELD)                                      \
  FIELD(LoadingState, loading_start) /* at the start of the step */ \
  FIELD(LoadingState, loading_now)   /* at the current deformation */
// Those that only solids have of which some part flows.
#define KERF_SOLID_FLOW(FIELD)                                                   \
  FIELD(State, flow_start)         /* at the start of the step */                \
  FIELD(State, current_flow)       /* at the current deformation */              \
  FIELD(Tensor, rate_traction)     /* of hourglass_viscosity.hpp, Pa */          \
  FIELD(Real, hourglass_viscosity) /* eta, Pa s */                               \
  FIELD(Real, flow_work)           /* plastic work of the current step, J/m^3 */ \
  FIELD(double, flow_loss)         /* dissipated in the last step, J (2D: J/m) */
// Those that only solids have of which some part has flaws.
#define KERF_SOLID_FLAWS(FIELD)                                \
  FIELD(Flaws, flaws)        /* cracks that grow from flaws */ \
  FIELD(double, damage_loss) /* set free in the last step, J (2D: J/m) */
#define KERF_SOLID_FIELDS(FIELD) \
  KERF_SOLID_RESULTS(FIELD)      \
  KERF_SOLID_MIRRORED(FIELD)     \
  KERF_SOLID_SOFTENING(FIELD)    \
  KERF_SOLID_RATE(FIELD)         \
  KERF_SOLID_FLOW(FIELD)         \
  KERF_SOLID_FLAWS(FIELD)
