// SPDX-License-Identifier: Apache-2.0
// Some stages of a step of SolidPart: the accelerations by bonds, the end of a step of the solid,
// outflow, and the limit of the next step.
#pragma once

#include "standard/solid_part.hpp"

namespace kerf {

template <int D, class P>
void SolidPart<D, P>::accelerate_by_all(Particles<D, P>& particles,
                                        const Vector<D, Real>* velocity) {
  if (!solid_) return;
  const AddSolidAcceleration<D, P> add{particles.view(), link(), solid_->view()};
  if (is_divided())
    accelerate_divided(add);
  else if (cycle_.is_first_substep())
    solid_->accelerate(EveryBond{}, add);
  else
    for_each_index(solid_->size(), add);
  boundaries_.accelerate(particles, velocity, link(), solid_->fields());
}

template <int D, class P>
void SolidPart<D, P>::finish_solid_step(Particles<D, P>& particles) {
  viscous_power_ = solid_->viscous_power();
  losses_.plastic += solid_->keep_flow();
  solid_->keep_loading();
  losses_.released += solid_->keep_softening();
  losses_.released += solid_->keep_damage(cycle_.take_length());
  open_damaged(particles);
  turn_faces(particles);
  wave_ = solid_->wave_time(courant_);
}

template <int D, class P>
void SolidPart<D, P>::take(const FractureResult& result, Particles<D, P>& particles, bool in_step) {
  losses_.released += result.released;
  if (result.bonds > 0)
    for_each_index(solid_->size(),
                   UnmarkBroken<D, P>{link(), solid_->view(), pointer(fully_bonded_)});
  if (result.detached > 0) {
    has_detached_ = true;
    mark_detached(particles, in_step);
  }
  if (result.bonds > 0 && !in_step) open_damaged(particles);
}

template <int D, class P>
void SolidPart<D, P>::open_damaged(Particles<D, P>& particles) {
  if (!bears_tension_) return;
  OpenDamaged<D, P> open{particles.view(), link(), solid_->view()};
  if (is_divided()) open.damaged = damaged_divided();
  losses_.released += sum_of(open);
}

template <int D, class P>
void SolidPart<D, P>::turn_faces(Particles<D, P>& particles) {
  if (!particles.groups.smooth_walls) return;
  TurnFaces<D, P> turn{particles.view(), link(), solid_->view()};
  if (is_divided()) {
    turn.damaged = damaged_divided();
    turn.gradient = gradient_divided();
  }
  for_each_index(solid_->size(), turn);
}

template <int D, class P>
void SolidPart<D, P>::mark_detached(Particles<D, P>& particles, bool in_step) {
  losses_.released -= sum_of(
      MarkDetached<D, P>{particles.view(), link(), solid_->view(), solid_->records(), in_step});
}

template <int D, class P>
void SolidPart<D, P>::remove_outflow(Particles<D, P>& particles) {
  if (!solid_) return;
  for_each_index(solid_->size(), MarkBondedOutflow<D, P>{particles.view(), link(), solid_->view(),
                                                         pointer(outflow_)});
  if (is_divided()) mark_at_all_ranks(outflow_);
  if (!reduce_unordered(solid_->size(), IsSet{pointer(outflow_)}, false, Either{})) return;
  if (!cycle_.was_first_substep()) deform_to_current(particles);
  take(solid_->break_all_bonds_of(outflow_), particles, false);
  if (!cycle_.is_first_substep()) solid_->accelerate();  // by the bonds that are left
}

template <int D, class P>
StepLimit SolidPart<D, P>::step_limit(double most) {
  const Limit limit = wave_.of_joint ? Limit::joint : Limit::acoustic_solid;
  if (!solid_) return {wave_.time, limit, 0};
  const bool is_known = wave_.time < unknown_wave.time;
  longest_step_ = is_known ? std::min(courant_ * wave_.time, most) : 0.0;
  const Index particle = particle_of_[wave_.particle];
  const bool has_left = particle == no_index && !is_divided();
  return cycle_.limit({courant_ * wave_.time, limit, has_left ? 0 : particle});
}

}  // namespace kerf
