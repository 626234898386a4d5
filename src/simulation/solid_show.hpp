// SPDX-License-Identifier: Apache-2.0
// The solids of the `standard` formulation in a frame, beyond what their particles hold: deviatoric
// stress and the share of a particle's bonds that is broken.
#pragma once

#include "materials/elastic_law.hpp"
#include "simulation/frame.hpp"
#include "simulation/solid_link.hpp"
#include "solid/solid_fields.hpp"

namespace kerf {

template <int D, class P>
class SolidOnHost {
 public:
  using Real = typename P::Real;

  explicit SolidOnHost(const SolidFields<D, P>& fields)
      : media_(to_host(fields.media)),
        medium_index_(to_host(fields.medium_index)),
        begin_(to_host(fields.bond_begin)),
        weight_(to_host(fields.weight)),
        gradient_(to_host(fields.gradient)),
        loose_(to_host(fields.loose)) {}

  SymmetricTensor<D, Real> stress(Index s) const {
    if (loose_[s]) return SymmetricTensor<D, Real>::zero();
    return cauchy(media_[medium_index_[s]], gradient_[s]);
  }
  float damage(Index s) const {
    const Index all = begin_[s + 1] - begin_[s];
    Index broken = 0;
    for (Index k = begin_[s]; k < begin_[s + 1]; ++k) broken += weight_[k] > Real(0) ? 0 : 1;
    return all > 0 ? static_cast<float>(broken) / static_cast<float>(all) : 1.0f;
  }

 private:
  std::vector<SolidMedium<Real>> media_;
  std::vector<std::uint16_t> medium_index_;
  std::vector<Index> begin_;
  std::vector<Real> weight_;
  std::vector<Matrix<D, Real>> gradient_;
  std::vector<std::uint8_t> loose_;
};

// `number_of_id`: solid number of a particle's id, no_index where it has none.
template <int D, class P>
void show_solid(const SolidFields<D, P>& fields, const Array<Index>& number_of_id, Frame& frame) {
  const SolidOnHost<D, P> solid(fields);
  const std::vector<Index> number = to_host(number_of_id);
  Column damage{"damage", "1", 1, std::vector<float>(frame.id.size(), 0.0f)};
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
    if (stress == nullptr) continue;
    std::vector<float> rows;
    append_tensor(sigma, rows);
    std::copy(rows.begin(), rows.end(), stress->values.begin() + static_cast<long>(6 * i));
  }
  frame.columns.push_back(std::move(damage));
}

}  // namespace kerf
