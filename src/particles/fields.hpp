// SPDX-License-Identifier: Apache-2.0
// The table of particle fields: each quantity that a particle has is one row here. Storage, the
// view that loops get, the value of new particles, reordering, checkpoints and the columns of
// frames follow from the rows.
#pragma once

#include <cstdint>
#include <type_traits>
#include <vector>

#include "core/mirror_planes.hpp"
#include "model/medium.hpp"
#include "parallel/loops.hpp"
#include "particles/field_types.hpp"
#include "particles/new_particle.hpp"
#include "particles/particle_groups.hpp"
#include "particles/shown.hpp"

namespace kerf {

// STATE(type, name, initial, group, shown) is a field that checkpoints hold and reordering moves;
// PAIRED, with the same arguments, is one that also changes within a step and that pair loops read
// of neighbours, so that ghosts get it anew (distributed/domain_decomposition.hpp);
// SCRATCH(type, name, group, shown) is one that is filled and used within one step.
//   type     one of FieldTypes, or a plain integer
//   initial  its value for a particle that joins the run, from `start` (NewParticle) and `medium`
//            (Medium<double>)
//   group    the runs that have the field (FieldGroups); `always` = all of them
//   shown    hidden, or shown<Value>(column, label, unit): the column of frames
//   (particles/shown.hpp)
// The pressure work, J/kg, is what was done against pressure so far.
// clang-format off
#define KERF_PARTICLE_FIELDS(STATE, PAIRED, SCRATCH)                                               \
  PAIRED(Point, position, Point::from(start.position), always, hidden) /* m */                      \
  STATE(Point, build_position, Point::from(start.position), always, hidden) /* m, when listed */   \
  PAIRED(RealVector, velocity, RealVector::from(start.velocity), always, hidden) /* m/s */          \
  PAIRED(Real, compression, medium.initial_compression, always, hidden) /* 1, rho/rho_0 - 1 */      \
  STATE(Real, compression_rate, 0, always, hidden)                   /* 1/s */                     \
  STATE(RealVector, conservative_acceleration, RealVector(), always, hidden)                       \
  /* m/s^2, of the last step, without damping_acceleration */                                      \
  PAIRED(RealVector, wall_normal, RealVector(), always, hidden)       /* 1, to a wall; 0 = none */  \
  PAIRED(RealVector, face_normal, RealVector::from(start.face_normal), smooth_walls, hidden)       \
  /* 1, of a wall particle: of the face nearest to it; of fluid: of the smooth wall beside it */   \
  PAIRED(Real, face_depth, start.face_depth, smooth_walls, hidden) /* m, of a wall particle */     \
  PAIRED(RealVector, face_corner, RealVector::from(start.face_corner), smooth_walls, hidden) /* 1, fluid/seen_face.hpp */  \
  PAIRED(Real, face_growth, 0, smooth_walls, hidden) /* 1, of its width along the surface */      \
  STATE(RealVector, face_at_rest, RealVector::from(start.face()), smooth_walls, hidden) /* 1/m, normal over depth, */ \
  STATE(RealVector, corner_at_rest, RealVector::from(start.face_corner), smooth_walls, hidden) /* before a solid deforms */ \
  PAIRED(Real, wall_force_excess, 0, smooth_walls, hidden) /* 1, of fluid beside a smooth wall: */ \
  STATE(Real, wall_volume_excess, 0, smooth_walls, hidden) /* 1, fluid/smooth_wall.hpp */          \
  PAIRED(Real, wall_room, 0, smooth_walls, hidden)         /* 1 */                                 \
  PAIRED(Real, wall_centripetal, 0, smooth_walls, hidden)  /* m/s^2 */                             \
  STATE(Real, pressure_work, medium.tait.energy(medium, medium.initial_compression), always, hidden)     \
  STATE(std::uint32_t, inlet_column, start.inlet_column, always, hidden) /* of its nozzle */       \
  STATE(std::uint32_t, id, start.id, always, hidden)                 /* unique, never reused */    \
  STATE(Index, sorted_cell, unsorted, always, hidden)                /* when they were sorted */   \
  STATE(std::uint16_t, source, start.source, always, hidden)         /* simulation/media_order.hpp */   \
  PAIRED(std::uint8_t, fractured, 0, always, hidden) /* 1 = bears compression only */              \
  PAIRED(std::uint8_t, undamaged, medium.tensile_excess > 0.0, contact, hidden)                    \
  /* 1 = nearly incompressible solid whose density bears tension */                                \
  PAIRED(std::uint8_t, flags, start.flags, always, hidden) /* particles/new_particle.hpp */         \
  STATE(std::uint8_t, asleep, 0, sleep, hidden) /* 1 = solid at rest that is not computed */        \
  STATE(std::uint8_t, moving, medium.phase == Phase::water, sleep, hidden) /* standard/sleep.hpp */ \
  STATE(std::uint8_t, reached, medium.phase == Phase::water, sleep, hidden) /* the same */          \
  STATE(Stress, shear, Stress(), rate_stress,                                                      \
        shown<AsStored>("deviatoric_stress", "deviatoric stress", "Pa")) /* viscous in water */    \
  STATE(Real, solid_initial_overlap, 1, contact, hidden) /* 1, kernel sum over solids */           \
  STATE(Real, rigid_initial_overlap, 1, contact, hidden)             /* 1, over rigid bodies */    \
  STATE(Real, contact_energy, 0, contact, hidden) /* J/kg, that ends with the contacts of solid */ \
  SCRATCH(Point, start_position, always, hidden)                 /* m, at the start of the step */ \
  SCRATCH(RealVector, start_velocity, always, hidden)            /* m/s */                         \
  SCRATCH(Real, start_compression, always, hidden)               /* 1 */                           \
  SCRATCH(Real, pressure, always, hidden)                        /* Pa */                          \
  SCRATCH(RealVector, next_wall_normal, always, hidden)          /* 1, the next wall_normal */     \
  SCRATCH(SmoothWallState, next_smooth_wall, smooth_walls, hidden) /* of fluid, the next one */    \
  SCRATCH(WallPushState, wall_push, smooth_walls, hidden) /* fluid/gradient_at_wall.hpp */         \
  SCRATCH(Real, kernel_sum, always, hidden) /* 1, sum of V W; 1 inside matter */                   \
  SCRATCH(Real, max_relative_velocity, always, hidden)           /* 1/s, of fluid neighbours */    \
  SCRATCH(RealVector, acceleration, always, hidden)              /* m/s^2 */                       \
  SCRATCH(RealVector, repulsion, always, hidden)                 /* m/s^2, by rigid bodies */      \
  SCRATCH(RealVector, pressure_acceleration, always, hidden)     /* m/s^2, by water pressure */    \
  SCRATCH(RealVector, damping_acceleration, always, hidden) /* m/s^2, by dissipative forces */     \
  SCRATCH(Real, repulsion_potential, always, hidden)             /* J/kg */                        \
  SCRATCH(Real, pressure_power, always, hidden)                  /* W/kg, done against pressure */ \
  SCRATCH(RigidPowerState, rigid_power, moving_walls, hidden)    /* W/kg, by rigid bodies */       \
  SCRATCH(Real, continuity_loss, density_losses, hidden)         /* J/kg, in the step */           \
  SCRATCH(Real, reinitialisation_loss, density_losses, hidden)   /* J/kg, in the step */           \
  SCRATCH(Real, artificial_power, rate_stress, hidden)           /* W/kg, by artificial terms */   \
  SCRATCH(Stress, start_shear, rate_stress, hidden)              /* Pa */                          \
  SCRATCH(Gradient, velocity_gradient, rate_stress, hidden)      /* 1/s, over the own phase */     \
  SCRATCH(Spin, spin, rate_stress, hidden) /* 1/s, its skew part, of solids */                     \
  SCRATCH(Stress, artificial_stress, rate_stress, hidden) /* m^5/(kg s^2), R of Gray et al. */     \
  SCRATCH(Real, fracture_loss, rate_stress, hidden)              /* J, released by fracture */     \
  SCRATCH(SurfaceContactState, solid_contact, contact, hidden)   /* with other solids */           \
  SCRATCH(SurfaceContactState, rigid_contact, contact, hidden)   /* with rigid bodies */           \
  SCRATCH(RealVector, mirror_acceleration, mirrored, hidden)     /* m/s^2, by mirror images */
// clang-format on

// The groups of fields that a run has.
struct FieldGroups {
  static constexpr bool always = true;
  bool rate_stress = true;     // stress that follows from its rate (shinohara2004)
  bool contact = true;         // contact of the surfaces of solids (standard)
  bool mirrored = true;        // symmetry planes
  bool density_losses = true;  // energy that the density loses (standard)
  bool smooth_walls = true;    // smooth walls of bodies (standard)
  bool sleep = false;          // solid at rest may sleep (standard)
  bool moving_walls = false;   // rigid bodies that move
};

// The row of a field, for visitors of the fields.
enum class FieldKind { state, paired, scratch };
template <FieldKind kind>
struct FieldRow {
  static constexpr bool is_state = kind != FieldKind::scratch;
  static constexpr bool is_paired = kind == FieldKind::paired;
  const char* name;
};

// The view of the particles that loop bodies get: plain pointers.
template <int D, class P>
struct ParticleView : FieldTypes<D, P> {
  using typename FieldTypes<D, P>::Real;
  using typename FieldTypes<D, P>::Point;
  using typename FieldTypes<D, P>::RealVector;
  using typename FieldTypes<D, P>::Stress;
  using typename FieldTypes<D, P>::Gradient;
  using typename FieldTypes<D, P>::Spin;
  using typename FieldTypes<D, P>::SurfaceContactState;
  using typename FieldTypes<D, P>::SmoothWallState;
  using typename FieldTypes<D, P>::WallPushState;
  using typename FieldTypes<D, P>::RigidPowerState;
#define KERF_STATE(type, name, initial, group, shown) type* name;  // null without its group
#define KERF_SCRATCH(type, name, group, shown) type* name;
  KERF_PARTICLE_FIELDS(KERF_STATE, KERF_STATE, KERF_SCRATCH)
#undef KERF_STATE
#undef KERF_SCRATCH
  const Medium<Real>* media;
  MirrorPlanes<D> mirrors;
  Ghosts ghosts;

  KERF_FUNCTION const Medium<Real>& medium(Index i) const {
    return media[source[i]];
  }
  KERF_FUNCTION Real density(Index i) const {
    return medium(i).density * (Real(1) + compression[i]);
  }
  KERF_FUNCTION bool has(Index i, std::uint8_t bits) const {
    return (flags[i] & bits) != 0;
  }
  KERF_FUNCTION bool is_asleep(Index i) const {
    return asleep != nullptr && asleep[i] != 0;
  }
  // Whether a particle carries no shear: water, and solid that has broken.
  KERF_FUNCTION bool is_fluid(Index i) const {
    return medium(i).phase == Phase::water || fractured[i] != 0;
  }
  // Whether its density determines its pressure, or a part of it.
  KERF_FUNCTION bool has_density(Index i) const {
    return is_fluid(i) || medium(i).excess_bulk_modulus > Real(0);
  }
  // Whether its density bears tension: that of nearly incompressible solid until it is damaged.
  KERF_FUNCTION bool bears_tension(Index i) const {
    return undamaged != nullptr && undamaged[i] != 0 && fractured[i] == 0;
  }
  // Whether its motion is prescribed, by a nozzle or as that of a body.
  KERF_FUNCTION bool is_constrained(Index i) const {
    return medium(i).constrained || has(i, flag::upstream);
  }
};

// The particles of a run: the owner of the fields, on the device of the build.
template <int D, class P>
class Particles : FieldTypes<D, P> {
 public:
  using typename FieldTypes<D, P>::Real;
  using typename FieldTypes<D, P>::Point;
  using typename FieldTypes<D, P>::RealVector;
  using typename FieldTypes<D, P>::Stress;
  using typename FieldTypes<D, P>::Gradient;
  using typename FieldTypes<D, P>::Spin;
  using typename FieldTypes<D, P>::SurfaceContactState;
  using typename FieldTypes<D, P>::SmoothWallState;
  using typename FieldTypes<D, P>::WallPushState;
  using typename FieldTypes<D, P>::RigidPowerState;

#define KERF_STATE(type, name, initial, group, shown) Array<type> name;
#define KERF_SCRATCH(type, name, group, shown) Array<type> name;
  KERF_PARTICLE_FIELDS(KERF_STATE, KERF_STATE, KERF_SCRATCH)
#undef KERF_STATE
#undef KERF_SCRATCH
  FieldGroups groups;  // to be set before there are particles
  ParticleGroups sum_groups;
  Array<Medium<Real>> media;
  MirrorPlanes<D> mirrors{};
  Ghosts ghosts;  // particles of other ranks

  Index size() const {
    return static_cast<Index>(id.size());
  }
  // How many are not ghosts; what has joined since the ghosts came follows after them.
  Index owned() const {
    return size() - ghosts.count;
  }

  // Calls visit(row, array, shown) for every field that the groups of the run have.
  template <class Visit>
  void for_each_field(const Visit& visit) {
    visit_fields(*this, visit);
  }
  template <class Visit>
  void for_each_field(const Visit& visit) const {
    visit_fields(*this, visit);
  }
  // Calls visit(name, array) for every field that a checkpoint holds.
  template <class Visit>
  void for_each_state(const Visit& visit) {
    for_each_field([&](const auto& row, auto& field, const auto&) {
      if constexpr (std::decay_t<decltype(row)>::is_state) visit(row.name, field);
    });
  }
  template <class Visit>
  void for_each_state(const Visit& visit) const {
    for_each_field([&](const auto& row, const auto& field, const auto&) {
      if constexpr (std::decay_t<decltype(row)>::is_state) visit(row.name, field);
    });
  }

  void resize(Index count) {
    for_each_field([&](const auto&, auto& field, const auto&) { field.resize(count); });
  }

  // Adds particles with the initial values of the table. `of_source`: the media in double
  // precision.
  void append(const std::vector<NewParticle>& newcomers,
              const std::vector<Medium<double>>& of_source) {
    const Index before = size();
    resize(before + static_cast<Index>(newcomers.size()));
    const auto fill = [&](auto& field, const auto& initial_value) {
      std::vector<typename std::decay_t<decltype(field)>::value_type> values;
      for (const NewParticle& start : newcomers)
        values.push_back(initial_value(start, of_source[start.source]));
      if (!values.empty()) thrust::copy(values.begin(), values.end(), field.begin() + before);
    };
#define KERF_STATE(type, name, initial, group, shown)              \
  if (groups.group)                                                \
    fill(name, []([[maybe_unused]] const NewParticle& start,       \
                  [[maybe_unused]] const Medium<double>& medium) { \
      return static_cast<type>(initial);                           \
    });
#define KERF_SCRATCH(type, name, group, shown)
    KERF_PARTICLE_FIELDS(KERF_STATE, KERF_STATE, KERF_SCRATCH)
#undef KERF_STATE
#undef KERF_SCRATCH
    regroup();
  }

  // Must be called when `sorted_cell` or the order of the particles has changed.
  void regroup() {
    sum_groups.find(sorted_cell, owned());
  }

  ParticleView<D, P> view() {
    ParticleView<D, P> v;
#define KERF_STATE(type, name, initial, group, shown) KERF_SCRATCH(type, name, group, shown)
#define KERF_SCRATCH(type, name, group, shown) v.name = groups.group ? pointer(name) : nullptr;
    KERF_PARTICLE_FIELDS(KERF_STATE, KERF_STATE, KERF_SCRATCH)
#undef KERF_STATE
#undef KERF_SCRATCH
    v.media = pointer(media);
    v.mirrors = mirrors;
    v.ghosts = ghosts;
    return v;
  }

  std::size_t bytes_per_particle() const {
    std::size_t bytes = 0;
    for_each_field([&](const auto&, const auto& field, const auto&) {
      bytes += sizeof(typename std::decay_t<decltype(field)>::value_type);
    });
    return bytes;
  }

 private:
  template <class Self, class Visit>
  static void visit_fields(Self& self, const Visit& visit) {
#define KERF_ROW(kind, name, shown, group) \
  if (self.groups.group) visit(FieldRow<FieldKind::kind>{#name}, self.name, shown);
#define KERF_STATE(type, name, initial, group, shown) KERF_ROW(state, name, shown, group)
#define KERF_PAIRED(type, name, initial, group, shown) KERF_ROW(paired, name, shown, group)
#define KERF_SCRATCH(type, name, group, shown) KERF_ROW(scratch, name, shown, group)
    KERF_PARTICLE_FIELDS(KERF_STATE, KERF_PAIRED, KERF_SCRATCH)
#undef KERF_ROW
#undef KERF_STATE
#undef KERF_PAIRED
#undef KERF_SCRATCH
  }
};

}  // namespace kerf
