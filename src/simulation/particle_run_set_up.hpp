// SPDX-License-Identifier: Apache-2.0
// The set-up of a run, from its settings or from a checkpoint.
#pragma once

#include <algorithm>
#include <cstring>
#include <limits>
#include <type_traits>
#include <utility>

#include "neighbours/skin.hpp"
#include "simulation/particle_run.hpp"
#include "simulation/state_io.hpp"
#include "simulation/symmetry.hpp"

namespace kerf {

template <int D, class P, class Traits>
ParticleRun<D, P, Traits>::ParticleRun(RunSettings settings)
    : settings_(std::move(settings)),
      nozzles_(std::move(settings_.nozzles)),
      media_(std::move(settings_.media)),
      gravity_(Position::from(settings_.gravity)),
      minimum_(Position::from(settings_.domain_minimum)),
      maximum_(Position::from(settings_.domain_maximum)) {
  particles_.mirrors = mirror_planes<D>(settings_);
  const auto has = [&](Phase phase) {
    return std::any_of(media_.begin(), media_.end(),
                       [&](const auto& medium) { return medium.phase == phase; });
  };
  const bool has_smooth_walls = settings_.smooth_walls && has(Phase::rigid);
  particles_.groups =
      Traits::field_groups(has(Phase::solid), has_smooth_walls, particles_.mirrors.faces != 0);
  std::vector<Medium<Real>> media;
  std::vector<double> masses;
  double finest = 1e300, shortest = 1e300;
  for (const Medium<double>& medium : media_) {
    media.push_back(Medium<Real>::from(medium));
    masses.push_back(medium.mass);
    finest = std::min(finest, medium.spacing);
    if (medium.phase != Phase::rigid)
      shortest = std::min(shortest, medium.smoothing_length / medium.longitudinal_speed);
    runaway_speed_ = std::max(runaway_speed_, 10.0 * medium.longitudinal_speed);
  }
  to_device(media, particles_.media);
  balance_.set_masses(masses);
  shortest_step_ = 1e-6 * settings_.courant * shortest;
  const double skin = list_skin(D) * finest;
  list_ = NeighbourList<D, P, typename Traits::Pairs>(
      minimum_, maximum_, LevelReach::of<D, typename Traits::Pairs>(media_), skin);
  append(std::exchange(settings_.particles, {}));
  close_planes();
}

template <int D, class P, class Traits>
template <class LayOut>
void ParticleRun<D, P, Traits>::open(const LayOut& lay_out) {
  rebuild_list();
  lay_out();
  list_is_due_ = false;
  refresh();  // the initial balance contains the energies of the first forces
  balance_.open(particles_, gravity_);
}

template <int D, class P, class Traits>
void ParticleRun<D, P, Traits>::append(std::vector<NewParticle> newcomers) {
  for (NewParticle& newcomer : newcomers) newcomer.id = next_id_++;
  particles_.append(newcomers, media_);
}

// Particles do not leave the domain through a symmetry plane.
template <int D, class P, class Traits>
void ParticleRun<D, P, Traits>::close_planes() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto& mirrors = particles_.mirrors;
  for (int a = 0; a < D; ++a) {
    if ((mirrors.faces & mirrors.low_face(a)) != 0) minimum_[a] = -infinity;
    if ((mirrors.faces & mirrors.high_face(a)) != 0) maximum_[a] = infinity;
  }
}

template <int D, class P, class Traits>
void ParticleRun<D, P, Traits>::save(Archive& archive) const {
  static_assert(std::is_trivially_copyable_v<Balance> && sizeof(Balance) % sizeof(double) == 0);
  save_fields(particles_, archive);
  archive.arrays["clock"] = std::vector<double>{time_, last_step_.dt};
  archive.arrays["counters"] =
      std::vector<std::uint64_t>{step_, next_id_, list_is_due_ ? 1u : 0u, last_step_.limiting_id};
  archive.texts["limit"] = last_step_.limit;
  std::vector<double> balance(sizeof(Balance) / sizeof(double));
  std::memcpy(balance.data(), &balance_.totals(), sizeof(Balance));
  archive.arrays["balance"] = balance;
  archive.arrays["pair_interactions"] = std::vector<double>{pair_interactions_};
  for (std::size_t j = 0; j < nozzles_.size(); ++j) {
    archive.arrays["nozzle/" + std::to_string(j)] = nozzles_[j].emitted();
    archive.arrays["pump/" + std::to_string(j)] = nozzles_[j].pump().state();
  }
}

template <int D, class P, class Traits>
void ParticleRun<D, P, Traits>::restore(const Archive& archive) {
  restore_fields(archive, particles_);
  const auto& clock = find_array<double>(archive, "clock");
  const auto& counters = find_array<std::uint64_t>(archive, "counters");
  time_ = clock.at(0);
  step_ = counters.at(0);
  next_id_ = static_cast<std::uint32_t>(counters.at(1));
  list_is_due_ = counters.at(2) != 0;
  last_step_ = {clock.at(1), archive.texts.at("limit"), counters.at(3)};
  const auto& numbers = find_array<double>(archive, "balance");
  Balance balance;
  require(numbers.size() * sizeof(double) == sizeof(Balance), "balance length in checkpoint");
  std::memcpy(static_cast<void*>(&balance), numbers.data(), sizeof(Balance));
  balance_.restore(balance);
  pair_interactions_ = find_array<double>(archive, "pair_interactions").at(0);
  for (std::size_t j = 0; j < nozzles_.size(); ++j) {
    nozzles_[j].restore(find_array<std::uint64_t>(archive, "nozzle/" + std::to_string(j)));
    nozzles_[j].restore_pump(find_array<double>(archive, "pump/" + std::to_string(j)));
  }
  // The particles are in the order of the cells of their build positions: the same list results.
  list_.build(particles_);
  after_reorder();
  fresh_ = false;
}

}  // namespace kerf
