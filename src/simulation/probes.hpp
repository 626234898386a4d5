// SPDX-License-Identifier: Apache-2.0
// Probes: pressure and velocity at a point by kernel interpolation or as their mean over points of
// the face of a gauge, and the force that one side of a plane exerts on the other, which is the sum
// of the pair forces across it.
#pragma once

#include "kernels/cubic_spline.hpp"
#include "model/point.hpp"
#include "particles/fields.hpp"

namespace kerf {

// Shepard interpolation, sum f W V / sum W V, over water and over solid apart: the pressure is not
// continuous between them, since that of a solid is the mean of its normal stresses.
template <int D, class P>
struct PointSum {
  enum Slot { weight = 0, pressure, velocity, of_one = velocity + D, slots = 2 * of_one };
  ParticleView<D, P> particles;
  Vector<D, double> point;

  KERF_FUNCTION void add(Index i, Terms<slots>& sum) const {
    if (particles.medium(i).phase == Phase::rigid) return;
    add_image(i, 0, sum);
    if (particles.mirrors.faces == 0) return;
    for (int image = 1; image < MirrorPlanes<D>::images; ++image) {
      MirrorCode code;
      if (particles.mirrors.find_image(image, code)) add_image(i, code, sum);
    }
  }
  // Returns the first slot of what a probe reads: a gauge the water, if there is any; a point that
  // of the two that it is in, where the face between them, at half of the weight, is the water's.
  static int first_slot(const Terms<slots>& sum, bool is_gauge) {
    constexpr double least_share = 0.4;
    const double water = sum.value[weight], solid = sum.value[of_one + weight];
    return water > (is_gauge ? 0.0 : least_share * (water + solid)) ? 0 : of_one;
  }

 private:
  KERF_FUNCTION void add_image(Index i, MirrorCode code, Terms<slots>& sum) const {
    const auto& medium = particles.medium(i);
    const auto r = particles.mirrors.image_position(code, particles.position[i]) - point;
    const double w = CubicSpline<D>::value(norm(r), double(medium.smoothing_length)) *
                     (double(medium.mass) / double(particles.density(i)));
    double* const value = sum.value + (medium.phase == Phase::water ? 0 : int(of_one));
    value[weight] += w;
    value[pressure] += w * double(particles.pressure[i]);
    const auto v = MirrorPlanes<D>::image(code, particles.velocity[i]);
    for (int a = 0; a < D; ++a) value[velocity + a] += w * double(v[a]);
  }
};

// Selects the pairs with i below the plane and j above it, along the normal.
template <int D>
struct AcrossPlane {
  Vector<D, double> point, normal;

  KERF_FUNCTION bool above(const Vector<D, double>& x) const {
    return dot(x - point, normal) > 0.0;
  }
  template <class P>
  KERF_FUNCTION bool operator()(const ParticleView<D, P>& particles, Index i, Index j,
                                MirrorCode mirror) const {
    return !above(particles.position[i]) &&
           above(particles.mirrors.image_position(mirror, particles.position[j]));
  }
};

template <int D, class P>
struct ForceSum {
  ParticleView<D, P> particles;

  KERF_FUNCTION void add(Index i, Terms<D>& sum) const {
    if (particles.medium(i).phase == Phase::rigid) return;
    const double m = particles.medium(i).mass;
    for (int a = 0; a < D; ++a) sum.value[a] += m * double(particles.acceleration[i][a]);
  }
};

template <int D, class P>
class Probes {
 public:
  // Appends the means over the points of a gauge of the pressure and of the three components of the
  // velocity. Where a point has no matter around it they are 0, so that the pressure of a gauge is
  // the force on its face over its area.
  void sample_mean(Particles<D, P>& particles, const std::vector<Point>& points,
                   std::vector<double>& values) {
    std::vector<double> sampled;
    const bool is_gauge = points.size() > 1;
    for (const Point& point : points) sample_point(particles, point, is_gauge, sampled);
    for (std::size_t k = 0; k < 4; ++k) {
      double sum = 0.0;
      for (std::size_t n = k; n < sampled.size(); n += 4) sum += sampled[n];
      values.push_back(sum / static_cast<double>(points.size()));
    }
  }

  // pressure, then velocity in three components.
  void sample_point(Particles<D, P>& particles, const Point& position, bool of_gauge,
                    std::vector<double>& values) {
    using Sum = PointSum<D, P>;
    const auto sum = point_sum_(particles.sum_groups.view(), particles.size(),
                                Sum{particles.view(), Vector<D, double>::from(position)});
    const int first = Sum::first_slot(sum, of_gauge);
    const double weight = sum.value[first + Sum::weight];
    values.push_back(weight > 0.0 ? sum.value[first + Sum::pressure] / weight : 0.0);
    for (int a = 0; a < 3; ++a)
      values.push_back(a < D && weight > 0.0 ? sum.value[first + Sum::velocity + a] / weight : 0.0);
  }

  // Returns the total force of the particles' accelerations, three components.
  void sum_force(Particles<D, P>& particles, std::vector<double>& values) {
    const auto sum =
        force_sum_(particles.sum_groups.view(), particles.size(), ForceSum<D, P>{particles.view()});
    for (int a = 0; a < 3; ++a) values.push_back(a < D ? sum.value[a] : 0.0);
  }

 private:
  GroupSum<Terms<PointSum<D, P>::slots>> point_sum_;
  GroupSum<Terms<D>> force_sum_;
};

}  // namespace kerf
