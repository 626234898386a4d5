// SPDX-License-Identifier: Apache-2.0
// WaveTimeLimit computes the time of a wave across the kernel of a compressed solid. In the
// reference configuration, where the sums are, waves in a solid compressed to the stretch lambda
// are 1 / lambda times as fast along that axis; so the time is  h lambda / (c (1 + 1.2 A)),  lambda
// the least principal stretch, A the viscosity of the bonds as in time/time_step.hpp. Where breaks
// have left a particle a share s of its stiffness (solid/limit_break_energy.hpp), its waves are
// sqrt(s) times as fast: lambda / sqrt(s), up to 1, stands for lambda. Where the elastic law
// stiffens with stretch, its modulus along the principal axes (materials/elastic_law.hpp) makes
// them faster. Beside unlike media the stable step of solid/joint_limit.hpp may be shorter than
// that of these waves.
#pragma once

#include <cmath>

#include "materials/finite_strain.hpp"
#include "solid/joint_courant.hpp"
#include "solid/joint_limit.hpp"

namespace kerf {

struct WaveTime {
  double time;            // s
  Index particle;         // of the solid
  bool of_joint = false;  // whether the bond to an unlike medium sets it
};
struct ShorterWave {
  KERF_FUNCTION WaveTime operator()(const WaveTime& a, const WaveTime& b) const {
    if (a.time != b.time) return a.time < b.time ? a : b;
    return a.particle <= b.particle ? a : b;
  }
};

// Reduces a block of particles. For most particles a bound of the principal values suffices, which
// costs a tenth of their computation.
template <int D, class P>
struct WaveTimeLimit {
  using Real = typename P::Real;
  static constexpr Index length = on_gpu ? 1 : 1024;  // particles
  SolidView<D, P> solid;
  double courant;  // by which the time is multiplied

  Index blocks() const { return (solid.share.size() + length - 1) / length; }

  KERF_FUNCTION WaveTime operator()(Index block) const {
    WaveTime shortest{1e300, 0};
    const Index first = solid.share.first + block * length;
    const Index last = first + length < solid.share.last ? first + length : solid.share.last;
    for (Index i = first; i < last; ++i) {
      const WaveTime own = of_particle(i, shortest.time);
      if (own.time < shortest.time) shortest = own;
    }
    return shortest;
  }

 private:
  // Returns the time of a particle, if that may be less than `shortest`.
  KERF_FUNCTION WaveTime of_particle(Index i, double shortest) const {
    const auto& medium = solid.medium(i);
    const double wave =
        double(medium.bond_wave_speed()) * (1.0 + 1.2 * double(medium.artificial_linear));
    double uncompressed = double(medium.smoothing_length) / wave;
    if (solid.detached[i]) return {uncompressed, i};
    bool of_joint = false;
    if ((solid.unlike_media[i] & unlike_media::waves) != 0) {
      const double joint = JointLimit<D, P>(solid).stable_step(i) /
                           (courant > joint_courant ? courant : joint_courant);
      of_joint = joint < uncompressed;
      uncompressed = of_joint ? joint : uncompressed;
    }
    const auto green = green_strain(solid.gradient[i]);
    if (stiffens_with_stretch(medium)) {
      const Real ratio = solid.elastic_share[i] * wave_stiffening(medium, principal_values(green));
      if (ratio > Real(1)) return {uncompressed / std::sqrt(double(ratio)), i, of_joint};
      return {uncompressed, i, of_joint};
    }
    const double least_stretch = shortest / uncompressed;
    const Real share = solid.elastic_share[i];
    if (double(square_of(possible_values(green).least)) >
        double(share) * least_stretch * least_stretch + 1e-5)
      return {1e300, i};
    const auto strain = principal_values(green);
    Real least = strain[0] < strain[1] ? strain[0] : strain[1];
    least = least < strain[2] ? least : strain[2];
    if (!(square_of(least) < share)) return {uncompressed, i, of_joint};
    const Real square = square_of(least) / share;
    // The time step checks (time/time_step.hpp) report a deformation that is not valid.
    return {uncompressed * (square > Real(1e-4) ? std::sqrt(double(square)) : 0.01), i, of_joint};
  }
  // Returns lambda^2 of a principal value of Green's strain.
  KERF_FUNCTION static Real square_of(Real strain) { return Real(1) + Real(2) * strain; }
};

}  // namespace kerf
