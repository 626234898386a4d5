// SPDX-License-Identifier: Apache-2.0
// The set-up of the solids of a run from their members, at the start and where a window of the
// workpiece travels; and their state in a checkpoint.
#pragma once

#include "solid/carry_over.hpp"
#include "standard/solid_part.hpp"

namespace kerf {

template <int D>
SolidLayout<D> solid_layout(const RunSettings& settings, const std::vector<Medium<double>>& media,
                            const MirrorPlanes<D>& mirrors, const SolidMembers<D>& members) {
  SolidLayout<D> layout;
  const auto& origins = settings.origins;
  const auto is_level = [](const MediumOrigin& origin) { return origin.level > 0; };
  if (std::any_of(origins.begin(), origins.end(), is_level))
    for (const MediumOrigin& origin : origins) layout.body.push_back(origin.source);
  layout.media = media;
  layout.mirrors = mirrors;
  layout.regions = settings.bond_regions;
  layout.reference = members.reference;
  layout.medium_index = members.medium_index;
  return layout;
}

template <int D, class P>
SolidPart<D, P>::SolidPart(const RunSettings& settings, const std::vector<Medium<double>>& media,
                           Particles<D, P>& particles)
    : cycle_(settings.subcycles), courant_(settings.courant) {
  const auto position = ranks::collected(to_host(particles.position));  // rank 0 has them
  const auto source = ranks::collected(to_host(particles.source));
  build(settings, media, particles, SolidMembers<D>::at_start(position, source, media));
  if (!solid_) return;
  const HasUnlikeWaves at_joint{pointer(solid_->fields().unlike_media)};
  if (reduce_unordered(solid_->size(), at_joint, false, Either{}))
    wave_ = solid_->wave_time(courant_);  // a first step may be too long
  auto number = members_.number_of_id();
  if (!settings.window) members_ = {};  // only shifts of a window need them again
  number.resize(source.size(), no_index);
  boundaries_.set_up(settings, media, position, source, number,
                     surface_of(solid_->fields(), solid_->view(), body_of_medium_));
  divide();
}

template <int D, class P>
void SolidPart<D, P>::build(const RunSettings& settings, const std::vector<Medium<double>>& media,
                            Particles<D, P>& particles, SolidMembers<D> members) {
  members_ = std::move(members);
  body_of_medium_.clear();
  for (const MediumOrigin& origin : settings.origins) body_of_medium_.push_back(origin.source);
  has_pair_factors_ = false;
  to_device(members_.number_of_id(), number_of_id_);
  particle_of_.assign(members_.size(), no_index);
  if (members_.size() == 0) return;
  solid_ = std::make_unique<TotalLagrangian<D, P>>(
      solid_layout(settings, media, particles.mirrors, members_));
  outflow_.assign(members_.size(), std::uint8_t(0));
  bears_tension_ =
      std::any_of(members_.medium_index.begin(), members_.medium_index.end(),
                  [&](const auto medium) { return media[medium].tensile_excess > 0.0; });
  mark_fitted(media, particles);
}

template <int D, class P>
SolidLosses SolidPart<D, P>::exchange(const RunSettings& settings,
                                      const std::vector<Medium<double>>& media,
                                      Particles<D, P>& particles, SolidMembers<D> members) {
  const SolidLosses held{0.0, solid_->softening_work(), solid_->flow_work()};
  const std::vector<Index> earlier = members_.numbers_of(members.reference);
  solid_->gather_at_all_ranks();
  const auto before = std::move(solid_);
  build(settings, media, particles, std::move(members));
  solid_->restore(carry_over(*before, *solid_, earlier));
  divide();
  move_boundaries(settings, media);
  find_particles(particles);  // those that the cut at the rear detaches have further neighbours
  return held;
}

template <int D, class P>
void SolidPart<D, P>::settle(Particles<D, P>& particles, const SolidLosses& held) {
  deform_to_current(particles);
  losses_.released += held.released - solid_->softening_work();
  losses_.plastic += held.plastic - solid_->flow_work();
  wave_ = solid_->wave_time(courant_);
}

template <int D, class P>
void SolidPart<D, P>::mark_fitted(const std::vector<Medium<double>>& media,
                                  Particles<D, P>& particles) {
  if (solid_->fitted().empty()) return;
  auto flags = to_host(particles.flags);
  const auto id = to_host(particles.id);
  const auto number = members_.number_of_id();
  const auto has_factors = [&](Index s) {
    return solid_->fitted()[s] != 0 && media[members_.medium_index[s]].excess_bulk_modulus != 0.0;
  };
  for (Index s = 0; s < solid_->size(); ++s) has_pair_factors_ |= has_factors(s);
  for (std::size_t i = 0; i < id.size(); ++i) {
    if (id[i] >= number.size() || number[id[i]] == no_index) continue;
    flags[i] = static_cast<std::uint8_t>(flags[i] & ~flag::fitted);
    if (has_factors(number[id[i]])) flags[i] |= flag::fitted;
  }
  to_device(flags, particles.flags);
}

template <int D, class P>
void SolidPart<D, P>::save(Archive& archive) const {
  archive.arrays["solid/losses"] =
      std::vector<double>{losses_.viscous, losses_.released, losses_.plastic};
  if (!solid_) return;
  boundaries_.save(archive);
  const SolidState<D, P> state = solid_->save();
  archive.arrays["solid/wave"] =
      std::vector<double>{wave_.time, double(wave_.particle), double(wave_.of_joint)};
  archive.arrays["solid/cycle"] = cycle_.save();
  archive.arrays["solid/viscous_power"] = std::vector<double>{viscous_power_};
  archive.arrays["solid/acceleration"] = flat<Real>(state.acceleration);
  archive.arrays["solid/mirror_acceleration"] = flat<Real>(state.mirror_acceleration);
  archive.arrays["solid/bonds"] = state.bond_intact;
  archive.arrays["solid/elastic_share"] = state.elastic_share;
  archive.arrays["solid/flow"] = flat<Real>(state.flow);
  archive.arrays["solid/softening"] = state.strain;
  archive.arrays["solid/flaws"] = flat<Real>(state.flaws);
  archive.arrays["solid/loading"] = flat<Real>(state.loading);
}

template <int D, class P>
void SolidPart<D, P>::restore(const Archive& archive) {
  const auto& losses = find_array<double>(archive, "solid/losses");
  losses_ = {losses.at(0), losses.at(1), losses.at(2)};
  if (!solid_) return;
  boundaries_.restore(archive);
  const auto& wave = find_array<double>(archive, "solid/wave");
  wave_ = {wave.at(0), static_cast<Index>(wave.at(1)), wave.at(2) != 0.0};
  cycle_.restore(find_array<double>(archive, "solid/cycle"));
  viscous_power_ = find_array<double>(archive, "solid/viscous_power").at(0);
  const auto speeds = [&](const char* name) {
    return unflat<Vector<D, Real>>(find_array<Real>(archive, name));
  };
  solid_->restore({find_array<std::uint32_t>(archive, "solid/bonds"),
                   find_array<Real>(archive, "solid/elastic_share"), speeds("solid/acceleration"),
                   speeds("solid/mirror_acceleration"),
                   unflat<PlasticState<D, Real>>(find_array<Real>(archive, "solid/flow")),
                   find_array<Real>(archive, "solid/softening"),
                   unflat<FlawState<Real>>(find_array<Real>(archive, "solid/flaws")),
                   unflat<Loading<Real>>(find_array<Real>(archive, "solid/loading"))});
}

}  // namespace kerf
