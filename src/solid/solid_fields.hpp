// SPDX-License-Identifier: Apache-2.0
// What the total Lagrangian solid keeps per particle and per bond. State: which bonds are whole,
// `loose`, `strain_start`, `flow_start` and `flaws`; all else follows from these and from where the
// particles are.
#pragma once

#include <type_traits>

#include "core/matrix.hpp"
#include "core/mirror_planes.hpp"
#include "core/precision.hpp"
#include "exec/exec.hpp"
#include "fracture/grady_kipp.hpp"
#include "lanes/packed_bonds.hpp"
#include "materials/plastic_law.hpp"
#include "solid/bond_ends.hpp"
#include "solid/bond_table.hpp"
#include "solid/bond_weight.hpp"

namespace kerf {

// Fields with one entry per particle that are not given at set-up. FIELD(type, name): meaning.
#define KERF_SOLID_RESULTS(FIELD)                                                      \
  FIELD(std::uint8_t, loose)    /* 1: holds on to nothing, carries no stress */        \
  FIELD(std::uint8_t, torn)     /* 1: has lost bonds */                                \
  FIELD(std::uint8_t, changed)  /* 1: its correction is outdated */                    \
  FIELD(std::uint8_t, mixed)    /* 1: has bonds to other media, or to images */        \
  FIELD(std::uint8_t, strained) /* 1: one of its bonds may break */                    \
  FIELD(Real, stretch)          /* largest lambda^2 - 1 of its bonds, if they break */ \
  FIELD(Packed, ends)           /* displacement, velocity, traction and others */      \
  FIELD(Tensor, correction)     /* B_i / V_i, 1/m^D */                                 \
  FIELD(Tensor, gradient)       /* H = F - 1 */                                        \
  FIELD(Real, criterion)        /* of the fracture criterion */                        \
  FIELD(Speed, acceleration)    /* m/s^2 */                                            \
  FIELD(Real, viscous_power)    /* W, dissipated by the bond viscosity */
// Those that only solids beside planes of symmetry have.
#define KERF_SOLID_MIRRORED(FIELD) \
  FIELD(Speed, mirror_acceleration) /* m/s^2, the part due to mirror images */
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
#define KERF_SOLID_FIELDS(FIELD) \
  KERF_SOLID_RESULTS(FIELD)      \
  KERF_SOLID_MIRRORED(FIELD)     \
  KERF_SOLID_SOFTENING(FIELD)    \
  KERF_SOLID_FLOW(FIELD)         \
  KERF_SOLID_FLAWS(FIELD)

template <int D, class P>
struct SolidView {
  using Real = typename P::Real;
  using Place = Vector<D, double>;
  using Speed = Vector<D, Real>;
  using Tensor = Matrix<D, Real>;
  using Packed = PackedBondEnd<D, Real>;
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
  const Place* reference;  // X, m
  BondTable<D> bonds;
  std::uint32_t* whole;  // a bit per bond, from the lowest on in words of each particle's own
  Index words;           // of each particle
  // s of fit_levels.hpp, per bond; null: 1.
  const Real *bond_fit, *pair_fit;
  const BondScale<Real>* scale;  // per pair of media
  Index media_count;
#define KERF_FIELD(type, name) type* name;
  KERF_SOLID_FIELDS(KERF_FIELD)
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
  // What bond k of particle i leads to.
  template <class End = BondEnd>
  KERF_FUNCTION End bond_end(Index i, Index k) const {
    const Index end = bonds.end(i, k);
    if constexpr (std::is_same_v<End, DirectEnd>)
      return {end};
    else
      return {bonds.mirrors.place(end), bonds.mirrors.code(end)};
  }
  // Of particle i, the first bond that is one to a mirror image; the end of its bonds for none.
  KERF_FUNCTION Index first_image(Index i) const {
    Index k = bonds.last(i);
    if (has_mirrors())
      while (k > bonds.first(i) && bond_end(i, k - 1).mirror != 0) --k;
    return k;
  }
  KERF_FUNCTION bool has_mirrors() const {
    return bonds.mirrors.faces != 0;
  }
  // Whether bond k of particle i is unbroken.
  KERF_FUNCTION bool is_whole(Index i, Index k) const {
    return (whole[word(i, k)] & bit(i, k)) != 0;
  }
  KERF_FUNCTION Index whole_bonds(Index i) const {
    Index sum = 0;
    for (Index k = bonds.first(i); k < bonds.last(i); ++k) sum += is_whole(i, k);
    return sum;
  }
  KERF_FUNCTION void break_bond(Index i, Index k) const {
    whole[word(i, k)] &= ~bit(i, k);
  }
  // w_ij of bond k of particle i, if it is unbroken; `bond` = X_j - X_i.
  template <class End>
  KERF_FUNCTION Real weight(Index i, Index k, const End& j, const Vector<D, Real>& bond) const {
    const Real w =
        scale[medium_index[i] * media_count + medium_index[j.particle]].weight(norm(bond));
    return bond_fit == nullptr ? w : bond_fit[k] * w;
  }
  // X_j - X_i, m.
  template <class T = Real, class End>
  KERF_FUNCTION Vector<D, T> reference_bond(Index i, const End& j) const {
    const auto& x = reference[i];
    const auto& y = reference[j.particle];
    if (j.mirror == 0) return Vector<D, T>::from(y - x);
    return T(-1) * Vector<D, T>::from(bonds.mirrors.separation(j.mirror, x, y));
  }
  // u_j - u_i, m: differences of both parts, so that a body far from home loses no digits.
  template <class T = Real, class End>
  KERF_FUNCTION Vector<D, T> displacement_bond(Index i, const End& j) const {
    using Change = Vector<D, T>;
    const auto &own = ends[i], &other = ends[j.particle];
    const auto first = Change::from(seen(j, other.displacement)) - Change::from(own.displacement);
    return first + (Change::from(seen(j, other.remainder)) - Change::from(own.remainder));
  }
  // v_j - v_i, m/s.
  template <class End>
  KERF_FUNCTION Speed velocity_bond(Index i, const End& j) const {
    return seen(j, ends[j.particle].velocity) - ends[i].velocity;
  }
  // A vector or tensor of particle j as one sees it who is bound to it: of its image, where it is
  // one.
  template <class T, class End>
  KERF_FUNCTION static T seen(const End& j, const T& value) {
    return MirrorPlanes<D>::image(j.mirror, value);
  }

 private:
  KERF_FUNCTION Index word(Index i, Index k) const {
    return i * words + (k - bonds.first(i)) / bonds_per_word;
  }
  KERF_FUNCTION std::uint32_t bit(Index i, Index k) const {
    return std::uint32_t(1) << ((k - bonds.first(i)) % bonds_per_word);
  }
};

template <int D, class P>
struct SolidFields {
  using View = SolidView<D, P>;
  using Real = typename P::Real;
  using Place = typename View::Place;
  using Speed = typename View::Speed;
  using Tensor = typename View::Tensor;
  using Packed = typename View::Packed;
  using State = typename View::State;
  using Flaws = typename View::Flaws;

  bool any_flows = false, any_softens = false, any_flaws = false;
  Array<SolidMedium<Real>> media;
  Array<PlasticParameters<Real>> plastic;
  Array<GradyKipp<Real>> flaw_law;
  Array<std::uint16_t> medium_index;
  Array<Place> reference;
  Array<Index> bond_begin, bond_entry;
  Array<std::uint16_t> bond_count;
  MirrorPlanes<D> mirrors{};
  Array<std::uint32_t> whole;
  Index words = 0;
  Array<Real> bond_fit, pair_fit;
  Array<BondScale<Real>> scale;
#define KERF_FIELD(type, name) Array<type> name;
  KERF_SOLID_FIELDS(KERF_FIELD)
#undef KERF_FIELD

  Index size() const {
    return static_cast<Index>(reference.size());
  }

  // Makes room for all that is not given at set-up.
  void make_room() {
    whole.resize(words * reference.size());
#define KERF_FIELD(type, name) name.resize(reference.size());
    KERF_SOLID_RESULTS(KERF_FIELD)
    if (mirrors.faces != 0) {
      KERF_SOLID_MIRRORED(KERF_FIELD)
    }
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
                      bytes_of(bond_entry) + bytes_of(bond_count) + bytes_of(scale) +
                      bytes_of(whole) + bytes_of(bond_fit) + bytes_of(pair_fit);
#define KERF_FIELD(type, name) sum += bytes_of(name);
    KERF_SOLID_FIELDS(KERF_FIELD)
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
    view.bonds = {pointer(bond_begin), pointer(bond_count), pointer(bond_entry), mirrors};
    view.whole = pointer(whole);
    view.words = words;
    view.scale = pointer(scale);
    view.media_count = static_cast<Index>(media.size());
    view.bond_fit = bond_fit.empty() ? nullptr : pointer(bond_fit);
    view.pair_fit = pair_fit.empty() ? nullptr : pointer(pair_fit);
#define KERF_FIELD(type, name) view.name = pointer(name);
    KERF_SOLID_FIELDS(KERF_FIELD)
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
