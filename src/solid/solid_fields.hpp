// SPDX-License-Identifier: Apache-2.0
// SolidFields are the fields of the total Lagrangian solid, per particle and per bond. Its state
// variables are `bond_intact`, `elastic_share`, `detached`, `strain_start`, `loading_start`,
// `flow_start` and `flaws`; all other fields follow from these and from the positions.
#pragma once

#include <type_traits>

#include "core/matrix.hpp"
#include "core/mirror_planes.hpp"
#include "core/precision.hpp"
#include "model/medium.hpp"
#include "parallel/index_share.hpp"
#include "solid/bond_ends.hpp"
#include "solid/bond_table.hpp"
#include "solid/bond_terms.hpp"
#include "solid/bond_weight.hpp"
#include "solid/simd/packed_bonds.hpp"
#include "solid/solid_field_table.hpp"
#include "solid/stored_correction.hpp"
#include "solid/unlike_media.hpp"

namespace kerf {

template <int D, class P>
struct SolidView {
  using Real = typename P::Real;
  using Position = Vector<D, double>;
  using Speed = Vector<D, Real>;
  using Tensor = Matrix<D, Real>;
  using Correction = StoredCorrection<D, Real>;
  using Packed = PackedBondEnd<D, Real>;
  using State = PlasticState<D, Real>;
  using Flaws = FlawState<Real>;
  using LoadingState = Loading<Real>;

  Index count;
  IndexShare share;  // that the loops of this rank compute
  bool any_flows;    // whether there is a medium that flows
  bool any_softens;  // or softens
  bool any_flaws;    // or has flaws
  bool any_rate;     // or has a strength that depends on the rate of strain
  const Medium<Real>* media;
  const std::uint16_t* medium_index;
  const Position* reference;  // X, m
  BondTable<D> bonds;
  std::uint32_t* bond_intact;  // a bit per bond, from the lowest on in words of each particle's own
  Index words;                 // of each particle
  // s of gradient_correction_levels.hpp, per bond; null: 1.
  const Real *bond_correction, *pair_correction;
  const BondScale<Real>* scale;             // per pair of media
  const BondViscosityLaw<Real>* viscosity;  // the same
  Index media_count;
#define KERF_FIELD(type, name) type* name;
  KERF_SOLID_FIELDS(KERF_FIELD)
#undef KERF_FIELD

  KERF_FUNCTION const Medium<Real>& medium(Index i) const {
    return media[medium_index[i]];
  }
  KERF_FUNCTION const PlasticParameters<Real>& plasticity(Index i) const {
    return medium(i).plastic;
  }
  KERF_FUNCTION bool flows(Index i) const {
    return any_flows && plasticity(i).flows();
  }
  KERF_FUNCTION bool softens(Index i) const {
    return any_softens && medium(i).softens() && !held[i];
  }
  KERF_FUNCTION bool depends_on_rate(Index i) const {
    return any_rate && medium(i).depends_on_rate() && !held[i];
  }
  // R of fracture/strength_rate.hpp, at the current deformation and at the start of the step.
  KERF_FUNCTION Real strength_factor(Index i) const {
    return any_rate ? loading_now[i].factor : Real(1);
  }
  KERF_FUNCTION Real strength_factor_at_start(Index i) const {
    return any_rate ? loading_start[i].factor : Real(1);
  }
  // k / R, the strain that determines what softening has left (fracture/softening.hpp), at the
  // current deformation and at the start of the step.
  KERF_FUNCTION Real softening_strain(Index i) const {
    return current_strain[i] / strength_factor(i);
  }
  KERF_FUNCTION Real softening_strain_at_start(Index i) const {
    return strain_start[i] / strength_factor_at_start(i);
  }
  KERF_FUNCTION bool has_flaws(Index i) const {
    return any_flaws && medium(i).grady_kipp.is_on() && !held[i];
  }
  // Damage of a particle, by which its tension is less.
  KERF_FUNCTION Real damage(Index i) const {
    return any_flaws ? flaws[i].damage : Real(0);
  }
  // Returns the other end of bond k of particle i.
  template <class End = BondEnd>
  KERF_FUNCTION End bond_end(Index i, Index k) const {
    const Index end = bonds.end(i, k);
    if constexpr (std::is_same_v<End, DirectEnd>)
      return {end};
    else
      return {bonds.mirrors.particle(end), bonds.mirrors.code(end)};
  }
  // Returns the first bond of particle i to a mirror image; the end of its bonds where there is
  // none.
  KERF_FUNCTION Index first_image(Index i) const {
    Index k = bonds.last(i);
    if (has_mirrors())
      while (k > bonds.first(i) && bond_end(i, k - 1).mirror != 0) --k;
    return k;
  }
  KERF_FUNCTION bool has_mirrors() const {
    return bonds.mirrors.faces != 0;
  }
  // Returns whether bond k of particle i is intact.
  KERF_FUNCTION bool is_intact(Index i, Index k) const {
    return (bond_intact[word(i, k)] & bit(i, k)) != 0;
  }
  KERF_FUNCTION Index intact_bonds(Index i) const {
    Index sum = 0;
    for (Index k = bonds.first(i); k < bonds.last(i); ++k) sum += is_intact(i, k);
    return sum;
  }
  KERF_FUNCTION void break_bond(Index i, Index k) const {
    bond_intact[word(i, k)] &= ~bit(i, k);
  }
  // Returns w_ij of bond k of particle i, if it is intact; `bond` = X_j - X_i.
  template <class End>
  KERF_FUNCTION Real weight(Index i, Index k, const End& j, const Vector<D, Real>& bond) const {
    const Real w =
        scale[medium_index[i] * media_count + medium_index[j.particle]].weight(norm(bond));
    return bond_correction == nullptr ? w : bond_correction[k] * w;
  }
  KERF_FUNCTION const BondViscosityLaw<Real>& viscosity_law(Index i, Index j) const {
    return viscosity[medium_index[i] * media_count + medium_index[j]];
  }
  // X_j - X_i, m.
  template <class T = Real, class End>
  KERF_FUNCTION Vector<D, T> reference_bond(Index i, const End& j) const {
    const auto& x = reference[i];
    const auto& y = reference[j.particle];
    if (j.mirror == 0) return Vector<D, T>::from(y - x);
    return T(-1) * Vector<D, T>::from(bonds.mirrors.separation(j.mirror, x, y));
  }
  // u_j - u_i, m: differences of both parts, exact also far from the initial position.
  template <class T = Real, class End>
  KERF_FUNCTION Vector<D, T> displacement_bond(Index i, const End& j) const {
    using Change = Vector<D, T>;
    const auto &own = ends[i], &other = ends[j.particle];
    const auto displacement = image(j, other.displacement), remainder = image(j, other.remainder);
    Change change;
    for (int a = 0; a < D; ++a)
      change[a] = displacement_difference(T(own.displacement[a]), T(own.remainder[a]),
                                          T(displacement[a]), T(remainder[a]));
    return change;
  }
  // Bond k of particle i, which leads to j, if it is intact.
  template <class End>
  KERF_FUNCTION BondGeometry<D, Real> bond_geometry(Index i, Index k, const End& j) const {
    const Vector<D, Real> bond = reference_bond(i, j);
    return {bond, displacement_bond(i, j), weight(i, k, j, bond)};
  }
  // v_j - v_i, m/s.
  template <class End>
  KERF_FUNCTION Speed velocity_bond(Index i, const End& j) const {
    return image(j, ends[j.particle].velocity) - ends[i].velocity;
  }
  // A vector or tensor of the other end of a bond: that of particle j, or of its mirror image.
  template <class T, class End>
  KERF_FUNCTION static T image(const End& j, const T& value) {
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
  using Position = typename View::Position;
  using Speed = typename View::Speed;
  using Tensor = typename View::Tensor;
  using Correction = typename View::Correction;
  using Packed = typename View::Packed;
  using State = typename View::State;
  using Flaws = typename View::Flaws;
  using LoadingState = typename View::LoadingState;

  IndexShare share;
  bool any_flows = false, any_softens = false, any_flaws = false, any_rate = false;
  Array<Medium<Real>> media;
  Array<std::uint16_t> medium_index;
  Array<Position> reference;
  Array<Index> bond_begin, bond_entry;
  Array<std::uint16_t> bond_count;
  MirrorPlanes<D> mirrors{};
  Array<std::uint32_t> bond_intact;
  Index words = 0;
  Array<Real> bond_correction, pair_correction;
  Array<BondScale<Real>> scale;
  Array<BondViscosityLaw<Real>> viscosity;
#define KERF_FIELD(type, name) Array<type> name;
  KERF_SOLID_FIELDS(KERF_FIELD)
#undef KERF_FIELD

  Index size() const {
    return static_cast<Index>(reference.size());
  }

  // Allocates the fields that are not given at set-up; all bonds are intact. `most`: bonds of a
  // particle.
  void make_room(Index most) {
    share = IndexShare::whole(size());
    words = (most + bonds_per_word - 1) / bonds_per_word;
    bond_intact.assign(words * reference.size(), ~std::uint32_t(0));
#define KERF_FIELD(type, name) name.resize(reference.size());
    KERF_SOLID_RESULTS(KERF_FIELD)
    elastic_share.assign(reference.size(), Real(1));
    if (mirrors.faces != 0) {
      KERF_SOLID_MIRRORED(KERF_FIELD)
    }
    if (any_softens) {
      KERF_SOLID_SOFTENING(KERF_FIELD)
    }
    if (any_rate) {
      KERF_SOLID_RATE(KERF_FIELD)
    }
    if (any_flows) {
      KERF_SOLID_FLOW(KERF_FIELD)
    }
    if (any_flaws) {
      KERF_SOLID_FLAWS(KERF_FIELD)
    }
#undef KERF_FIELD
  }

  // Calls visit(array) for all fields with one entry per particle; some are empty.
  template <class Visit>
  void for_each_field(const Visit& visit) {
#define KERF_FIELD(type, name) visit(name);
    KERF_SOLID_FIELDS(KERF_FIELD)
#undef KERF_FIELD
  }

  std::size_t bytes() const {
    std::size_t sum = bytes_of(media) + bytes_of(medium_index) + bytes_of(reference) +
                      bytes_of(bond_begin) + bytes_of(bond_entry) + bytes_of(bond_count) +
                      bytes_of(scale) + bytes_of(viscosity) + bytes_of(bond_intact) +
                      bytes_of(bond_correction) + bytes_of(pair_correction);
#define KERF_FIELD(type, name) sum += bytes_of(name);
    KERF_SOLID_FIELDS(KERF_FIELD)
#undef KERF_FIELD
    return sum;
  }

  View view() {
    View view;
    view.count = size();
    view.share = share;
    view.any_flows = any_flows;
    view.any_softens = any_softens;
    view.any_flaws = any_flaws;
    view.any_rate = any_rate;
    view.media = pointer(media);
    view.medium_index = pointer(medium_index);
    view.reference = pointer(reference);
    view.bonds = {pointer(bond_begin), pointer(bond_count), pointer(bond_entry), mirrors};
    view.bond_intact = pointer(bond_intact);
    view.words = words;
    view.scale = pointer(scale);
    view.viscosity = pointer(viscosity);
    view.media_count = static_cast<Index>(media.size());
    view.bond_correction = bond_correction.empty() ? nullptr : pointer(bond_correction);
    view.pair_correction = pair_correction.empty() ? nullptr : pointer(pair_correction);
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
