// SPDX-License-Identifier: Apache-2.0
// What the total Lagrangian solid keeps per particle and per bond. State: the weights, `loose`,
// `strain_start`, `flow_start` and `flaws`; all else follows from these and from where the
// particles are.
#pragma once

#include <type_traits>

#include "core/matrix.hpp"
#include "core/mirror_planes.hpp"
#include "core/precision.hpp"
#include "exec/exec.hpp"
#include "fracture/grady_kipp.hpp"
#include "materials/plastic_law.hpp"
#include "solid/solid_medium.hpp"

namespace kerf {

// Fields with one entry per particle that are not given at set-up. FIELD(type, name): meaning.
#define KERF_SOLID_RESULTS(FIELD)                                                   \
  FIELD(std::uint8_t, loose)        /* 1: holds on to nothing, carries no stress */ \
  FIELD(std::uint8_t, torn)         /* 1: has lost bonds */                         \
  FIELD(std::uint8_t, changed)      /* 1: its correction is outdated */             \
  FIELD(std::uint8_t, mixed)        /* 1: has bonds to other media, or to images */ \
  FIELD(std::uint8_t, strained)     /* 1: one of its bonds may break */             \
  FIELD(Real, stretch)              /* largest lambda^2 - 1 of its bonds */         \
  FIELD(Place, displacement)        /* u = x - X, m */                              \
  FIELD(Tensor, correction)         /* B_i / V_i, 1/m^D */                          \
  FIELD(Tensor, gradient)           /* H = F - 1 */                                 \
  FIELD(Tensor, traction)           /* A = (P B) - mu H, Pa; see deform.hpp */      \
  FIELD(Real, hourglass)            /* mu, Pa; see hourglass_modulus.hpp */         \
  FIELD(Real, criterion)            /* of the fracture criterion */                 \
  FIELD(Speed, acceleration)        /* m/s^2 */                                     \
  FIELD(Speed, mirror_acceleration) /* m/s^2, the part due to mirror images */      \
  FIELD(Real, viscous_power)        /* W, dissipated by the bond viscosity */       \
  FIELD(double, elastic_energy)     /* J (2D: J/m) */                               \
  FIELD(double, hourglass_energy)   /* J (2D: J/m) */
// Those that only solids have of which some part softens (fracture/softening.hpp).
#define KERF_SOLID_SOFTENING(FIELD)                                 \
  FIELD(Real, strain_start)     /* k at the start of the step, 1 */ \
  FIELD(Real, strain_now)       /* at the deformation in force */   \
  FIELD(double, softening_loss) /* of hourglass control in the last step, J */
// Those that only solids have of which some part flows.
#define KERF_SOLID_FLOW(FIELD)                                                   \
  FIELD(State, flow_start)         /* at the start of the step */                \
  FIELD(State, flow_now)           /* at the deformation in force */             \
  FIELD(Tensor, rate_traction)     /* of hourglass_viscosity.hpp, Pa */          \
  FIELD(Real, hourglass_viscosity) /* eta, Pa s */                               \
  FIELD(Real, flow_work)           /* plastic work of the step in hand, J/m^3 */ \
  FIELD(double, flow_loss)         /* dissipated in the last step, J (2D: J/m) */

// Those that only solids have of which some part has flaws.
#define KERF_SOLID_FLAWS(FIELD)                                \
  FIELD(Flaws, flaws)        /* cracks that grow from flaws */ \
  FIELD(double, damage_loss) /* set free in the last step, J (2D: J/m) */

// Every pair i, j of one piece that is closer than 2 h in the reference configuration is a bond. It
// stands in the lists of both, with one weight,
//   w_ij = f_ij V_i V_j |W'(R_ij)| / R_ij,   R_ij = |X_i - X_j|,   in m (2D: 1),
// in which f_ij is the share of the bond that is whole: 1 (where the spacing jumps the s_ij of
// fit_levels.hpp), or 0 where it broke. A weight is all that the sums need, since V_i V_j grad_0
// W_ij = w_ij (X_j - X_i): gradients cost no memory. A bond to a mirror image
// (core/mirror_planes.hpp) stands in the lists of both particles too, or once in that of a particle
// that is bound to its own image.
struct BondEnd {
  Index particle;     // j
  MirrorCode mirror;  // 0: j itself, else its image
};
// The same where it is known that j itself is meant: all that mirrors do is then left out.
struct DirectEnd {
  Index particle;
  static constexpr MirrorCode mirror = 0;
};

template <int D, class P>
struct SolidView {
  using Real = typename P::Real;
  using Place = Vector<D, double>;
  using Speed = Vector<D, Real>;
  using Tensor = Matrix<D, Real>;
  using State = PlasticState<D, Real>;
  using Flaws = FlawState<Real>;

  Index count;
  bool any_flows;    // whether there is a medium that flows
  bool any_softens;  // or softens
  bool any_flaws;    // or has flaws
  const SolidMedium<Real>* media;
  const PlasticParameters<Real>* plastic;  // per medium
  const GradyKipp<Real>* flaw_law;         // per medium
  const std::uint16_t* medium_index;
  const Place* reference;   // X, m
  const Index* bond_begin;  // bonds of i: bond_begin[i] .. bond_begin[i + 1]
  const Index* neighbour;   // with a mirror code in the highest bits
  Real* weight;             // w_ij
  // s of fit_levels.hpp, per bond; null: 1.
  const Real *bond_fit, *pair_fit;
  MirrorPlanes<D> mirrors;
#define KERF_FIELD(type, name) type* name;
  KERF_SOLID_RESULTS(KERF_FIELD)
  KERF_SOLID_SOFTENING(KERF_FIELD)
  KERF_SOLID_FLOW(KERF_FIELD)
  KERF_SOLID_FLAWS(KERF_FIELD)
#undef KERF_FIELD

  KERF_FUNCTION const SolidMedium<Real>& medium(Index i) const {
    return media[medium_index[i]];
  }
  KERF_FUNCTION const PlasticParameters<Real>& plasticity(Index i) const {
    return plastic[medium_index[i]];
  }
  KERF_FUNCTION bool flows(Index i) const {
    return any_flows && plasticity(i).flows();
  }
  KERF_FUNCTION bool softens(Index i) const {
    return any_softens && medium(i).softens();
  }
  KERF_FUNCTION bool has_flaws(Index i) const {
    return any_flaws && flaw_law[medium_index[i]].is_on();
  }
  // Damage of a particle, by which its tension is less.
  KERF_FUNCTION Real damage(Index i) const {
    return any_flaws ? flaws[i].damage : Real(0);
  }
  template <class End = BondEnd>
  KERF_FUNCTION End bond_end(Index k) const {
    if constexpr (std::is_same_v<End, DirectEnd>)
      return {neighbour[k]};
    else
      return {mirrors.place(neighbour[k]), mirrors.code(neighbour[k])};
  }
  // Of particle i, the first bond that is one to a mirror image; the end of its bonds for none.
  KERF_FUNCTION Index first_image(Index i) const {
    Index k = bond_begin[i + 1];
    if (mirrors.faces != 0)
      while (k > bond_begin[i] && mirrors.code(neighbour[k - 1]) != 0) --k;
    return k;
  }
  // X_j - X_i, m.
  template <class T = Real, class End>
  KERF_FUNCTION Vector<D, T> reference_bond(Index i, const End& j) const {
    const auto& x = reference[i];
    const auto& y = reference[j.particle];
    if (j.mirror == 0) return Vector<D, T>::from(y - x);
    return T(-1) * Vector<D, T>::from(mirrors.separation(j.mirror, x, y));
  }
  // u_j - u_i, m: differences in double, so that a body far from home loses no digits.
  template <class T = Real, class End>
  KERF_FUNCTION Vector<D, T> displacement_bond(Index i, const End& j) const {
    return Vector<D, T>::from(of(j, displacement) - displacement[i]);
  }
  // A vector or tensor of particle j as particle i sees it: of its image, where it is one.
  template <class T, class End>
  KERF_FUNCTION T of(const End& j, const T* values) const {
    return MirrorPlanes<D>::image(j.mirror, values[j.particle]);
  }
};

template <int D, class P>
struct SolidFields {
  using View = SolidView<D, P>;
  using Real = typename P::Real;
  using Place = typename View::Place;
  using Speed = typename View::Speed;
  using Tensor = typename View::Tensor;
  using State = typename View::State;
  using Flaws = typename View::Flaws;

  bool any_flows = false, any_softens = false, any_flaws = false;
  Array<SolidMedium<Real>> media;
  Array<PlasticParameters<Real>> plastic;
  Array<GradyKipp<Real>> flaw_law;
  Array<std::uint16_t> medium_index;
  Array<Place> reference;
  Array<Index> bond_begin, neighbour;
  MirrorPlanes<D> mirrors{};
  Array<Real> weight, bond_fit, pair_fit;
#define KERF_FIELD(type, name) Array<type> name;
  KERF_SOLID_RESULTS(KERF_FIELD)
  KERF_SOLID_SOFTENING(KERF_FIELD)
  KERF_SOLID_FLOW(KERF_FIELD)
  KERF_SOLID_FLAWS(KERF_FIELD)
#undef KERF_FIELD

  Index size() const {
    return static_cast<Index>(reference.size());
  }

  // Makes room for all that is not given at set-up.
  void make_room() {
    weight.resize(neighbour.size());
#define KERF_FIELD(type, name) name.resize(reference.size());
    KERF_SOLID_RESULTS(KERF_FIELD)
    if (any_softens) {
      KERF_SOLID_SOFTENING(KERF_FIELD)
    }
    if (any_flows) {
      KERF_SOLID_FLOW(KERF_FIELD)
    }
    if (any_flaws) {
      KERF_SOLID_FLAWS(KERF_FIELD)
    }
#undef KERF_FIELD
  }

  std::size_t bytes() const {
    std::size_t sum = bytes_of(media) + bytes_of(plastic) + bytes_of(flaw_law) +
                      bytes_of(medium_index) + bytes_of(reference) + bytes_of(bond_begin) +
                      bytes_of(neighbour) + bytes_of(weight) + bytes_of(bond_fit) +
                      bytes_of(pair_fit);
#define KERF_FIELD(type, name) sum += bytes_of(name);
    KERF_SOLID_RESULTS(KERF_FIELD)
    KERF_SOLID_SOFTENING(KERF_FIELD)
    KERF_SOLID_FLOW(KERF_FIELD)
    KERF_SOLID_FLAWS(KERF_FIELD)
#undef KERF_FIELD
    return sum;
  }

  View view() {
    View view;
    view.count = size();
    view.any_flows = any_flows;
    view.any_softens = any_softens;
    view.any_flaws = any_flaws;
    view.media = pointer(media);
    view.plastic = pointer(plastic);
    view.flaw_law = pointer(flaw_law);
    view.medium_index = pointer(medium_index);
    view.reference = pointer(reference);
    view.bond_begin = pointer(bond_begin);
    view.neighbour = pointer(neighbour);
    view.weight = pointer(weight);
    view.bond_fit = bond_fit.empty() ? nullptr : pointer(bond_fit);
    view.pair_fit = pair_fit.empty() ? nullptr : pointer(pair_fit);
    view.mirrors = mirrors;
#define KERF_FIELD(type, name) view.name = pointer(name);
    KERF_SOLID_RESULTS(KERF_FIELD)
    KERF_SOLID_SOFTENING(KERF_FIELD)
    KERF_SOLID_FLOW(KERF_FIELD)
    KERF_SOLID_FLAWS(KERF_FIELD)
#undef KERF_FIELD
    return view;
  }

 private:
  template <class T>
  static std::size_t bytes_of(const Array<T>& array) {
    return array.size() * sizeof(T);
  }
};

}  // namespace kerf
