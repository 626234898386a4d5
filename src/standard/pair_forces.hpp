// SPDX-License-Identifier: Apache-2.0
// The pair sums of the `standard` formulation over the current positions: fluid, fluid against
// solids and walls, contact of solids. The forces inside a solid are not among them: they are sums
// over the bonds of its reference shape (solid/).
#pragma once

#include "contact/debris_contact.hpp"
#include "contact/surface_contact.hpp"
#include "fluid/concentration_gradient.hpp"
#include "fluid/delta_sph.hpp"
#include "fluid/density_gradient.hpp"
#include "fluid/fluid_continuity.hpp"
#include "fluid/fluid_force.hpp"
#include "fluid/fluid_pressure.hpp"
#include "fluid/gradient_at_wall.hpp"
#include "fluid/gradient_in_corner.hpp"
#include "fluid/lattice_sums.hpp"
#include "fluid/particle_concentration.hpp"
#include "fluid/simd/simd_pairs.hpp"
#include "fluid/smooth_wall.hpp"
#include "fluid/wall_reaction.hpp"
#include "fluid/water_viscosity.hpp"
#include "kernels/wendland_c2.hpp"
#include "materials/equation_of_state.hpp"
#include "pairs/body_force.hpp"
#include "pairs/pair_loop.hpp"
#include "standard/rigid_power.hpp"

namespace kerf {

// A loop over the particles of solids alone. Those that sleep are in no contact.
template <int D, class P, class Loop>
struct OfSolids {
  ParticleView<D, P> particles;
  Loop loop;

  KERF_FUNCTION void operator()(Index i) const {
    if (particles.is_asleep(i))
      particles.solid_contact[i] = particles.rigid_contact[i] =
          ContactState<D, typename P::Real>::none();
    else if (particles.medium(i).phase == Phase::solid)
      loop(i);
  }
};

template <int D, class P>
class StandardRates {
 public:
  using Real = typename P::Real;

  StandardRates(const Vector<D, double>& gravity, const std::vector<Medium<double>>& media,
                const LatticeSums& lattice = {}, WaterScheme scheme = WaterScheme::riemann)
      : gravity_{Vector<D, Real>::from(gravity)},
        fluid_pair_{gravity_.gravity, Real(1.0 / lattice.slope), {}, scheme},
        media_(static_cast<Index>(media.size())) {
    std::vector<ContactOfMedia<Real>> entries;
    for (const auto& entry : contact_table<D, ContactPairs>(media))
      entries.push_back(
          {static_cast<Real>(entry.inverse_kernel_sum), static_cast<Real>(entry.stiffness)});
    to_device(entries, contacts_);
    for (const auto& medium : media) {
      if (medium.phase != Phase::solid) continue;
      has_solids_ = true;
      apart_from_images_ |= ~medium.joined_mirrors;
      for (const auto& other : media)
        has_bodies_apart_ |= other.phase != Phase::water && other.piece != medium.piece;
    }
    if (separates_fluids())
      simd_pairs_ = SimdPairs<D, P>(media, 1.0 / lattice.slope, gravity_.gravity);
  }

  // Whether the pairs of fluids are summed by kernels of their own, for which they have to come
  // first in the list.
  bool separates_fluids() const { return fluid_pair_.scheme == WaterScheme::riemann; }

  // Sets the gradient correction of bodies whose spacing jumps.
  void set_pair_correction(const PairCorrection<D, P>& correction) {
    fluid_pair_.correction = correction;
  }

  // Must be called for each new list; given `listed_anew`, only the lists of the particles marked
  // there are new.
  void take_list(const ParticleView<D, P>& view, Index count, const NeighbourView& list,
                 const std::uint8_t* listed_anew = nullptr) {
    if constexpr (simd_exists)
      if (separates_fluids())
        simd_pairs_.graded().take(view, count, list, fluid_pair_.correction, listed_anew);
  }

  // Finds the contacts of the surfaces of solids, which all evaluations need. Returns whether there
  // may be any.
  bool find_contacts(const ParticleView<D, P>& view, Index count, const NeighbourView& list) const {
    const bool may_be = may_touch(view);
    if (may_be) sum_surface_overlaps(view, count, list, {contacts()});
    return may_be;
  }

  // Finds the density gradients of water, where evaluate() needs them. Returns whether it does.
  bool find_density_gradients(const ParticleView<D, P>& view, Index count,
                              const NeighbourView& list) {
    if (fluid_pair_.scheme != WaterScheme::delta_sph) return false;
    density_gradient_.resize(count + view.ghosts.count);
    for_each_index(count, PairLoop<D, P, ContactPairs, DensityGradient<D, P>>(
                              view, list, {}, {pointer(density_gradient_)}));
    return true;
  }
  Array<Vector<D, Real>>& density_gradients() { return density_gradient_; }  // 1/m

  // Evaluates what a step needs in one pair loop: pressures, the accelerations by gravity and all
  // pairs, the rates of compression, the kernel sums and the concentration gradients;
  // complete_at_walls() must follow, as after accelerate().
  template <class Bonds>
  void evaluate(const ParticleView<D, P>& view, Index count, const NeighbourView& list,
                const Bonds& bonds, ConcentrationGradient<D, Real>* concentration_gradient) const {
    const LoopInput input{view, count, list};
    if (fluid_pair_.scheme == WaterScheme::riemann) {
      sum_pairs(input, bonds, FluidContinuity<D, P>{fluid_pair_}, SmoothWalls{}, KernelSum{},
                ConcentrationGradientSum<D, P>{concentration_gradient});
    } else {
      update_pressures(input);
      run_loop(input, bonds, EveryPair{}, gravity_, FluidContinuity<D, P>{fluid_pair_},
               SmoothWalls{}, KernelSum{}, ConcentrationGradientSum<D, P>{concentration_gradient},
               DensityDiffusion<D, P>{pointer(density_gradient_)});
    }
  }

  // Finds the power of rigid bodies that move, after all forces.
  void find_rigid_power(const ParticleView<D, P>& view, Index count,
                        const NeighbourView& list) const {
    if (view.rigid_power == nullptr) return;
    using Loop = PairLoop<D, P, ContactPairs, RigidPowerSum<D, P>>;
    NeighbourView others = list;
    others.skips = Skips::of_fluids_and_body;
    const RigidPowerSum<D, P> term{
        {fluid_pair_}, {fluid_pair_.kernel_gradient_normalisation}, {contacts()}};
    for_each_index(count, Loop(view, others, {}, term));
  }

  // Adds what smooth walls lack to the rates of fluid, after the sums over pairs: to all of them
  // after evaluate(), to accelerations after accelerate(). Returns whether solids take a reaction,
  // by react_at_walls(), for which ghosts need the field `wall_push`.
  bool complete_at_walls(const ParticleView<D, P>& view, Index count, const NeighbourView& list,
                         WallCompletion completion) const {
    if (!has_smooth_walls(view)) return false;
    using Loop = PairLoop<D, P, ContactPairs, GradientAtWall<D, P, ContactPairs::Kernel<D>>>;
    NeighbourView all = list;
    all.skips = Skips::nothing;
    const GradientAtWall<D, P, ContactPairs::Kernel<D>> term{
        fluid_pair_.kernel_gradient_normalisation, completion};
    for_each_index(count, BesideSmoothWalls<D, P, Loop>{view, all, Loop(view, all, {}, term)});
    if constexpr (D == 3) complete_in_corners(view, count, all, completion);
    return has_solids_;
  }
  void complete_in_corners(const ParticleView<D, P>& view, Index count, const NeighbourView& all,
                           WallCompletion completion) const {
    using Loop = PairLoop<D, P, ContactPairs, GradientInCorner<D, P>>;
    const GradientInCorner<D, P> term{fluid_pair_.gravity,
                                      fluid_pair_.kernel_gradient_normalisation, completion};
    for_each_index(count, InCorners<D, P, Loop>{view, Loop(view, all, {}, term)});
  }
  void react_at_walls(const ParticleView<D, P>& view, Index count,
                      const NeighbourView& list) const {
    using Loop = PairLoop<D, P, ContactPairs, WallReaction<D, P>>;
    NeighbourView others = list;
    others.skips = Skips::nothing;
    for_each_index(count, OfSmoothSolids<D, P, Loop>{view, Loop(view, others, {}, {})});
  }

  // Evaluates pressures and accelerations only, for output.
  template <class Bonds>
  void accelerate(const ParticleView<D, P>& view, Index count, const NeighbourView& list,
                  const Bonds& bonds) const {
    sum_pairs({view, count, list}, bonds);
  }
  // Evaluates the accelerations by the pairs that `filter` selects and by the body force given.
  template <class Bonds, class Filter>
  void accelerate(const ParticleView<D, P>& view, Index count, const NeighbourView& list,
                  const Bonds& bonds, const Filter& filter,
                  const BodyForce<D, P>& body_force) const {
    update_pressures({view, count, list});
    run_loop({view, count, list}, bonds, filter, body_force);
  }

  // Records the initial overlap, at which bodies exert no force. Once, at the start of a run.
  void record_initial_overlap(const ParticleView<D, P>& view, Index count,
                              const NeighbourView& list) const {
    if (may_touch(view)) sum_surface_overlaps(view, count, list, {contacts(), true});
  }

  std::size_t bytes() const {
    return simd_pairs_.bytes() + density_gradient_.size() * sizeof(Vector<D, Real>);
  }

 private:
  using SmoothWalls = SmoothWallSum<D, P, ContactPairs::Kernel<D>>;
  using KernelSum = ParticleConcentration<D, P, ContactPairs::Kernel<D>>;

  struct LoopInput {
    ParticleView<D, P> view;
    Index count;
    NeighbourView list;
  };

  // Whether a solid may touch another body, or its image in a plane.
  bool may_touch(const ParticleView<D, P>& view) const {
    return has_bodies_apart_ || (view.mirrors.faces & apart_from_images_) != 0;
  }

  static void update_pressures(const LoopInput& input) {
    for_each_index(input.count + input.view.ghosts.count, FluidPressure<D, P>{input.view});
  }

  // The loop over the forces, and over `more` terms of the same pairs.
  template <class Bonds, class Filter, class... More>
  auto forces_loop(const LoopInput& input, const Bonds& bonds, const Filter& filter,
                   const BodyForce<D, P>& body_force, const More&... more) const {
    return FilteredPairLoop<D, P, ContactPairs, Filter, BodyForce<D, P>, FluidForce<D, P>,
                            WaterViscosity<D, P>, DebrisContact<D, P, Bonds>, SurfaceContact<D, P>,
                            More...>(
        input.view, input.list, filter, body_force, FluidForce<D, P>{fluid_pair_},
        WaterViscosity<D, P>{fluid_pair_.kernel_gradient_normalisation},
        DebrisContact<D, P, Bonds>{bonds}, SurfaceContact<D, P>{contacts()}, more...);
  }
  template <class Bonds, class Filter, class... More>
  void run_loop(const LoopInput& input, const Bonds& bonds, const Filter& filter,
                const BodyForce<D, P>& body_force, const More&... more) const {
    for_each_index(input.count, forces_loop(input, bonds, filter, body_force, more...));
  }
  // Sums over every pair; those of fluids by kernels of their own where they can.
  template <class Bonds, class... More>
  void sum_pairs(LoopInput input, const Bonds& bonds, const More&... more) const {
    if (separates_fluids()) {
      input.list.skips = simd_exists ? Skips::of_fluids : Skips::same_fluid;
      simd_pairs_.run(simd_pairs_.pack(input.view, input.count, input.list), input.count,
                      forces_loop(input, bonds, EveryPair{}, gravity_, more...));
      return;
    }
    update_pressures(input);
    run_loop(input, bonds, EveryPair{}, gravity_, more...);
  }

  void sum_surface_overlaps(const ParticleView<D, P>& view, Index count, const NeighbourView& list,
                            const SurfaceOverlap<D, P>& term) const {
    using Loop = PairLoop<D, P, ContactPairs, SurfaceOverlap<D, P>>;
    NeighbourView others = list;  // pairs of fluids or of one body are not in contact
    others.skips = Skips::of_fluids_and_body;
    for_each_index(count, OfSolids<D, P, Loop>{view, Loop(view, others, {}, term)});
  }
  ContactTable<Real> contacts() const { return {pointer(contacts_), media_}; }

  BodyForce<D, P> gravity_{};
  FluidPair<D, P> fluid_pair_{};
  Index media_ = 0;
  Array<ContactOfMedia<Real>> contacts_;
  Array<Vector<D, Real>> density_gradient_;  // 1/m, scratch of delta-SPH alone
  bool has_solids_ = false;
  bool has_bodies_apart_ = false;     // a solid and another body that it is not joined to
  MirrorCode apart_from_images_ = 0;  // planes whose images of a solid are not one piece with it
  mutable SimdPairs<D, P> simd_pairs_;
};

}  // namespace kerf
