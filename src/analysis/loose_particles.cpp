// SPDX-License-Identifier: Apache-2.0
#include "analysis/loose_particles.hpp"

#include <algorithm>
#include <cstdint>

#include "model/case.hpp"
#include "simulation/frame.hpp"
#include "simulation/run_settings.hpp"
#include "simulation/symmetry.hpp"
#include "solid/bonds_through_solid.hpp"
#include "solid/gradient_correction.hpp"

namespace kerf {
namespace {

template <int D>
SolidLayout<D> layout_of_solids(const RunSettings& settings) {
  SolidLayout<D> layout;
  layout.media = settings.media;
  layout.mirrors = mirror_planes<D>(settings);
  layout.regions = settings.bond_regions;
  for (const NewParticle& particle : settings.particles) {
    if (settings.media[particle.source].phase != Phase::solid) continue;
    layout.reference.push_back(Vector<D, double>::from(particle.position));
    layout.medium_index.push_back(particle.source);
  }
  return layout;
}

// Finds the particles that Correct would detach (solid/gradient_correction.hpp).
template <int D>
class LooseSearch {
 public:
  explicit LooseSearch(const SolidLayout<D>& layout)
      : layout_(layout),
        bonds_(bonds_of(layout)),
        scales_(layout.media),
        loose_(layout.reference.size(), 0) {}

  // A particle that is detached takes bonds from others, which may be detached in turn.
  std::vector<std::uint8_t> find() {
    bool any = true;
    while (any) {
      any = false;
      for (Index i = 0; i < static_cast<Index>(loose_.size()); ++i) {
        if (loose_[i] != 0 || holds(i)) continue;
        loose_[i] = 1;
        any = true;
      }
    }
    return std::move(loose_);
  }

 private:
  // Whether the particle has bonds enough for a gradient correction.
  bool holds(Index i) const {
    const double volume = layout_.media[layout_.medium_index[i]].reference_volume();
    auto moment = Matrix<D, double>::zero(), correction = moment;
    Index bonds = 0;
    for (Index k = bonds_.begin[i]; k < bonds_.begin[i + 1]; ++k) {
      const Index end = bonds_.neighbour[k], j = layout_.mirrors.particle(end);
      if (loose_[j] != 0) continue;
      const auto bond = layout_.mirrors.separation(layout_.mirrors.code(end), layout_.reference[i],
                                                   layout_.reference[j]);
      const double weight =
          scales_(layout_.medium_index[i], layout_.medium_index[j]).weight(norm(bond));
      add_outer(moment, (weight / volume) * bond, bond);
      ++bonds;
    }
    return bonds >= least_bonds<D> &&
           divide(correction = identity<D, double>(), moment, least_moment);
  }

  const SolidLayout<D>& layout_;
  BondLists bonds_;
  BondScales<D> scales_;
  std::vector<std::uint8_t> loose_;
};

// Counts the particles body by body.
class LooseCount {
 public:
  explicit LooseCount(const Case& description) : description_(description) {
    for (std::size_t b = 0; b < description.bodies.size(); ++b)
      counts_.push_back({static_cast<int>(b), 0, 0});
  }
  void add(std::size_t body, bool is_loose) {
    if (body >= counts_.size()) return;
    ++counts_[body].all;
    counts_[body].loose += is_loose ? 1 : 0;
  }
  std::vector<LooseParticles> found() const {
    std::vector<LooseParticles> found;
    for (const LooseParticles& count : counts_) {
      const Body& body = description_.bodies[static_cast<std::size_t>(count.body)];
      if (count.loose > 0 && body.role == Role::elastic && !body.fixed) found.push_back(count);
    }
    return found;
  }

 private:
  const Case& description_;
  std::vector<LooseParticles> counts_;
};

template <int D>
std::vector<LooseParticles> loose_by_layout(const Case& description) {
  const RunSettings settings = run_settings(description);
  const SolidLayout<D> layout = layout_of_solids<D>(settings);
  if (layout.reference.empty()) return {};
  const std::vector<std::uint8_t> loose = LooseSearch<D>(layout).find();
  LooseCount count(description);
  for (std::size_t i = 0; i < loose.size(); ++i)
    count.add(settings.origins[layout.medium_index[i]].source, loose[i] != 0);
  return count.found();
}

}  // namespace

std::vector<LooseParticles> loose_particles(const Case& description) {
  if (description.formulation != Formulation::standard) return {};
  return description.dimension == 2 ? loose_by_layout<2>(description)
                                    : loose_by_layout<3>(description);
}

std::vector<LooseParticles> loose_particles(const Case& description, const Frame& initial) {
  LooseCount count(description);
  for (std::size_t row = 0; row < initial.id.size(); ++row)
    count.add(initial.source[row], initial.category[row] == Category::fractured);
  return count.found();
}

}  // namespace kerf
