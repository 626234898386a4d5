// SPDX-License-Identifier: Apache-2.0
// The boundary conditions of the solids of a run of the `standard` formulation: absorbing faces and
// given loads.
#pragma once

#include "simulation/absorbing_sites.hpp"
#include "simulation/balance.hpp"
#include "simulation/load_sites.hpp"
#include "simulation/state_io.hpp"
#include "solid/solid_fields.hpp"
#include "standard/solid_link.hpp"

namespace kerf {

// The terms of each site, for a sum.
template <class Sum>
struct KnownTerms {
  const Sum* of;
  KERF_FUNCTION void add(Index k, Sum& sum) const { sum.join(of[k]); }
};

template <int D, class P>
class SolidBoundaries {
 public:
  // `position` and `source` of the particles of the start, `number` of each in the solid;
  // `surface` by that number.
  void set_up(const RunSettings& settings, const std::vector<Medium<double>>& media,
              const std::vector<Vector<D, double>>& position,
              const std::vector<std::uint16_t>& source, const std::vector<Index>& number,
              const SurfaceOfSolid<D>& surface) {
    to_device(absorbing_sites<D>({settings, media, position, source, number, surface.detached}),
              absorbing_);
    LoadLayout<D> layout = load_sites<D>(settings, media, position, source, number, surface);
    for (LoadShare<D>& share : layout.shares) share.turned = share.full;
    to_device(layout.sites, loaded_);
    to_device(layout.shares, shares_);
    loads_ = settings.loads;
    factors_.resize(loads_.size());
    set_time(0.0);
  }

  // Moves the absorbing faces to the faces of another window; `position` and `source` of the solid.
  void move(const RunSettings& settings, const std::vector<Medium<double>>& media,
            const std::vector<Vector<D, double>>& position,
            const std::vector<std::uint16_t>& source) {
    std::vector<Index> number(position.size());
    for (std::size_t s = 0; s < number.size(); ++s) number[s] = static_cast<Index>(s);
    to_device(absorbing_sites<D>({settings, media, position, source, number, {}}), absorbing_);
  }

  // Sets the factors of the loads at the time t, s.
  void set_time(double time) {
    if (loads_.empty()) return;
    for (std::size_t n = 0; n < loads_.size(); ++n) factors_[n] = loads_[n].history.evaluate(time);
    to_device(factors_, factor_);
  }

  // Turns the loads with the surface, at the deformation of a new step of the solid.
  void turn(const SolidFields<D, P>& solid) {
    for_each_index(size(loaded_),
                   TurnLoads<D, P>{pointer(solid.gradient), pointer(loaded_), pointer(shares_)});
    if constexpr (ranks::exist)
      if (solid.share.is_part) collect_turned(solid.share);
  }

  // Adds the accelerations by absorbing faces and loads; `velocity` at the start of the step, m/s.
  void accelerate(Particles<D, P>& particles, const Vector<D, typename P::Real>* velocity,
                  const SolidIndexView& link, const SolidFields<D, P>& solid) {
    for_each_index(size(absorbing_),
                   Absorb<D, P>{particles.view(), velocity, link.particle_of, no_index,
                                pointer(solid.detached), pointer(absorbing_)});
    for_each_index(size(loaded_), ApplyLoads<D, P>{particles.view(), link.particle_of, no_index,
                                                   pointer(solid.detached), pointer(factor_),
                                                   pointer(shares_), pointer(loaded_)});
  }

  // Adds the impulses and work of the step that has ended.
  void end_step(Particles<D, P>& particles, const SolidIndexView& link, double dt) {
    collect_absorbing(link);
    const Terms<D> absorbed =
        absorbed_sum_(size(absorbing_), AbsorbingForce<D>{pointer(absorbing_)});
    using Sum = LoadSum<D, P>;
    const Sum of_particles{particles.view(), link.particle_of, no_index, pointer(loaded_)};
    const auto load =
        ranks::are_several() ? sum_loads(of_particles) : load_sum_(size(loaded_), of_particles);
    for (int a = 0; a < D; ++a) {
      const auto axis = static_cast<std::size_t>(a);
      impulse_absorbed_[axis] += dt * absorbed.value[a];
      impulse_load_[axis] += dt * load.value[Sum::force + a];
    }
    work_load_ += load.value[Sum::work];
    load_scale_ += dt * load.value[Sum::magnitude];
  }

  void record(Balance& balance) const {
    for (std::size_t a = 0; a < 3; ++a) {
      balance.impulse_constraint[a] += impulse_absorbed_[a];
      balance.impulse_load[a] += impulse_load_[a];
    }
    balance.work_load += work_load_;
    balance.load_scale += load_scale_;
  }

  std::size_t bytes() const {
    return absorbing_.size() * sizeof(AbsorbingSite<D>) + loaded_.size() * sizeof(LoadSite<D>) +
           shares_.size() * sizeof(LoadShare<D>);
  }

  void save(Archive& archive) const {
    std::vector<double> sums{work_load_};
    sums.insert(sums.end(), impulse_load_.begin(), impulse_load_.end());
    sums.insert(sums.end(), impulse_absorbed_.begin(), impulse_absorbed_.end());
    sums.push_back(load_scale_);
    archive.arrays["solid/boundaries"] = sums;
    std::vector<double> turned;
    for (const LoadShare<D>& share : to_host(shares_))
      for (int a = 0; a < D; ++a) turned.push_back(share.turned[a]);
    archive.arrays["solid/loads"] = turned;
  }
  void restore(const Archive& archive) {
    const auto& sums = find_array<double>(archive, "solid/boundaries");
    work_load_ = sums.at(0);
    for (std::size_t a = 0; a < 3; ++a) {
      impulse_load_[a] = sums.at(1 + a);
      impulse_absorbed_[a] = sums.at(4 + a);
    }
    load_scale_ = sums.at(7);
    const auto& turned = find_array<double>(archive, "solid/loads");
    auto shares = to_host(shares_);
    for (std::size_t n = 0; n < shares.size(); ++n)
      for (int a = 0; a < D; ++a)
        shares[n].turned[a] = turned.at(D * n + static_cast<std::size_t>(a));
    to_device(shares, shares_);
  }

 private:
  // Tells all ranks the forces on the particles that each of them has.
  void collect_absorbing([[maybe_unused]] const SolidIndexView& link) {
    if constexpr (ranks::exist) {
      if (!ranks::are_several()) return;
      struct SiteForce {
        Index site;
        Vector<D, double> force;
      };
      std::vector<SiteForce> own;
      for (Index k = 0; k < size(absorbing_); ++k)
        if (link.particle_of[absorbing_[k].particle] != no_index)
          own.push_back({k, absorbing_[k].force});
      for (const SiteForce& of : ranks::collected(own)) absorbing_[of.site].force = of.force;
    }
  }

  // Tells all ranks the loads on the particles whose deformation each of them knows.
  void collect_turned(const IndexShare& share) {
    struct Turned {
      Index number;
      Vector<D, double> force;
    };
    std::vector<Turned> own;
    for (const LoadSite<D>& site : loaded_)
      for (Index n = site.first; share.has(site.particle) && n < site.last; ++n)
        if (shares_[n].follows) own.push_back({n, shares_[n].turned});
    for (const Turned& of : ranks::collected(own)) shares_[of.number].turned = of.force;
  }
  // The sum over the particles of all ranks, in the order of the sites.
  Terms<LoadSum<D, P>::slots> sum_loads([[maybe_unused]] const LoadSum<D, P>& of_particles) {
    using Sum = Terms<LoadSum<D, P>::slots>;
    std::vector<Sum> of_site(loaded_.size(), Sum::zero());
    if constexpr (ranks::exist) {
      struct SiteSum {
        Index site;
        Sum sum;
      };
      std::vector<SiteSum> own;
      for (Index k = 0; k < size(loaded_); ++k) {
        if (of_particles.particle_of[loaded_[k].particle] == no_index) continue;
        own.push_back({k, Sum::zero()});
        of_particles.add(k, own.back().sum);
      }
      for (const SiteSum& of : ranks::collected(own)) of_site[of.site] = of.sum;
    }
    return load_sum_(size(loaded_), KnownTerms<Sum>{of_site.data()});
  }

  template <class T>
  static Index size(const Array<T>& sites) {
    return static_cast<Index>(sites.size());
  }

  Array<AbsorbingSite<D>> absorbing_;
  Array<LoadSite<D>> loaded_;
  Array<LoadShare<D>> shares_;
  std::vector<RunLoad> loads_;
  std::vector<double> factors_;
  Array<double> factor_;  // of each load, at the set time
  OrderedSum<D> absorbed_sum_;
  OrderedSum<LoadSum<D, P>::slots> load_sum_;
  std::array<double, 3> impulse_absorbed_{}, impulse_load_{};  // N s (2D: N s/m)
  double load_scale_ = 0.0;  // N s (2D: N s/m), of the magnitudes of the forces of loads
  double work_load_ = 0.0;   // J (2D: J/m)
};

}  // namespace kerf
