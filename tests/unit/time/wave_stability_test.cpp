// SPDX-License-Identifier: Apache-2.0
// Sound in a fluid at rest under the step of time/verlet.hpp: the growth of each wave of the
// lattice per step, from the sums of the kernel over it, says from which step on one grows. The
// sums are those of fluid/riemann.hpp for small disturbances, in units of d and c:
//   dv/dt = - i D eps - beta M v,   d eps/dt = - i D . v - g eps,   eps = rho / rho_0 - 1,
//   D = sum w e sin(k . r),   g = sum w (1 - cos k . r),   M = sum w e e (1 - cos k . r),
// w = V |W'| over the sum that makes the slope on the lattice 1. The stages of the step are run
// with these rates, so that the test has their growth and not that of a formula for them.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

#include "core/precision.hpp"
#include "kernels/wendland_c2.hpp"
#include "model/case.hpp"
#include "time/save_step_start.hpp"
#include "time/verlet.hpp"

namespace kerf::test {
namespace {

constexpr double smoothing_length = 1.3;  // spacings

template <int D>
struct WaveSums {
  Vector<D, double> gradient = Vector<D, double>::zero();
  Matrix<D, double> damping = Matrix<D, double>::zero();
  double diffusion = 0.0;
};

// Calls visit(point) for all points of a square or cubic lattice from `lowest` to `highest`.
template <int D, class Visit>
void for_each_point(int lowest, int highest, const Visit& visit) {
  const int side = highest - lowest + 1, count = D == 3 ? side * side * side : side * side;
  for (int n = 0; n < count; ++n) {
    Vector<D, double> point;
    for (int a = 0, rest = n; a < D; ++a, rest /= side) point[a] = lowest + rest % side;
    visit(point);
  }
}

template <int D, class Visit>
void for_each_neighbour(const Visit& visit) {
  using Kernel = WendlandC2<D>;
  const int reach = static_cast<int>(std::ceil(Kernel::support * smoothing_length));
  for_each_point<D>(-reach, reach, [&](const Vector<D, double>& r) {
    const double distance = norm(r);
    if (distance == 0.0 || distance >= Kernel::support * smoothing_length) return;
    visit(r, distance, std::abs(Kernel::slope_per_distance(distance, smoothing_length)) * distance);
  });
}

template <int D>
WaveSums<D> wave_sums(const Vector<D, double>& k) {
  double slope = 0.0;
  for_each_neighbour<D>([&](const Vector<D, double>&, double distance, double weight) {
    slope += weight * distance / D;
  });
  WaveSums<D> sums;
  for_each_neighbour<D>([&](const Vector<D, double>& r, double distance, double weight) {
    const double w = weight / slope, phase = dot(k, r);
    const auto e = (1.0 / distance) * r;
    sums.gradient += (w * std::sin(phase)) * e;
    sums.diffusion += w * (1.0 - std::cos(phase));
    add_outer(sums.damping, (w * (1.0 - std::cos(phase))) * e, e);
  });
  return sums;
}

// Two particles hold the real and the imaginary part of a wave.
template <int D>
class Wave {
 public:
  static constexpr int numbers = 2 * (2 * D + 1);  // v, the conservative acceleration, and eps

  Wave(const WaveSums<D>& sums, double beta, double dt) : sums_(sums), beta_(beta), dt_(dt) {
    std::vector<Medium<double>> media(1);
    media[0].phase = Phase::water;
    media[0].density = 1.0;
    to_device(media, particles_.media);
    particles_.resize(2);
  }

  // Returns the state after one step from a state in which one number is 1 and the others are 0.
  Eigen::VectorXd step_from(int number) {
    Eigen::VectorXd state = Eigen::VectorXd::Zero(numbers);
    state[number] = 1.0;
    write(state);
    const auto view = particles_.view();
    for_each_index(2, SaveStepStart<D, Double>{view});
    for_each_index(2, DriftHalf<D, Double>{view, nullptr, dt_});
    set_rates();
    for_each_index(2, KickAndDrift<D, Double>{view, nullptr, dt_});
    for_each_index(2, FinalizeDensity<D, Double>{view, dt_});
    return read();
  }

 private:
  void set_rates() {
    for (int i = 0; i < 2; ++i) {
      // i (a + i b) = - b + i a
      const double other = particles_.compression[1 - i], sign = i == 0 ? 1.0 : -1.0;
      const Vector<D, double> v = particles_.velocity[i], w = particles_.velocity[1 - i];
      const auto damping = -beta_ * (sums_.damping * v);
      particles_.damping_acceleration[i] = damping;
      particles_.acceleration[i] = (sign * other) * sums_.gradient + damping;
      particles_.compression_rate[i] =
          sign * dot(sums_.gradient, w) - sums_.diffusion * particles_.compression[i];
      particles_.kernel_sum[i] = -10.0;  // no bound on the density
      particles_.pressure_acceleration[i] = Vector<D, double>::zero();
    }
  }
  void write(const Eigen::VectorXd& state) {
    for (int i = 0, n = 0; i < 2; ++i) {
      Vector<D, double> v, a;
      for (int axis = 0; axis < D; ++axis) {
        v[axis] = scale * state[n++];
        a[axis] = scale * state[n++];
      }
      particles_.velocity[i] = v;
      particles_.conservative_acceleration[i] = a;
      particles_.compression[i] = scale * state[n++];
      particles_.position[i] = Vector<D, double>::zero();
      particles_.flags[i] = 0;
      particles_.source[i] = 0;
    }
  }
  Eigen::VectorXd read() const {
    Eigen::VectorXd state(numbers);
    for (int i = 0, n = 0; i < 2; ++i) {
      const Vector<D, double> v = particles_.velocity[i],
                              a = particles_.conservative_acceleration[i];
      for (int axis = 0; axis < D; ++axis) {
        state[n++] = v[axis] / scale;
        state[n++] = a[axis] / scale;
      }
      state[n++] = particles_.compression[i] / scale;
    }
    return state;
  }

  static constexpr double scale = 0.01;  // above the limit of the expansion
  WaveSums<D> sums_;
  double beta_, dt_;
  Particles<D, Double> particles_;
};

// Returns the largest growth per step of the waves of the lattice.
template <int D>
double growth(double courant, double beta) {
  constexpr int waves = D == 3 ? 6 : 10;  // along each axis
  double largest = 0.0;
  for_each_point<D>(0, waves, [&](const Vector<D, double>& number) {
    for (int a = 1; a < D; ++a)
      if (number[a] > number[a - 1]) return;  // like another wave
    if (number[0] == 0.0) return;
    Wave<D> wave(wave_sums<D>((std::numbers::pi / waves) * number), beta,
                 courant * smoothing_length);
    Eigen::MatrixXd step(Wave<D>::numbers, Wave<D>::numbers);
    for (int n = 0; n < Wave<D>::numbers; ++n) step.col(n) = wave.step_from(n);
    largest = std::max(largest, step.eigenvalues().cwiseAbs().maxCoeff());
  });
  return largest;
}

template <class Dimension>
class WaveStability : public testing::Test {};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(WaveStability, Dimensions);

// With and without the dissipation between particles that approach (beta 0 to 1).
TYPED_TEST(WaveStability, NoneGrowsAtTheDefaultStepNorAtOneAFifthLonger) {
  constexpr int D = TypeParam::value;
  const double courant = TimeControl{}.courant;
  for (const double beta : {0.0, 0.5, 1.0}) {
    const double there = growth<D>(courant, beta), above = growth<D>(1.2 * courant, beta),
                 far_above = growth<D>(1.6 * courant, beta);
    std::printf("beta %.1f: growth %.4f, %.4f, %.4f\n", beta, there, above, far_above);
    EXPECT_LE(there, 1.0 + 1e-12) << beta;
    EXPECT_LE(above, 1.0 + 1e-12) << beta;
    EXPECT_GT(far_above, 1.0 + 1e-3) << beta;
  }
}

}  // namespace
}  // namespace kerf::test
