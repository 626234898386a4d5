// SPDX-License-Identifier: Apache-2.0
// The set-up of a run from its settings. particle_run_checkpoint.hpp sets it up from a checkpoint.
#pragma once

#include <algorithm>
#include <limits>
#include <utility>

#include "neighbours/skin.hpp"
#include "simulation/particle_run.hpp"
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
  const bool has_smooth_walls =
      settings_.smooth_walls && has(Phase::water) && (has(Phase::rigid) || has(Phase::solid));
  particles_.groups =
      Traits::field_groups(has(Phase::solid), has_smooth_walls, particles_.mirrors.faces != 0);
  for (std::size_t medium = 0; medium < media_.size(); ++medium)
    particles_.groups.moving_walls |=
        media_[medium].phase == Phase::rigid && settings_.motion.moves(medium);
  particles_.groups.sleep &= settings_.sleep && settings_.loads.empty();
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
  double step = 0.0;  // m, of the fastest jet
  for (std::size_t j = 0; j < nozzles_.size(); ++j) {
    const Medium<double>& water = media_[first_jet() + j];
    const double speed = nozzles_[j].fastest();
    step = std::max(
        step, settings_.courant * water.smoothing_length * speed / (water.sound_speed + speed));
  }
  const double skin = list_skin(D, step / finest) * finest;
  list_ = NeighbourList<D, P, typename Traits::Pairs>(
      minimum_, maximum_, LevelReach::of<D, typename Traits::Pairs>(media_), skin);
  particles_.sum_groups.set_rows(list_.grids().rows());
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
  if constexpr (ranks::exist)
    std::erase_if(newcomers, [this](const NewParticle& newcomer) {
      return !decomposition_.owns(list_.grids(), Position::from(newcomer.position));
    });
  particles_.append(newcomers, media_);
}

template <int D, class P, class Traits>
void ParticleRun<D, P, Traits>::move_domain(std::uint64_t shifts) {
  shifts_ = shifts;
  const TravellingFrame& frame = settings_.window->frame;
  const int axis = D == 2 ? 0 : static_cast<int>(frame.axis);
  auto corner = Position::from(settings_.domain_minimum);
  corner[axis] += frame.offset(shifts);
  minimum_[axis] = corner[axis];
  maximum_[axis] = settings_.domain_maximum[frame.axis] + frame.offset(shifts);
  list_.move_to(corner);
  fresh_ = false;
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

}  // namespace kerf
