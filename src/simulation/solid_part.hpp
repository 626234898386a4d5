// SPDX-License-Identifier: Apache-2.0
// The solids of a run of the `standard` formulation: carries places and speeds over to the
// total Lagrangian solid and its forces back, and keeps its share of the ledger and the checkpoint.
#pragma once

#include <algorithm>
#include <memory>
#include <utility>

#include "integrate/solid_cycle.hpp"
#include "rates/pair_fit.hpp"
#include "simulation/absorbing_sites.hpp"
#include "simulation/flaw_media.hpp"
#include "simulation/ledger.hpp"
#include "simulation/levels.hpp"
#include "simulation/media.hpp"
#include "simulation/plastic_media.hpp"
#include "simulation/solid_link.hpp"
#include "simulation/solid_show.hpp"
#include "simulation/state_io.hpp"
#include "solid/total_lagrangian.hpp"

namespace kerf {

// What the solids gave up so far, J (2D: J/m).
struct SolidLosses {
  double viscous = 0.0;              // by the viscosity of bonds
  double released = 0.0;             // by bonds that broke, and by damage
  double plastic = 0.0;              // by plastic flow
  std::array<double, 3> absorbed{};  // N s, impulse of absorbing faces on them
};

template <int D, class P>
class SolidPart {
 public:
  using Real = typename P::Real;

  // The particles of the start, in the order of their ids.
  SolidPart(const Case& description, const std::vector<Medium<double>>& media,
            Particles<D, P>& particles)
      : cycle_(description.numerics.subcycles) {
    SolidLayout<D> layout;
    const auto origins = medium_origins(description);
    const auto is_level = [](const MediumOrigin& origin) { return origin.level > 0; };
    if (std::any_of(origins.begin(), origins.end(), is_level))
      for (const MediumOrigin& origin : origins) layout.body.push_back(origin.source);
    layout.plastic = make_plastic_media(description);
    layout.flaws = make_flaw_media(description, media);
    for (const Medium<double>& medium : media) layout.media.push_back(solid_medium(medium));
    layout.mirrors = particles.mirrors;
    const auto position = to_host(particles.position);
    const auto source = to_host(particles.source);
    std::vector<Index> number(source.size(), no_index);
    for (std::size_t id = 0; id < source.size(); ++id) {
      if (media[source[id]].phase != Phase::solid) continue;
      number[id] = static_cast<Index>(layout.reference.size());
      layout.reference.push_back(position[id]);
      layout.medium_index.push_back(source[id]);
    }
    to_device(number, number_of_id_);
    particle_of_.resize(layout.reference.size());
    if (layout.reference.empty()) return;
    solid_ = std::make_unique<TotalLagrangian<D, P>>(layout);
    gone_.resize(layout.reference.size());
    mark_fitted(number, particles);
    to_device(absorbing_sites<D>(description, media, position, source, number), sites_);
  }

  // Finds the solid's particles in their new order, of which there is a new list.
  void find(Particles<D, P>& particles, const NeighbourView& list) {
    if (!solid_) return;
    thrust::fill(particle_of_.begin(), particle_of_.end(), no_index);
    for_each_index(particles.size(), FindSolids<D, P>{particles.view(), link()});
    show_loose(particles);
    held_.resize(particles.size());
    thrust::fill(held_.begin(), held_.end(), std::uint8_t(0));
    for_each_index(solid_->size(),
                   FindHeld<D, P>{particles.view(), link(), solid_->view(), list, pointer(held_)});
  }
  // The list without what bonds hold, in walks that skip kin.
  NeighbourView without_held(NeighbourView list) const {
    list.held = solid_ ? pointer(held_) : nullptr;
    return list;
  }

  // Does the step in hand begin one of the solid (integrate/solid_cycle.hpp)?
  bool begins() const { return solid_ && cycle_.begins(); }

  // In the middle of the first step, of `dt`, of one of the solid: as it will be in the middle of
  // that.
  void begin(Particles<D, P>& particles, double dt) {
    if (!begins()) return;
    cycle_.begin(dt, longest_);
    deform(particles, cycle_.length(), cycle_.ahead(dt));
  }
  // Where the particles are now.
  void deform_now(Particles<D, P>& particles) {
    if (solid_) deform(particles, std::max(0.0, cycle_.since_middle()), 0.0);
  }

  // Breaks what is strained too far; the deformation must be that of begin().
  void break_bonds(Particles<D, P>& particles) {
    if (!begins()) return;
    const FractureBook book = solid_->fracture();
    // The whole kick of the step is without the broken bonds, as if they broke at its start, when
    // they had stored less by what they took up since.
    losses_.released -= 0.5 * cycle_.length() * book.power_gain;
    take(book, particles);
  }

  // Adds the accelerations by all bonds, which in a step that goes on are those of its beginning,
  // and by absorbing faces.
  void accelerate(Particles<D, P>& particles) {
    if (!solid_) return;
    const AddSolidAcceleration<D, P> add{particles.view(), link(), solid_->view()};
    if (cycle_.begins())
      solid_->accelerate(EveryBond{}, add);
    else
      for_each_index(solid_->size(), add);
    for_each_index(sites(), Absorb<D, P>{particles.view(), pointer(particle_of_), no_index,
                                         pointer(solid_->fields().loose), pointer(sites_)});
  }
  // Those by the bonds that `filter` chooses by their particles, at the deformation in force.
  template <class Filter>
  void accelerate(Particles<D, P>& particles, const Filter& filter) {
    if (!solid_) return;
    solid_->keeping_accelerations([&] {
      solid_->accelerate(BondFilter<D, P, Filter>{particles.view(), link(), filter},
                         AddSolidAcceleration<D, P>{particles.view(), link(), solid_->view()});
    });
  }

  // Puts the pressure of the solid at the deformation in force on its particles, for probes.
  void show_pressure(Particles<D, P>& particles) {
    if (!solid_) return;
    for_each_index(solid_->size(), ShowPressure<D, P>{particles.view(), link(), solid_->view()});
  }

  // Particles that are about to be removed let go of the others, at the end of a step.
  void let_go_of_leavers(Particles<D, P>& particles) {
    if (!solid_) return;
    for_each_index(solid_->size(),
                   FindLeavers<D, P>{particles.view(), link(), solid_->view(), pointer(gone_)});
    if (!reduce_unordered(solid_->size(), IsSet{pointer(gone_)}, false, Either{})) return;
    if (!cycle_.has_just_begun()) deform_now(particles);
    take(solid_->let_go(gone_), particles);
    if (!cycle_.begins()) solid_->accelerate();  // by the bonds that are left
  }

  // Whether particles came loose since the last call.
  bool take_loosened() { return std::exchange(loosened_, false); }

  WholeBonds<D, P> bonds() {
    if (!solid_) return {};
    return {link(), solid_->view()};
  }

  // Where the spacing of a nearly incompressible body jumps.
  PairFit<D, P> pair_fit() {
    if (!solid_ || solid_->fitted().empty()) return {};
    const auto solid = solid_->view();
    return {solid.pair_fit, pointer(number_of_id_), solid.bonds};
  }

  void end_step(double dt) {
    if (!solid_) return;
    if (cycle_.begins()) book_bonds();
    losses_.viscous += dt * viscous_power_;
    const Terms<D> force = force_sum_(sites(), AbsorbingForce<D>{pointer(sites_)});
    for (int a = 0; a < D; ++a)
      losses_.absorbed[static_cast<std::size_t>(a)] += dt * force.value[a];
    cycle_.end_step(dt);
  }
  // What the waves of the solid allow for the next step, by its shape in the middle of its last
  // one. None of its steps takes longer than `most`, s.
  StepLimit step_limit(double courant, double most) {
    if (!solid_) return {wave_.time, Limit::acoustic_solid, 0};
    const bool is_known = wave_.time < not_known_yet.time;
    longest_ = is_known ? std::min(courant * wave_.time, most) : 0.0;
    const Index particle = particle_of_[wave_.particle];
    return cycle_.limit(
        {courant * wave_.time, Limit::acoustic_solid, particle == no_index ? 0 : particle});
  }
  void book(Ledger& ledger) {
    ledger.dissipated_artificial += losses_.viscous;
    ledger.dissipated_fracture += losses_.released;
    ledger.dissipated_plastic += losses_.plastic;
    for (std::size_t a = 0; a < 3; ++a) ledger.impulse_constraint[a] += losses_.absorbed[a];
    if (!solid_) return;
    ledger.dissipated_plastic += solid_->flow_work();
    ledger.dissipated_fracture += solid_->softening_work();
    const SolidEnergy energy = solid_->energy();
    ledger.elastic_strain = energy.elastic;
    ledger.hourglass = energy.hourglass;
  }
  void show(Frame& frame) const {
    if (solid_) show_solid(solid_->fields(), number_of_id_, frame);
  }

  std::uint64_t bond_entries() const { return solid_ ? solid_->entries() : 0; }
  std::size_t bytes() const {
    const std::size_t links = (number_of_id_.size() + particle_of_.size()) * sizeof(Index);
    return links + gone_.size() + held_.size() + sites_.size() * sizeof(AbsorbingSite<D>) +
           (solid_ ? solid_->bytes() : 0);
  }

  void save(Archive& archive) const {
    archive.arrays["solid/losses"] =
        std::vector<double>{losses_.viscous, losses_.released, losses_.plastic};
    archive.arrays["solid/absorbed"] =
        std::vector<double>(losses_.absorbed.begin(), losses_.absorbed.end());
    if (!solid_) return;
    const SolidState<D, P> state = solid_->save();
    archive.arrays["solid/wave"] = std::vector<double>{wave_.time, double(wave_.particle)};
    archive.arrays["solid/cycle"] = cycle_.save();
    archive.arrays["solid/viscous_power"] = std::vector<double>{viscous_power_};
    archive.arrays["solid/acceleration"] = flat<Real>(state.acceleration);
    archive.arrays["solid/mirror_acceleration"] = flat<Real>(state.mirror_acceleration);
    archive.arrays["solid/bonds"] = state.whole;
    archive.arrays["solid/flow"] = flat<Real>(state.flow);
    archive.arrays["solid/softening"] = state.strain;
    archive.arrays["solid/flaws"] = flat<Real>(state.flaws);
  }
  void restore(const Archive& archive) {
    const auto& losses = find_array<double>(archive, "solid/losses");
    losses_ = {losses.at(0), losses.at(1), losses.at(2), {}};
    const auto& absorbed = find_array<double>(archive, "solid/absorbed");
    for (std::size_t a = 0; a < 3; ++a) losses_.absorbed[a] = absorbed.at(a);
    if (!solid_) return;
    const auto& wave = find_array<double>(archive, "solid/wave");
    wave_ = {wave.at(0), static_cast<Index>(wave.at(1))};
    cycle_.restore(find_array<double>(archive, "solid/cycle"));
    viscous_power_ = find_array<double>(archive, "solid/viscous_power").at(0);
    const auto speeds = [&](const char* name) {
      return unflat<Vector<D, Real>>(find_array<Real>(archive, name));
    };
    solid_->restore({find_array<std::uint32_t>(archive, "solid/bonds"),
                     speeds("solid/acceleration"), speeds("solid/mirror_acceleration"),
                     unflat<PlasticState<D, Real>>(find_array<Real>(archive, "solid/flow")),
                     find_array<Real>(archive, "solid/softening"),
                     unflat<FlawState<Real>>(find_array<Real>(archive, "solid/flaws"))});
  }

 private:
  void mark_fitted(const std::vector<Index>& number_of_id, Particles<D, P>& particles) {
    if (solid_->fitted().empty()) return;
    auto flags = to_host(particles.flags);
    for (std::size_t id = 0; id < number_of_id.size(); ++id)
      if (number_of_id[id] != no_index && solid_->fitted()[number_of_id[id]] != 0)
        flags[id] |= flag::fitted;
    to_device(flags, particles.flags);
  }
  // Books the step of the solid that begins, and lets it flow, soften and take damage for it.
  void book_bonds() {
    viscous_power_ = solid_->viscous_power();
    losses_.plastic += solid_->keep_flow();
    losses_.released += solid_->keep_softening();
    losses_.released += solid_->keep_damage(cycle_.length_to_book());
    wave_ = solid_->wave_time();
  }

  // `dt` after the last book_bonds().
  void deform(Particles<D, P>& particles, double dt, double ahead) {
    solid_->take(MotionOfParticles<D, P>{particles.view(), link(), ahead});
    solid_->deform(dt);
  }
  void take(const FractureBook& book, Particles<D, P>& particles) {
    losses_.released += book.released;
    if (book.bonds > 0)
      for_each_index(solid_->size(), LetGoOfTorn<D, P>{link(), solid_->view(), pointer(held_)});
    if (book.loosened == 0) return;
    loosened_ = true;
    show_loose(particles);
  }
  Index sites() const { return static_cast<Index>(sites_.size()); }
  SolidIndexView link() const {
    return {pointer(number_of_id_), static_cast<Index>(number_of_id_.size()),
            const_cast<Index*>(pointer(particle_of_))};
  }
  void show_loose(Particles<D, P>& particles) {
    for_each_index(solid_->size(), MarkLoose<D, P>{particles.view(), link(), solid_->view()});
  }

  std::unique_ptr<TotalLagrangian<D, P>> solid_;
  Array<Index> number_of_id_, particle_of_;
  Array<std::uint8_t> gone_, held_;
  Array<AbsorbingSite<D>> sites_;
  OrderedSum<D> force_sum_;
  SolidLosses losses_;
  SolidCycle cycle_;
  double longest_ = 0.0;        // s, what a step of the solid may take
  double viscous_power_ = 0.0;  // W, of the bonds in the step of the solid in hand
  static constexpr WaveTime not_known_yet{1e300, 0};
  WaveTime wave_ = not_known_yet;
  bool loosened_ = false;
};

}  // namespace kerf
