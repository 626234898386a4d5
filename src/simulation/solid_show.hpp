// SPDX-License-Identifier: Apache-2.0
// The solids of the `standard` formulation in a frame, beyond what their particles hold: deviatoric
// stress, the share of a particle's bonds that is broken and, where something flows, how far.
#pragma once

#include "simulation/frame.hpp"
#include "simulation/solid_link.hpp"
#include "solid/respond.hpp"

namespace kerf {

template <int D, class P>
class SolidOnHost {
 public:
  using Real = typename P::Real;

  explicit SolidOnHost(const SolidFields<D, P>& fields)
      : media_(to_host(fields.media)),
        medium_index_(to_host(fields.medium_index)),
        begin_(to_host(fields.bond_begin)),
        count_(to_host(fields.bond_count)),
        whole_(to_host(fields.whole)),
        gradient_(to_host(fields.gradient)),
        loose_(to_host(fields.loose)),
        plastic_(to_host(fields.plastic)),
        flow_(to_host(fields.flow_now)),
        flaws_(to_host(fields.flaws)) {
    // What came loose has not flown since.
    const std::vector<PlasticState<D, Real>> start = to_host(fields.flow_start);
    for (std::size_t s = 0; s < flow_.size(); ++s)
      if (loose_[s]) flow_[s] = start[s];
    view_.any_flows = fields.any_flows;
    view_.any_flaws = fields.any_flaws;
    view_.flaws = flaws_.data();
    view_.bonds = {begin_.data(), count_.data(), nullptr, {}};
    view_.words = fields.words;
    view_.whole = whole_.data();
    view_.media = media_.data();
    view_.medium_index = medium_index_.data();
    view_.plastic = plastic_.data();
    view_.gradient = gradient_.data();
    view_.flow_now = flow_.data();
  }
  SolidOnHost(const SolidOnHost&) = delete;  // the view looks at the vectors of this one

  SymmetricTensor<D, Real> stress(Index s) const {
    if (loose_[s]) return SymmetricTensor<D, Real>::zero();
    return cauchy_now(view_, s);
  }
  bool any_flows() const { return view_.any_flows; }
  bool any_flaws() const { return view_.any_flaws; }
  float flaw_damage(Index s) const { return static_cast<float>(view_.damage(s)); }
  float plastic_strain(Index s) const { return static_cast<float>(flow_[s].plastic_strain); }
  float temperature_rise(Index s) const { return static_cast<float>(flow_[s].temperature_rise); }
  float damage(Index s) const {
    const Index all = count_[s];
    const Index broken = all - view_.whole_bonds(s);
    return all > 0 ? static_cast<float>(broken) / static_cast<float>(all) : 1.0f;
  }

 private:
  std::vector<SolidMedium<Real>> media_;
  std::vector<std::uint16_t> medium_index_;
  std::vector<Index> begin_;
  std::vector<std::uint16_t> count_;
  std::vector<std::uint32_t> whole_;
  std::vector<Matrix<D, Real>> gradient_;
  std::vector<std::uint8_t> loose_;
  std::vector<PlasticParameters<Real>> plastic_;
  std::vector<PlasticState<D, Real>> flow_;
  std::vector<FlawState<Real>> flaws_;
  SolidView<D, P> view_{};
};

// `number_of_id`: solid number of a particle's id, no_index where it has none.
template <int D, class P>
void show_solid(const SolidFields<D, P>& fields, const Array<Index>& number_of_id, Frame& frame) {
  const SolidOnHost<D, P> solid(fields);
  const std::vector<Index> number = to_host(number_of_id);
  const std::vector<float> zeros(frame.id.size(), 0.0f);
  Column damage{"damage", "1", 1, zeros};
  Column plastic_strain{"plastic_strain", "1", 1, zeros};
  Column temperature_rise{"temperature_rise", "K", 1, zeros};
  Column flaw_damage{"flaw_damage", "1", 1, zeros};
  Column* stress = nullptr;
  for (Column& column : frame.columns)
    if (column.name == "deviatoric_stress") stress = &column;
  for (std::size_t i = 0; i < frame.id.size(); ++i) {
    if (frame.id[i] >= number.size() || number[frame.id[i]] == no_index) continue;
    const Index s = number[frame.id[i]];
    auto sigma = solid.stress(s);
    const auto mean = trace(sigma) / 3;
    for (int a = 0; a < 3; ++a) sigma(a, a) -= mean;
    damage.values[i] = solid.damage(s);
    if (solid.any_flaws()) flaw_damage.values[i] = solid.flaw_damage(s);
    if (solid.any_flows()) {
      plastic_strain.values[i] = solid.plastic_strain(s);
      temperature_rise.values[i] = solid.temperature_rise(s);
    }
    if (stress == nullptr) continue;
    std::vector<float> rows;
    append_tensor(sigma, rows);
    std::copy(rows.begin(), rows.end(), stress->values.begin() + static_cast<long>(6 * i));
  }
  frame.columns.push_back(std::move(damage));
  if (solid.any_flaws()) frame.columns.push_back(std::move(flaw_damage));
  if (!solid.any_flows()) return;
  frame.columns.push_back(std::move(plastic_strain));
  frame.columns.push_back(std::move(temperature_rise));
}

}  // namespace kerf
