// SPDX-License-Identifier: Apache-2.0
// A symmetric case stays symmetric, and the precision changes only the last digits.
#include <fmt/format.h>

#include <cmath>

#include "input/read.hpp"
#include "support/runs.hpp"
#include "support/small_cases.hpp"

namespace kerf::test {
namespace {

using Map = std::array<double, 3> (*)(const std::array<double, 3>&);

// The largest distance from the image of a particle that moves to the nearest particle of its
// source, m, and the largest difference of their velocities, m/s.
struct Asymmetry {
  double position = 0.0, velocity = 0.0, speed = 0.0;
};

Asymmetry asymmetry(const Frame& frame, const Frame& other, Map image) {
  Asymmetry worst;
  const auto distance = [](const auto& a, const auto& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  };
  for (std::size_t i = 0; i < frame.position.size(); ++i) {
    if (frame.category[i] == Category::rigid) continue;  // deep inside they are a lattice's
    const auto wanted = image(frame.position[i]);
    double nearest = 1.0;
    std::size_t partner = i;
    for (std::size_t j = 0; j < other.position.size(); ++j) {
      const double d = distance(other.position[j], wanted);
      if (other.category[j] != frame.category[i] || d >= nearest) continue;
      nearest = d;
      partner = j;
    }
    worst.position = std::max(worst.position, nearest);
    worst.velocity =
        std::max(worst.velocity, distance(other.velocity[partner], image(frame.velocity[i])));
    worst.speed = std::max(worst.speed, distance(frame.velocity[i], Point{}));
  }
  return worst;
}

std::array<double, 3> left_right(const std::array<double, 3>& v) {
  return {-v[0], v[1], v[2]};
}
std::array<double, 3> front_back(const std::array<double, 3>& v) {
  return {v[0], v[1], -v[2]};
}
std::array<double, 3> exchange(const std::array<double, 3>& v) {
  return {v[2], v[1], v[0]};
}

// Neighbours on the two sides are summed in different orders: the initial differences of 1e-16 per
// step grow by impact and fracture. An error in a term would give differences of the order of a
// spacing.
void expect_images(const Frame& frame, const Frame& other, Map image, double tolerance) {
  const Asymmetry worst = asymmetry(frame, other, image);
  std::printf("asymmetry: %.2e m, %.2e of the greatest speed\n", worst.position,
              worst.velocity / worst.speed);
  EXPECT_LT(worst.position, tolerance * 1e-3);
  EXPECT_LT(worst.velocity, tolerance * worst.speed);
}
void expect_symmetric(const Frame& frame, Map image, double tolerance) {
  expect_images(frame, frame, image, tolerance);
}

TEST(Symmetry, Jet2D) {
  const auto simulation = make_simulation(jet_on_block(2, PrecisionKind::double_precision));
  take_steps(*simulation, 400);
  EXPECT_GT(count_of(simulation->frame(), Category::fractured), 0u);
  expect_symmetric(simulation->frame(), left_right, 1e-11);
}

TEST(Symmetry, Jet3D) {
  const auto simulation = make_simulation(jet_on_block(3, PrecisionKind::double_precision));
  take_steps(*simulation, 200);
  const Frame frame = simulation->frame();
  EXPECT_GT(count_of(frame, Category::fractured), 0u);
  expect_symmetric(frame, left_right, 1e-11);
  expect_symmetric(frame, front_back, 1e-11);
  expect_symmetric(frame, exchange, 1e-11);
}

// A plane jet that is eight rows wide on a wedge whose faces have these angles to its axis, rad.
Frame jet_on_wedge(double left, double right) {
  const auto end = [](double angle, double side) {
    return fmt::format("[\"{} mm\", \"{} mm\"]", side * 20.0 * std::sin(angle),
                       -20.0 * std::cos(angle));
  };
  const auto simulation = make_simulation(parse_case(fmt::format(R"(title = "wedge"
dimension = 2
formulation = "standard"
precision = "double"
[time]
end = "5 ms"
[domain]
minimum = ["-30 mm", "-30 mm"]
maximum = ["30 mm", "20 mm"]
[[jet]]
name = "jet"
speed = "5 m/s"
width = "8 mm"
position = ["0 mm", "0 mm"]
standoff = "4 mm"
spacing = "1 mm"
[[body]]
name = "wedge"
role = "rigid"
spacing = "1 mm"
shape = {{ type = "polygon", vertices = [["0 mm", "0 mm"], {}, {}] }}
)",
                                                                 end(right, 1.0), end(left, -1.0)),
                                                     "wedge.toml"));
  take_steps(*simulation, 600);
  return simulation->frame();
}

// The wall particles on the bisector of an apex are as far from one face as from the other.
TEST(Symmetry, JetOnAWedge) {
  for (const double angle : {0.35, 0.785398163397448, 1.1}) {
    const Frame frame = jet_on_wedge(angle, angle);
    expect_symmetric(frame, left_right, 1e-6);
  }
  expect_images(jet_on_wedge(0.4, 1.0), jet_on_wedge(1.0, 0.4), left_right, 1e-6);
}

// Both precisions take the same steps: the case sets the step, well below the stable one.
void expect_precisions_agree(int dimension, int steps, double tolerance) {
  Frame frames[2];
  for (PrecisionKind precision : {PrecisionKind::mixed, PrecisionKind::double_precision}) {
    Case c = jet_on_block(dimension, precision);
    c.time.maximum_step = 2e-6;
    const auto simulation = make_simulation(c);
    take_steps(*simulation, steps);
    EXPECT_EQ(simulation->last_step().limit, "maximum step");
    frames[precision == PrecisionKind::mixed ? 0 : 1] = simulation->frame();
  }
  const auto other = by_id(frames[1]);
  ASSERT_EQ(frames[0].id.size(), other.size());
  double moved = 0.0, position = 0.0, velocity = 0.0;
  for (std::size_t k = 0; k < frames[0].id.size(); ++k) {
    const std::size_t j = other.at(frames[0].id[k]);
    for (std::size_t a = 0; a < 3; ++a) {
      position = std::max(position, std::abs(frames[0].position[k][a] - frames[1].position[j][a]));
      velocity = std::max(velocity, std::abs(frames[0].velocity[k][a] - frames[1].velocity[j][a]));
    }
    moved = std::max(moved, std::abs(frames[0].velocity[k][1]));
  }
  std::printf("mixed from double: %.2e m, %.2e m/s\n", position, velocity);
  EXPECT_GT(position, 0.0);  // the precisions differ
  EXPECT_LT(position, tolerance * 5e-4);
  EXPECT_LT(velocity, tolerance * moved);
}
TEST(Precision, MixedAgreesWithDouble2D) {
  expect_precisions_agree(2, 300, 2e-5);
}
TEST(Precision, MixedAgreesWithDouble3D) {
  expect_precisions_agree(3, 150, 2e-5);
}

}  // namespace
}  // namespace kerf::test
