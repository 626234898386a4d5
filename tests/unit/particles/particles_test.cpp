// SPDX-License-Identifier: Apache-2.0
// The table of fields, the order of particles and their outflow.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "core/precision.hpp"
#include "particles/outflow.hpp"
#include "particles/reorder.hpp"

namespace kerf::test {
namespace {

std::vector<Medium<double>> media() {
  std::vector<Medium<double>> all(2);
  all[0].phase = Phase::water;
  all[1].phase = Phase::rigid;
  for (auto& medium : all) {
    medium.density = 1000.0;
    medium.tait.exponent = 7.0;
    medium.tait.coefficient = 1e5;
  }
  all[0].initial_compression = 0.03;
  return all;
}

Particles<2, Double> particles_of(const std::vector<NewParticle>& start) {
  Particles<2, Double> particles;
  to_device(media(), particles.media);
  particles.append(start, media());
  return particles;
}

std::vector<NewParticle> numbered(std::uint32_t count) {
  std::vector<NewParticle> start(count);
  for (std::uint32_t k = 0; k < count; ++k) {
    start[k].id = k;
    start[k].position = {double(k), -double(k), 0.0};
    start[k].velocity = {0.5 * k, 0.0, 0.0};
    start[k].inlet_column = 3 * k;
  }
  return start;
}

TEST(Fields, NewParticlesHaveTheInitialValuesOfTheTable) {
  auto particles = particles_of(numbered(1));
  auto later = numbered(3);
  later[2].source = 1;
  particles.append(later, media());
  ASSERT_EQ(particles.size(), 4u);
  EXPECT_EQ((Vector<2, double>(particles.position[3])[1]), -2.0);
  EXPECT_EQ((Vector<2, double>(particles.build_position[3])[1]), -2.0);
  EXPECT_EQ((Vector<2, double>(particles.velocity[3])[0]), 1.0);
  EXPECT_EQ(std::uint32_t(particles.inlet_column[2]), 3u);
  EXPECT_EQ(std::uint32_t(particles.id[2]), 1u);
  EXPECT_EQ(double(particles.compression[1]), 0.03);
  EXPECT_EQ(double(particles.compression[3]), 0.0);
  // The integral of p / rho^2 d rho of p = B ((rho/rho_0)^7 - 1).
  const double r = 1.03;
  EXPECT_NEAR(double(particles.pressure_work[1]),
              1e5 / 1000.0 * ((std::pow(r, 6) - 1.0) / 6.0 + 1.0 / r - 1.0), 1e-12);
  EXPECT_EQ(double(particles.solid_initial_overlap[3]), 1.0);
  EXPECT_EQ(double(particles.rigid_initial_overlap[3]), 1.0);
  EXPECT_EQ(int(particles.fractured[3]), 0);
  const Vector<2, double> rest = particles.conservative_acceleration[3];
  EXPECT_EQ(norm(rest), 0.0);
}

TEST(Fields, RunsHoldTheFieldsOfTheirGroupsOnly) {
  Particles<2, Mixed> particles;
  const std::size_t all = particles.bytes_per_particle();
  particles.groups = {
      .rate_stress = true, .contact = true, .mirrored = false, .density_losses = true};
  EXPECT_EQ(all - particles.bytes_per_particle(), 2 * sizeof(float));
  particles.append(numbered(2), media());
  EXPECT_EQ(particles.view().mirror_acceleration, nullptr);
  EXPECT_NE(particles.view().shear, nullptr);
  EXPECT_EQ(particles.mirror_acceleration.size(), 0u);
}

TEST(Reorder, SortedParticlesKeepTheirState) {
  auto particles = particles_of(numbered(5));
  Array<Index> key;
  to_device(std::vector<Index>{2, 1, 2, 0, 1}, key);
  sort_particles(particles, key);
  EXPECT_EQ(to_host(particles.id), (std::vector<std::uint32_t>{3, 1, 4, 0, 2}));
  for (Index i = 0; i < 5; ++i) {
    const double id = std::uint32_t(particles.id[i]);
    const Vector<2, double> x = particles.position[i], v = particles.velocity[i];
    EXPECT_EQ(x[0], id);
    EXPECT_EQ(x[1], -id);
    EXPECT_EQ(v[0], 0.5 * id);
    EXPECT_EQ(std::uint32_t(particles.inlet_column[i]), 3.0 * id);
  }
}

// However they were ordered before.
TEST(Reorder, SortedParticlesOfOneCellAreInTheOrderOfTheirIds) {
  std::mt19937 engine(3);
  const std::vector<Index> cell_of_id{4, 1, 4, 4, 0, 1, 4, 2};
  std::vector<NewParticle> start = numbered(8);
  for (int n = 0; n < 20; ++n) {
    std::shuffle(start.begin(), start.end(), engine);
    auto particles = particles_of(start);
    std::vector<Index> cells;
    for (const NewParticle& particle : start) cells.push_back(cell_of_id[particle.id]);
    Array<Index> cell;
    to_device(cells, cell);
    sort_particles(particles, cell);
    EXPECT_EQ(to_host(particles.id), (std::vector<std::uint32_t>{4, 1, 5, 7, 0, 2, 3, 6}));
    EXPECT_EQ(to_host(particles.sorted_cell), (std::vector<Index>{0, 1, 1, 2, 4, 4, 4, 4}));
  }
}

// The grids of two levels, the first with 3 rows of 25 cells, the second with rows of 4: pieces are
// cells 0..11, 12..23 and 24 of each row.
TEST(Groups, AreTheParticlesOfPiecesOfRows) {
  ParticleGroups groups;
  GridRows rows;
  rows.levels = 2;
  rows.first[1] = 75;
  rows.first[2] = 83;
  rows.across[0] = 25;
  rows.across[1] = 4;
  groups.set_rows(rows);
  Array<Index> cell;
  to_device(
      std::vector<Index>{0, 0, 11, 12, 23, 24, 25, 36, 37, 74, 75, 78, 79, unsorted, unsorted},
      cell);
  groups.find(cell, 15);
  const GroupView view = groups.view();
  EXPECT_EQ(std::vector<Index>(view.begin, view.begin + view.count + 1),
            (std::vector<Index>{0, 3, 5, 6, 8, 9, 10, 12, 13, 14, 15}));
  groups.find(cell, 4);  // the others are ghosts
  EXPECT_EQ(groups.view().count, 2u);
  EXPECT_EQ(groups.view().begin[2], 4u);
}

TEST(Reorder, OutflowIsRemovedAndTheOthersKeepTheirOrder) {
  auto particles = particles_of(numbered(5));
  particles.flags[1] = flag::outside;
  particles.flags[3] = flag::erased;
  particles.flags[4] = flag::upstream;
  remove_outflow(particles);
  EXPECT_EQ(to_host(particles.id), (std::vector<std::uint32_t>{0, 2, 4}));
  EXPECT_EQ(particles.start_position.size(), 3u);
}

// A vertical jet with its exit at y = 0.
std::uint8_t flags_after(NewParticle particle, double y, double vertical_speed,
                         bool removes_back_flow) {
  auto particles = particles_of({particle});
  particles.position[0] = Vector<2, double>{0.0, y};
  particles.velocity[0] = Vector<2, double>{0.0, vertical_speed};
  PrescribedMotion<2> motion{};
  motion.direction = {0.0, -1.0};
  motion.removes_back_flow = removes_back_flow;
  motion.back_flow_removal_speed = -0.5;
  const std::vector<PrescribedMotion<2>> motions{motion, motion};
  Array<PrescribedMotion<2>> on_device;
  to_device(motions, on_device);
  for_each_index(
      1, MarkOutflow<2, Double>{particles.view(), pointer(on_device), {-1.0, -1.0}, {1.0, 1.0}});
  return particles.flags[0];
}

TEST(Outflow, WaterIsReleasedBeyondTheNozzle) {
  NewParticle water;
  water.flags = flag::upstream;
  EXPECT_EQ(flags_after(water, 0.1, -5.0, false), flag::upstream);
  EXPECT_EQ(flags_after(water, -0.1, -5.0, false), 0);
}

TEST(Outflow, ParticlesOutsideTheDomainAreMarked) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(flags_after({}, -1.1, -5.0, false), flag::outside);
  EXPECT_EQ(flags_after({}, 1.1, -5.0, false), flag::outside);
  EXPECT_EQ(flags_after({}, -0.9, -5.0, false), 0);
  EXPECT_EQ(flags_after({}, none, -5.0, false), 0);  // the time step reports it
  NewParticle wall;
  wall.source = 1;
  EXPECT_EQ(flags_after(wall, -1.1, 0.0, false), 0);
}

TEST(Outflow, BackFlowIsRemovedOnRequest) {
  EXPECT_EQ(flags_after({}, -0.5, 0.6, true), flag::erased);
  EXPECT_EQ(flags_after({}, -0.5, 0.4, true), 0);
  EXPECT_EQ(flags_after({}, -0.5, 0.6, false), 0);
}

}  // namespace
}  // namespace kerf::test
