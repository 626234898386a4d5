// SPDX-License-Identifier: Apache-2.0
// How a run comes to be: from a case, or from a checkpoint.
#pragma once

#include <algorithm>
#include <cstring>
#include <limits>
#include <type_traits>

#include "neighbours/skin.hpp"
#include "simulation/media.hpp"
#include "simulation/particle_run.hpp"
#include "simulation/populate.hpp"
#include "simulation/state_io.hpp"
#include "simulation/symmetry.hpp"

namespace kerf {

inline std::vector<Nozzle> make_nozzles(const Case& description) {
  std::vector<Nozzle> nozzles;
  for (const Jet& jet : description.jets) {
    nozzles.emplace_back(jet,
                         description.materials.at(static_cast<std::size_t>(jet.material)).density,
                         description.dimension);
    nozzles.back().cut_at(description.symmetry, description.domain);
  }
  return nozzles;
}

template <int D, class P, class Scheme>
ParticleRun<D, P, Scheme>::ParticleRun(const Case& description)
    : case_(description),
      nozzles_(make_nozzles(description)),
      media_(make_media(description, nozzles_)),
      motion_(case_, nozzles_),
      gravity_(Place::from(description.gravity)),
      minimum_(Place::from(description.domain.minimum)),
      maximum_(Place::from(description.domain.maximum)) {
  particles_.mirrors = mirror_planes<D>(description);
  const bool has_solids = std::any_of(media_.begin(), media_.end(), [](const auto& medium) {
    return medium.phase == Phase::solid;
  });
  particles_.groups = {Scheme::stress_by_rate, !Scheme::stress_by_rate && has_solids,
                       particles_.mirrors.faces != 0};
  const std::vector<NewParticle> laid_out = initial_particles(case_, nozzles_);
  join_mirrors(particles_.mirrors, laid_out, media_);
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
  book_.set_masses(masses);
  shortest_step_ = 1e-6 * case_.time.courant * shortest;
  const double skin = list_skin(D) * finest;
  list_ = NeighbourList<D, P, Scheme>(minimum_, maximum_, LevelReach::of<D, Scheme>(media_), skin);
  append(laid_out);
  close_planes();
}

template <int D, class P, class Scheme>
template <class LayOut>
void ParticleRun<D, P, Scheme>::open(const LayOut& lay_out) {
  rebuild_list();
  lay_out();
  list_is_due_ = false;
  refresh();  // the ledger opens with what the first forces hold
  book_.open(particles_, gravity_);
}

template <int D, class P, class Scheme>
void ParticleRun<D, P, Scheme>::append(const std::vector<NewParticle>& newcomers) {
  const Index before = particles_.size();
  const auto count = static_cast<Index>(newcomers.size());
  particles_.resize(before + count);
  std::vector<Place> position;
  std::vector<Vector<D, Real>> velocity;
  std::vector<Real> inlet_speed, compression, pressure_work;
  std::vector<std::uint32_t> id;
  std::vector<std::uint16_t> source;
  std::vector<std::uint8_t> flags;
  for (const NewParticle& particle : newcomers) {
    position.push_back(Place::from(particle.position));
    velocity.push_back(Vector<D, Real>::from(particle.velocity));
    inlet_speed.push_back(static_cast<Real>(particle.inlet_speed));
    const Medium<double>& medium = media_[particle.source];
    compression.push_back(static_cast<Real>(medium.initial_compression));
    pressure_work.push_back(static_cast<Real>(Tait::energy(medium, medium.initial_compression)));
    id.push_back(next_id_++);
    source.push_back(particle.source);
    flags.push_back(particle.flags);
  }
  thrust::copy(position.begin(), position.end(), particles_.position.begin() + before);
  thrust::copy(position.begin(), position.end(), particles_.build_position.begin() + before);
  thrust::copy(velocity.begin(), velocity.end(), particles_.velocity.begin() + before);
  thrust::copy(inlet_speed.begin(), inlet_speed.end(), particles_.inlet_speed.begin() + before);
  thrust::copy(compression.begin(), compression.end(), particles_.compression.begin() + before);
  thrust::copy(pressure_work.begin(), pressure_work.end(),
               particles_.pressure_work.begin() + before);
  thrust::copy(id.begin(), id.end(), particles_.id.begin() + before);
  thrust::copy(source.begin(), source.end(), particles_.source.begin() + before);
  thrust::copy(flags.begin(), flags.end(), particles_.flags.begin() + before);
  thrust::fill_n(particles_.compression_rate.begin() + before, count, Real(0));
  thrust::fill_n(particles_.wall_normal.begin() + before, count, Vector<D, Real>::zero());
  thrust::fill_n(particles_.last_acceleration.begin() + before, count, Vector<D, Real>::zero());
  if (particles_.groups.touch) {
    thrust::fill_n(particles_.solid_fit.begin() + before, count, Real(1));
    thrust::fill_n(particles_.rigid_fit.begin() + before, count, Real(1));
  }
  if (particles_.groups.rate_stress)
    thrust::fill_n(particles_.shear.begin() + before, count, SymmetricTensor<D, Real>::zero());
  thrust::fill_n(particles_.fractured.begin() + before, count, std::uint8_t(0));
}

// Nothing leaves by a symmetry plane.
template <int D, class P, class Scheme>
void ParticleRun<D, P, Scheme>::close_planes() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto& mirrors = particles_.mirrors;
  for (int a = 0; a < D; ++a) {
    if ((mirrors.faces & mirrors.low_face(a)) != 0) minimum_[a] = -infinity;
    if ((mirrors.faces & mirrors.high_face(a)) != 0) maximum_[a] = infinity;
  }
}

template <int D, class P, class Scheme>
void ParticleRun<D, P, Scheme>::save(Archive& archive) const {
  static_assert(std::is_trivially_copyable_v<Ledger> && sizeof(Ledger) % sizeof(double) == 0);
  save_fields(particles_, archive);
  archive.arrays["clock"] = std::vector<double>{time_, last_step_.dt};
  archive.arrays["counters"] =
      std::vector<std::uint64_t>{step_, next_id_, list_is_due_ ? 1u : 0u, last_step_.limiting_id};
  archive.texts["limit"] = last_step_.limit;
  std::vector<double> ledger(sizeof(Ledger) / sizeof(double));
  std::memcpy(ledger.data(), &book_.totals(), sizeof(Ledger));
  archive.arrays["ledger"] = ledger;
  archive.arrays["pair_interactions"] = std::vector<double>{pair_interactions_};
  for (std::size_t j = 0; j < nozzles_.size(); ++j)
    archive.arrays["nozzle/" + std::to_string(j)] = nozzles_[j].emitted();
}

template <int D, class P, class Scheme>
void ParticleRun<D, P, Scheme>::restore(const Archive& archive) {
  restore_fields(archive, particles_);
  const auto& clock = find_array<double>(archive, "clock");
  const auto& counters = find_array<std::uint64_t>(archive, "counters");
  time_ = clock.at(0);
  step_ = counters.at(0);
  next_id_ = static_cast<std::uint32_t>(counters.at(1));
  list_is_due_ = counters.at(2) != 0;
  last_step_ = {clock.at(1), archive.texts.at("limit"), counters.at(3)};
  const auto& numbers = find_array<double>(archive, "ledger");
  Ledger ledger;
  require(numbers.size() * sizeof(double) == sizeof(Ledger), "ledger length in checkpoint");
  std::memcpy(static_cast<void*>(&ledger), numbers.data(), sizeof(Ledger));
  book_.restore(ledger);
  pair_interactions_ = find_array<double>(archive, "pair_interactions").at(0);
  for (std::size_t j = 0; j < nozzles_.size(); ++j)
    nozzles_[j].restore(find_array<std::uint64_t>(archive, "nozzle/" + std::to_string(j)));
  // The particles are in the order of the cells of their build positions: the same list results.
  list_.build(particles_);
  after_reorder();
  fresh_ = false;
}

}  // namespace kerf
