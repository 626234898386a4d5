// SPDX-License-Identifier: Apache-2.0
// The columns of frames that show the solids of the `standard` formulation: the pieces, the
// deviatoric stress, the strain and the table of numbers below, such as the share of the bonds of a
// particle that is broken.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "materials/hencky.hpp"
#include "simulation/snapshot.hpp"
#include "solid/stress_response.hpp"
#include "standard/solid_link.hpp"
#include "standard/solid_pieces.hpp"

namespace kerf {

template <int D, class P>
class SolidOnHost {
 public:
  using Real = typename P::Real;

  // `body_of_medium`: the body of each medium, as an index into Case::bodies.
  SolidOnHost(const SolidFields<D, P>& fields, const std::vector<std::uint16_t>& body_of_medium)
      : media_(to_host(fields.media)),
        medium_index_(to_host(fields.medium_index)),
        begin_(to_host(fields.bond_begin)),
        count_(to_host(fields.bond_count)),
        entry_(to_host(fields.bond_entry)),
        intact_(to_host(fields.bond_intact)),
        gradient_(to_host(fields.gradient)),
        share_(to_host(fields.elastic_share)),
        strain_(to_host(fields.current_strain)),
        detached_(to_host(fields.detached)),
        held_(to_host(fields.held)),
        has_broken_bonds_(to_host(fields.has_broken_bonds)),
        several_bodies_(to_host(fields.several_bodies)),
        flow_(to_host(fields.current_flow)),
        flaws_(to_host(fields.flaws)),
        loading_(to_host(fields.loading_now)) {
    // Detached particles do not flow: they keep the state at which they came detached.
    const std::vector<PlasticState<D, Real>> start = to_host(fields.flow_start);
    for (std::size_t s = 0; s < flow_.size(); ++s)
      if (detached_[s]) flow_[s] = start[s];
    for (const std::uint16_t medium : medium_index_) body_.push_back(body_of_medium[medium]);
    view_.any_flows = fields.any_flows;
    view_.any_softens = fields.any_softens;
    view_.any_flaws = fields.any_flaws;
    view_.any_rate = fields.any_rate;
    view_.current_strain = strain_.data();
    view_.loading_now = loading_.data();
    view_.flaws = flaws_.data();
    view_.bonds = {begin_.data(), count_.data(), entry_.data(), fields.mirrors};
    view_.words = fields.words;
    view_.bond_intact = intact_.data();
    view_.media = media_.data();
    view_.medium_index = medium_index_.data();
    view_.held = held_.data();
    view_.gradient = gradient_.data();
    view_.elastic_share = share_.data();
    view_.current_flow = flow_.data();
  }
  SolidOnHost(const SolidOnHost&) = delete;  // the view points to the vectors of this object

  SymmetricTensor<D, Real> stress(Index s) const {
    if (detached_[s]) return SymmetricTensor<D, Real>::zero();
    return cauchy_now(view_, s);
  }
  // Hencky's strain of the whole deformation in the current configuration, ln(F F^T)/2. Detached
  // particles have none.
  SymmetricTensor<D, Real> strain(Index s) const {
    if (detached_[s]) return SymmetricTensor<D, Real>::zero();
    const auto strain = whole_strain(s);
    Vector<3, Real> values = strain.deviator;
    for (int a = 0; a < 3; ++a) values[a] += strain.volume / Real(3);
    return strain.stretch.tensor(values);
  }
  // sqrt(2/3 e' : e') of its deviator e', the strain of the criterion of that name
  // (fracture/equivalent_total_strain.hpp).
  float equivalent_strain(Index s) const {
    if (detached_[s]) return 0.0f;
    const auto deviator = whole_strain(s).deviator;
    return static_cast<float>(std::sqrt(Real(2) / Real(3) * dot(deviator, deviator)));
  }
  const SolidView<D, P>& view() const { return view_; }
  Index size() const { return static_cast<Index>(medium_index_.size()); }
  // Returns the share of its tension that softening or flaws have left to a particle.
  Real tension_left(Index s) const {
    if (view_.softens(s)) return undamaged_share(view_.medium(s), view_.softening_strain(s));
    return Real(1) - view_.damage(s);
  }
  bool any_flows() const { return view_.any_flows; }
  bool any_flaws() const { return view_.any_flaws; }
  // Detached particles have none.
  float elastic_share(Index s) const { return detached_[s] ? 0.0f : static_cast<float>(share_[s]); }
  bool any_rate() const { return view_.any_rate; }
  float strength_factor(Index s) const { return static_cast<float>(view_.strength_factor(s)); }
  float flaw_damage(Index s) const { return static_cast<float>(view_.damage(s)); }
  float plastic_strain(Index s) const { return static_cast<float>(flow_[s].plastic_strain); }
  float temperature_rise(Index s) const { return static_cast<float>(flow_[s].temperature_rise); }
  float damage(Index s) const {
    if (!has_broken_bonds_[s] && !detached_[s]) return 0.0f;
    const Index all = count_[s];
    const Index broken = all - view_.intact_bonds(s);
    return all > 0 ? static_cast<float>(broken) / static_cast<float>(all) : 1.0f;
  }
  // Whether any particle has bonds to another body.
  bool has_joints() const {
    const auto is_first = [this](std::uint16_t body) { return body == body_.front(); };
    if (std::all_of(body_.begin(), body_.end(), is_first)) return false;
    for (Index s = 0; s < size(); ++s)
      for (Index k = view_.bonds.first(s); several_bodies_[s] && k < view_.bonds.last(s); ++k)
        if (leaves_body(s, k)) return true;
    return false;
  }
  // The same share of the bonds within its body.
  float body_damage(Index s) const {
    if (!has_broken_bonds_[s] && !detached_[s]) return 0.0f;
    Index all = 0, broken = 0;
    for (Index k = view_.bonds.first(s); k < view_.bonds.last(s); ++k) {
      if (leaves_body(s, k)) continue;
      ++all;
      broken += view_.is_intact(s, k) ? 0 : 1;
    }
    return all > 0 ? static_cast<float>(broken) / static_cast<float>(all) : damage(s);
  }
  // The body of each particle.
  const std::vector<std::uint16_t>& bodies() const { return body_; }

 private:
  bool leaves_body(Index s, Index k) const {
    return body_[view_.bonds.mirrors.particle(view_.bonds.end(s, k))] != body_[s];
  }
  ElasticStrain<D, Real> whole_strain(Index s) const {
    return ElasticStrain<D, Real>::of(gradient_[s], SymmetricTensor<D, Real>::zero());
  }

  std::vector<Medium<Real>> media_;
  std::vector<std::uint16_t> medium_index_;
  std::vector<Index> begin_;
  std::vector<std::uint16_t> count_;
  std::vector<Index> entry_;
  std::vector<std::uint32_t> intact_;
  std::vector<Matrix<D, Real>> gradient_;
  std::vector<Real> share_, strain_;
  std::vector<std::uint8_t> detached_, held_, has_broken_bonds_, several_bodies_;
  std::vector<PlasticState<D, Real>> flow_;
  std::vector<FlawState<Real>> flaws_;
  std::vector<Loading<Real>> loading_;
  std::vector<std::uint16_t> body_;
  SolidView<D, P> view_{};
};

// The columns of numbers: one row for each, with the solids that have it and its value.
template <class Solid>
struct ShownSolidField {
  const char *name, *label, *unit;
  bool (*exists)(const Solid&);
  float (*value)(const Solid&, Index);
};
template <int D, class P>
constexpr auto shown_solid_fields() {
  using Solid = SolidOnHost<D, P>;
  constexpr auto always = [](const Solid&) { return true; };
  constexpr auto flows = [](const Solid& solid) { return solid.any_flows(); };
  constexpr auto flaws = [](const Solid& solid) { return solid.any_flaws(); };
  constexpr auto rate = [](const Solid& solid) { return solid.any_rate(); };
  constexpr auto joints = [](const Solid& solid) { return solid.has_joints(); };
  return std::array<ShownSolidField<Solid>, 8>{{
      {"damage", "damage", "1", always,
       [](const Solid& solid, Index s) { return solid.damage(s); }},
      {"body_damage", "damage within the body", "1", joints,
       [](const Solid& solid, Index s) { return solid.body_damage(s); }},
      {"elastic_share", "elastic share", "1", always,
       [](const Solid& solid, Index s) { return solid.elastic_share(s); }},
      {"equivalent_strain", "equivalent strain", "1", always,
       [](const Solid& solid, Index s) { return solid.equivalent_strain(s); }},
      {"flaw_damage", "damage by flaws", "1", flaws,
       [](const Solid& solid, Index s) { return solid.flaw_damage(s); }},
      {"plastic_strain", "plastic strain", "1", flows,
       [](const Solid& solid, Index s) { return solid.plastic_strain(s); }},
      {"strength_factor", "strength over that of a slow test", "1", rate,
       [](const Solid& solid, Index s) { return solid.strength_factor(s); }},
      {"temperature_rise", "rise of temperature", "K", flows,
       [](const Solid& solid, Index s) { return solid.temperature_rise(s); }},
  }};
}

// Adds the pieces of the solid to a frame. Other particles are pieces of their own. `solid_of`: the
// solid number of each row, or no_index.
template <int D, class P>
void show_pieces(const SolidOnHost<D, P>& solid, const std::vector<Index>& solid_of, Frame& frame) {
  std::vector<std::uint32_t> id(solid.size(), 0);
  for (std::size_t i = 0; i < solid_of.size(); ++i)
    if (solid_of[i] != no_index) id[solid_of[i]] = frame.id[i];
  const SolidPieces pieces = find_solid_pieces<D>(solid, solid.bodies());
  frame.piece = frame.body_piece = frame.id;
  if (solid.view().has_mirrors()) frame.joined_planes.assign(frame.id.size(), 0);
  for (std::size_t i = 0; i < solid_of.size(); ++i) {
    const Index s = solid_of[i];
    if (s == no_index) continue;
    frame.piece[i] = id[pieces.piece[s]];
    frame.body_piece[i] = id[pieces.body_piece[s]];
    if (!frame.joined_planes.empty()) frame.joined_planes[i] = pieces.planes[s];
  }
}

// The columns of tensors: each is `tensor_of(solid number)` for solids and zero for others.
template <int D, class P, class TensorOf>
Column tensor_column(Column column, const std::vector<Index>& solid_of, const TensorOf& tensor_of) {
  column.components = 6;
  for (const Index s : solid_of)
    append_row(s == no_index ? SymmetricTensor<D, typename P::Real>::zero() : tensor_of(s),
               column.values);
  return column;
}

template <int D, class P>
void show_tensors(const SolidOnHost<D, P>& solid, const std::vector<Index>& solid_of,
                  Frame& frame) {
  const auto deviatoric_stress = [&](Index s) {
    auto sigma = solid.stress(s);
    const auto mean = trace(sigma) / 3;
    for (int a = 0; a < 3; ++a) sigma(a, a) -= mean;
    return sigma;
  };
  const auto strain = [&](Index s) { return solid.strain(s); };
  frame.columns.push_back(tensor_column<D, P>(
      {"deviatoric_stress", "Pa", 6, {}, "deviatoric stress"}, solid_of, deviatoric_stress));
  frame.columns.push_back(tensor_column<D, P>({"strain", "1", 6, {}, "strain"}, solid_of, strain));
}

// Adds the columns of the solid to a frame: the pieces, the tensors, then those of the table; for a
// cut the pieces and the damage alone. Other particles have zeros. `solid_index_of_id`: solid
// number of a particle's id, or no_index.
template <int D, class P>
void show_solid(const SolidFields<D, P>& fields, const std::vector<std::uint16_t>& body_of_medium,
                const Array<Index>& solid_index_of_id, FrameContent content, Frame& frame) {
  const bool is_whole = content == FrameContent::everything;
  const SolidOnHost<D, P> solid(fields, body_of_medium);
  const std::vector<Index> number = to_host(solid_index_of_id);
  std::vector<Index> solid_of(frame.id.size(), no_index);
  for (std::size_t i = 0; i < frame.id.size(); ++i)
    if (frame.id[i] < number.size()) solid_of[i] = number[frame.id[i]];
  show_pieces(solid, solid_of, frame);
  if (is_whole) show_tensors(solid, solid_of, frame);
  for (const auto& shown : shown_solid_fields<D, P>()) {
    const bool tells_damage = std::string_view(shown.name).ends_with("damage");
    if ((!is_whole && !tells_damage) || !shown.exists(solid)) continue;
    Column column{shown.name, shown.unit, 1, {}, shown.label};
    for (const Index s : solid_of)
      column.values.push_back(s == no_index ? 0.0f : shown.value(solid, s));
    frame.columns.push_back(std::move(column));
  }
}

}  // namespace kerf
