// SPDX-License-Identifier: Apache-2.0
// The particles at the absorbing faces of bodies and their rates of damping. The share of a
// particle in the area of a face is its volume over the distance of layers along the normal, which
// holds for staggered rows too.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "model/medium.hpp"
#include "simulation/run_settings.hpp"
#include "solid/absorbing_boundary.hpp"

namespace kerf {

// A side with the particles whose centre is within 5/4 of a layer of the end of the body. A graded
// body has layers of several levels there, each a power of two times the finest one.
struct AbsorbingFace : AbsorbingSide {
  double end = -std::numeric_limits<double>::infinity();  // m, along the normal

  explicit AbsorbingFace(const AbsorbingSide& side) : AbsorbingSide(side) {}
  double layer_of(int level) const { return std::ldexp(layer, level); }
  template <int D>
  void extend(const Vector<D, double>& x, int level) {
    end = std::max(end, sign * x[axis] + 0.5 * layer_of(level));
  }
  template <int D>
  bool holds(const Vector<D, double>& x, int level) const {
    return end - sign * x[axis] < 1.25 * layer_of(level);
  }
};

// Returns the sites of all absorbing sides. `position` and `source` of the initial particles;
// `number` of each in the solid. Damping of
// t = - rho c_p v_n n - rho c_s v_t on the area V / layer of a particle of mass rho V: the rate
// c / layer along each axis, of every face that the particle is at.
template <int D>
std::vector<AbsorbingSite<D>> absorbing_sites(const RunSettings& settings,
                                              const std::vector<Medium<double>>& media,
                                              const std::vector<Vector<D, double>>& position,
                                              const std::vector<std::uint16_t>& source,
                                              const std::vector<std::uint32_t>& number) {
  std::vector<AbsorbingFace> faces(settings.absorbing.begin(), settings.absorbing.end());
  std::vector<AbsorbingSite<D>> sites;
  if (faces.empty()) return sites;
  const auto& origins = settings.origins;
  for (auto& face : faces)
    for (std::size_t i = 0; i < position.size(); ++i)
      if (origins[source[i]].source == face.source)
        face.extend(position[i], origins[source[i]].level);
  for (std::size_t i = 0; i < position.size(); ++i) {
    const Medium<double>& medium = media[source[i]];
    const MediumOrigin& origin = origins[source[i]];
    AbsorbingSite<D> site{number[i], medium.mass, Vector<D, double>::zero(),
                          Vector<D, double>::zero()};
    for (const auto& face : faces) {
      if (origin.source != face.source || !face.holds(position[i], origin.level)) continue;
      const double shear_speed = std::sqrt(medium.shear_modulus / medium.density);
      for (int a = 0; a < D; ++a)
        site.rate[a] += (a == face.axis ? medium.longitudinal_speed : shear_speed) /
                        face.layer_of(origin.level);
    }
    if (dot(site.rate, site.rate) > 0.0) sites.push_back(site);
  }
  return sites;
}

}  // namespace kerf
