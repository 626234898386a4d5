// SPDX-License-Identifier: Apache-2.0
// The output of the particles of a run: checkpoints, frames and probes.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>

#include "core/precision.hpp"
#include "simulation/probes.hpp"
#include "simulation/snapshot.hpp"
#include "simulation/state_io.hpp"

namespace kerf::test {
namespace {

std::vector<Medium<double>> water_and_solid(double spacing) {
  std::vector<Medium<double>> media(3);
  media[0].phase = Phase::water;
  media[1].phase = Phase::solid;
  media[2].phase = Phase::rigid;
  for (auto& medium : media) {
    medium.density = 1000.0;
    medium.spacing = spacing;
    medium.mass = 1000.0 * spacing * spacing;
    medium.smoothing_length = 1.5 * spacing;
    medium.tait.exponent = 7.0;
    medium.tait.coefficient = 1e5;
  }
  return media;
}

template <int D, class P>
Particles<D, P> loaded(const std::vector<NewParticle>& start, FieldGroups groups,
                       double spacing = 1e-3) {
  Particles<D, P> particles;
  particles.groups = groups;
  std::vector<Medium<typename P::Real>> media;
  for (const auto& medium : water_and_solid(spacing))
    media.push_back(Medium<typename P::Real>::from(medium));
  to_device(media, particles.media);
  particles.append(start, water_and_solid(spacing));
  return particles;
}

// Every byte of every state field is random.
template <int D, class P>
void scramble(Particles<D, P>& particles) {
  std::mt19937 engine(3);
  particles.for_each_state([&](const char*, auto& field) {
    auto values = to_host(field);
    auto* bytes = reinterpret_cast<unsigned char*>(values.data());
    for (std::size_t k = 0; k < values.size() * sizeof(values[0]); ++k)
      bytes[k] = static_cast<unsigned char>(engine() & 0x3f);
    to_device(values, field);
  });
}

template <int D, class P>
std::map<std::string, std::string> bytes_of(const Particles<D, P>& particles) {
  std::map<std::string, std::string> bytes;
  particles.for_each_state([&](const char* name, const auto& field) {
    const auto values = to_host(field);
    bytes[name].assign(reinterpret_cast<const char*>(values.data()),
                       values.size() * sizeof(values[0]));
  });
  return bytes;
}

TEST(StateIo, CheckpointsRestoreEveryStateFieldBitForBit) {
  const FieldGroups all;
  auto particles = loaded<3, Mixed>(std::vector<NewParticle>(5), all);
  scramble(particles);
  Archive archive;
  save_fields(particles, archive);
  auto restored = loaded<3, Mixed>({}, all);
  restore_fields(archive, restored);
  EXPECT_EQ(restored.size(), 5u);
  EXPECT_EQ(bytes_of(restored), bytes_of(particles));
  EXPECT_EQ(archive.arrays.size(), 29u);  // rows STATE and PAIRED of particles/fields.hpp
  EXPECT_EQ(std::get<std::vector<double>>(archive.arrays.at("particles/position")).size(), 15u);
  EXPECT_EQ(std::get<std::vector<float>>(archive.arrays.at("particles/shear")).size(), 30u);
}

TEST(StateIo, AbsentGroupsAreNotStored) {
  const FieldGroups none{.rate_stress = false,
                         .contact = false,
                         .mirrored = false,
                         .density_losses = false,
                         .smooth_walls = false};
  Archive archive;
  save_fields(loaded<2, Double>(std::vector<NewParticle>(2), none), archive);
  EXPECT_EQ(archive.arrays.count("particles/shear"), 0u);
  EXPECT_EQ(archive.arrays.count("particles/solid_initial_overlap"), 0u);
  EXPECT_EQ(archive.arrays.size(), 14u);
}

template <class Change>
std::string complaint_about(const Change& change) {
  Archive archive;
  const FieldGroups all;
  save_fields(loaded<2, Double>(std::vector<NewParticle>(4), all), archive);
  change(archive);
  auto particles = loaded<2, Double>({}, all);
  try {
    restore_fields(archive, particles);
  } catch (const UserError& error) {
    EXPECT_EQ(error.exit_code(), exit_files);
    return error.what();
  }
  return "none";
}

TEST(StateIo, CheckpointsOfAnotherKindAreRefused) {
  EXPECT_EQ(complaint_about([](Archive&) {}), "none");
  EXPECT_NE(complaint_about([](Archive& archive) {
              archive.arrays.erase("particles/velocity");
            }).find("does not hold 'particles/velocity' in the precision"),
            std::string::npos);
  EXPECT_NE(complaint_about([](Archive& archive) {
              archive.arrays["particles/velocity"] = std::vector<float>(8);
            }).find("does not hold 'particles/velocity' in the precision"),
            std::string::npos);
  EXPECT_NE(complaint_about([](Archive& archive) {
              archive.arrays["particles/velocity"] = std::vector<double>(6);
            }).find("field 'velocity' has another length"),
            std::string::npos);
}

TEST(Snapshot, FrameHoldsTheStateInSiUnits) {
  std::vector<NewParticle> start(4);
  for (std::size_t k = 0; k < 3; ++k) start[k].source = static_cast<std::uint16_t>(k);
  start[3].source = 1;
  start[0].flags = flag::upstream;
  start[1].position = {0.25, -0.5, 0.0};
  start[1].velocity = {1.0, 2.0, 0.0};
  for (std::uint32_t k = 0; k < 4; ++k) start[k].id = 10 + k;
  auto particles = loaded<2, Double>(start, {});
  particles.fractured[3] = 1;
  particles.compression[0] = 0.25;
  particles.pressure[1] = -7.5;
  auto s = SymmetricTensor<2, double>::zero();
  s(0, 0) = 1.0;
  s(1, 1) = 2.0;
  s(2, 2) = -3.0;
  s(0, 1) = 4.0;
  particles.shear[1] = s;
  const Frame frame = make_frame(particles, water_and_solid(1e-3), {{0, 0}, {1, 0}, {2, 0}});
  EXPECT_EQ(frame.category, (std::vector<Category>{Category::water, Category::solid,
                                                   Category::rigid, Category::fractured}));
  EXPECT_EQ(frame.id, (std::vector<std::uint32_t>{10, 11, 12, 13}));
  EXPECT_EQ(frame.source, (std::vector<std::uint16_t>{0, 1, 2, 1}));
  EXPECT_EQ(frame.upstream, (std::vector<std::uint8_t>{1, 0, 0, 0}));
  EXPECT_EQ(frame.position[1], (std::array<double, 3>{0.25, -0.5, 0.0}));
  EXPECT_EQ(frame.velocity[1], (std::array<double, 3>{1.0, 2.0, 0.0}));
  EXPECT_EQ(frame.density[0], 1250.0f);
  EXPECT_EQ(frame.pressure[1], -7.5f);
  EXPECT_EQ(frame.mass[0], 1e-3f);
  const Column* stress = find_column(frame, "deviatoric_stress");
  ASSERT_NE(stress, nullptr);
  EXPECT_EQ(stress->unit, "Pa");
  EXPECT_EQ(stress->label, "deviatoric stress");
  EXPECT_EQ(stress->components, 6);
  EXPECT_EQ(std::vector<float>(stress->values.begin() + 6, stress->values.begin() + 12),
            (std::vector<float>{1.0f, 2.0f, -3.0f, 4.0f, 0.0f, 0.0f}));
}

TEST(Snapshot, TensorsHaveTheOrderOfParaView) {
  auto s = SymmetricTensor<3, float>::zero();
  for (int a = 0; a < 3; ++a)
    for (int b = a; b < 3; ++b) s(a, b) = static_cast<float>(10 * (a + 1) + b + 1);
  std::vector<float> row;
  append_row(s, row);
  EXPECT_EQ(row, (std::vector<float>{11.0f, 22.0f, 33.0f, 12.0f, 23.0f, 13.0f}));
}

TEST(Snapshot, RunsWithoutAGroupDoNotShowItsFields) {
  const FieldGroups none{
      .rate_stress = false, .contact = false, .mirrored = false, .density_losses = false};
  const auto particles = loaded<2, Double>(std::vector<NewParticle>(1), none);
  EXPECT_TRUE(make_frame(particles, water_and_solid(1e-3), {{0, 0}}).columns.empty());
}

// A square lattice of water about the origin whose velocity is (1 + 2 x, 3 y).
std::vector<NewParticle> lattice(double spacing, double least_x) {
  std::vector<NewParticle> particles;
  for (int i = -5; i < 5; ++i)
    for (int j = -5; j < 5; ++j) {
      NewParticle particle;
      particle.position = {(i + 0.5) * spacing, (j + 0.5) * spacing, 0.0};
      particle.velocity = {1.0 + 2.0 * particle.position[0], 3.0 * particle.position[1], 0.0};
      if (particle.position[0] > least_x) particles.push_back(particle);
    }
  return particles;
}

template <class Particles>
void set_pressure(Particles& particles, double pressure) {
  thrust::fill(particles.pressure.begin(), particles.pressure.end(), pressure);
}

TEST(Probes, PointInterpolatesPressureAndVelocity) {
  auto particles =
      loaded<2, Double>(lattice(1e-3, -1.0), {.mirrored = false, .density_losses = false});
  set_pressure(particles, 5e4);
  Probes<2, Double> probes;
  std::vector<double> values;
  probes.sample_point(particles, {0.0, 0.0, 0.0}, false, values);
  ASSERT_EQ(values.size(), 4u);
  EXPECT_NEAR(values[0], 5e4, 1e-8);
  EXPECT_NEAR(values[1], 1.0, 1e-13);
  EXPECT_NEAR(values[2], 0.0, 1e-13);
  EXPECT_EQ(values[3], 0.0);
  values.clear();
  probes.sample_point(particles, {1.0, 1.0, 0.0}, false, values);  // no particle near
  EXPECT_EQ(values, std::vector<double>(4, 0.0));
}

// Water above y = 0 on solid, whose pressure is another: the mean of its normal stresses.
TEST(Probes, ReadWaterInAFaceAndSolidBelowIt) {
  auto start = lattice(1e-3, -1.0);
  for (NewParticle& particle : start) particle.source = particle.position[1] > 0.0 ? 0 : 1;
  auto particles = loaded<2, Double>(start, {.mirrored = false, .density_losses = false});
  for (std::size_t i = 0; i < start.size(); ++i)
    particles.pressure[i] = start[i].source == 0 ? 5e4 : 2e4;
  Probes<2, Double> probes;
  const auto pressure_at = [&](double y, bool of_gauge) {
    std::vector<double> values;
    probes.sample_point(particles, {0.3e-3, y, 0.0}, of_gauge, values);
    return values[0];
  };
  for (const double y : {0.0, 0.4e-3, 2e-3}) {
    EXPECT_NEAR(pressure_at(y, false), 5e4, 1e-8) << y;
    EXPECT_NEAR(pressure_at(y, true), 5e4, 1e-8) << y;
  }
  EXPECT_NEAR(pressure_at(-0.5e-3, false), 2e4, 1e-8);
  EXPECT_NEAR(pressure_at(-0.5e-3, true), 5e4, 1e-8);
  EXPECT_NEAR(pressure_at(-4e-3, true), 2e4, 1e-8);  // no water within reach
}

TEST(Probes, MirrorImagesCountAtASymmetryPlane) {
  auto particles = loaded<2, Double>(lattice(1e-3, 0.0), {});
  particles.mirrors.low = {0.0, -1.0};
  particles.mirrors.high = {1.0, 1.0};
  particles.mirrors.faces = particles.mirrors.low_face(0);
  set_pressure(particles, 5e4);
  Probes<2, Double> probes;
  std::vector<double> values;
  probes.sample_point(particles, {0.0, 0.0, 0.0}, false, values);
  EXPECT_NEAR(values[0], 5e4, 1e-8);
  EXPECT_NEAR(values[1], 0.0, 1e-13);  // the normal velocity of an image is opposite
}

TEST(Probes, PlaneSumsMassTimesAccelerationOfAllButWalls) {
  std::vector<NewParticle> start(3);
  start[1].source = 1;
  start[2].source = 2;
  auto particles = loaded<2, Double>(start, {});
  particles.acceleration[0] = Vector<2, double>{1e3, -2e3};
  particles.acceleration[1] = Vector<2, double>{4e3, 0.0};
  particles.acceleration[2] = Vector<2, double>{9e9, 9e9};
  Probes<2, Double> probes;
  std::vector<double> force;
  probes.sum_force(particles, force);
  EXPECT_NEAR(force[0], 5.0, 1e-13);
  EXPECT_NEAR(force[1], -2.0, 1e-13);
  EXPECT_EQ(force[2], 0.0);
}

TEST(Probes, APairIsAcrossAPlaneWhenItsFirstIsBelowAndItsSecondAbove) {
  std::vector<NewParticle> start(2);
  start[0].position = {0.0, -0.1, 0.0};
  start[1].position = {0.0, 0.1, 0.0};
  auto particles = loaded<2, Double>(start, {});
  const AcrossPlane<2> across{{0.0, 0.0}, {0.0, 1.0}};
  EXPECT_TRUE(across(particles.view(), 0, 1, 0));
  EXPECT_FALSE(across(particles.view(), 1, 0, 0));
  EXPECT_FALSE(across(particles.view(), 0, 0, 0));
}

}  // namespace
}  // namespace kerf::test
