// SPDX-License-Identifier: Apache-2.0
// A frame that travels with the nozzle: its windows have the layout and the bonds of one long
// block; nothing moves without a jet; results have the same bits for any number of threads and
// after a restart across a shift; mass, momentum and energy that are fed in and left behind are
// booked.
#include <oneapi/tbb/task_arena.h>

#include <set>

#include "geometry/graded_fill.hpp"
#include "model/material_laws.hpp"
#include "parallel/threads.hpp"
#include "simulation/populate.hpp"
#include "simulation/run_settings.hpp"
#include "solid/find_bonds.hpp"
#include "support/runs.hpp"
#include "support/travelling.hpp"

namespace kerf::test {
namespace {

// A run up to a number of shifts.
std::unique_ptr<Simulation> run_to_shift(const Case& description, std::uint64_t shifts) {
  auto simulation = make_simulation(description);
  while (simulation->shifts() < shifts && !simulation->finished()) simulation->advance();
  EXPECT_EQ(simulation->shifts(), shifts);
  return simulation;
}

Case without_water(TravellingText text) {
  Case c = text.read();
  c.jets[0].stop = 0.0;
  return c;
}

using Place = std::array<double, 3>;
using Bonds = std::map<Place, std::set<Place>>;

template <int D>
Bonds bonds_of(const std::vector<Place>& places, const Case& description) {
  SolidLayout<D> layout;
  layout.media = run_settings(description).media;
  for (const Place& x : places) layout.reference.push_back(Vector<D, double>::from(x));
  layout.medium_index.assign(places.size(), 0);
  const BondLists lists = BondFinder<D>(layout).find();
  Bonds bonds;
  for (std::size_t i = 0; i < places.size(); ++i)
    for (Index k = lists.begin[i]; k < lists.begin[i + 1]; ++k)
      bonds[places[i]].insert(places[lists.neighbour[k]]);
  return bonds;
}

TEST(TravellingFrame, WindowsAreThoseOfALongBlock) {
  TravellingText text;
  const Case travelling = without_water(text), whole = long_block(text).read();
  const auto frame = *travelling_frame(travelling);
  const auto simulation = run_to_shift(travelling, 4);
  const auto window = frame.window(4);
  std::vector<Place> block, there;
  for (const NewParticle& particle : initial_particles(whole, {}).particles) {
    block.push_back(particle.position);
    const double x = particle.position[0];
    if (x > window.minimum[0] && x < window.maximum[0]) there.push_back(particle.position);
  }
  const Frame layout = simulation->layout();
  ASSERT_EQ(layout.position, there);  // in this order, bit for bit
  EXPECT_EQ(there.size(), 40u * 12u);
  const Bonds of_window = bonds_of<2>(there, travelling), of_block = bonds_of<2>(block, whole);
  const std::set<Place> present(there.begin(), there.end());
  for (const Place& x : there) {
    std::set<Place> expected;
    for (const Place& y : of_block.at(x))
      if (present.count(y) != 0) expected.insert(y);
    EXPECT_EQ(of_window.at(x), expected);
  }
  // The run has all of these bonds.
  const Frame now = simulation->frame();
  const Column* damage = find_column(now, "damage");
  ASSERT_NE(damage, nullptr);
  for (std::size_t i = 0; i < now.id.size(); ++i) {
    if (now.category[i] == Category::solid) {
      EXPECT_EQ(damage->values[i], 0.0f);
    }
  }
}

// The levels of a graded window depend on the distance across the path alone.
TEST(TravellingFrame, GradedWindowsAreThoseOfALongBlock) {
  const Case travelling = graded_window().read();
  const auto frame = *travelling_frame(travelling);
  Body block = travelling.bodies[0];
  block.shape.box = frame.path;
  const auto whole = fill_levels(block, 3);
  std::set<int> levels;
  for (const std::uint64_t shifts : {std::uint64_t{0}, std::uint64_t{3}, frame.most}) {
    const Box window = frame.window(shifts);
    std::vector<Place> there, laid_out;
    std::vector<std::uint16_t> medium_there, medium_laid_out;
    const auto media = media_of_levels(travelling)[0];
    for (const GradedParticle& particle : whole) {
      const double x = particle.position[0];
      if (x < window.minimum[0] || x > window.maximum[0]) continue;
      there.push_back(particle.position);
      medium_there.push_back(media[static_cast<std::size_t>(particle.level)]);
      levels.insert(particle.level);
    }
    for (const NewParticle& particle : window_particles(travelling, shifts)) {
      laid_out.push_back(particle.position);
      medium_laid_out.push_back(particle.source);
    }
    EXPECT_EQ(laid_out, there);
    EXPECT_EQ(medium_laid_out, medium_there);
  }
  EXPECT_EQ(levels.size(), 2u);
}

class TravellingFrameIn : public testing::TestWithParam<int> {
 protected:
  static TravellingText text() { return GetParam() == 2 ? TravellingText{} : graded_window(); }
};

TEST_P(TravellingFrameIn, NothingMovesWithoutAJet) {
  const auto simulation = run_to_shift(without_water(text()), GetParam() == 2 ? 5 : 2);
  take_steps(*simulation, 100);
  const Frame frame = simulation->frame(), layout = simulation->layout();
  const auto place = by_id(layout);
  std::size_t solid = 0;
  for (std::size_t i = 0; i < frame.id.size(); ++i) {
    if (frame.category[i] != Category::solid) continue;
    ++solid;
    EXPECT_EQ(frame.position[i], layout.position[place.at(frame.id[i])]);
    EXPECT_EQ(frame.velocity[i], Place{});
  }
  EXPECT_EQ(solid, layout.id.size());
  const Balance balance = simulation->balance();
  EXPECT_EQ(balance.solid_energy(), 0.0);
  EXPECT_EQ(balance.energy_left, 0.0);
  EXPECT_NEAR(balance.mass_left, balance.mass_fed, 1e-12 * balance.mass_fed);
  EXPECT_NEAR(balance.mass_error(), 0.0, 1e-12);
}

TEST_P(TravellingFrameIn, SameBitsForAnyNumberOfThreads) {
  const Case c = text().read();
  const auto run_on = [&](int threads) {
    set_threads(threads);
    return tbb::task_arena(threads).execute(
        [&] { return run_to_shift(c, GetParam() == 2 ? 3 : 1); });
  };
  const auto one = run_on(1);
  EXPECT_GT(one->balance().dissipated_fracture, 0.0);
  expect_same_run(*one, *run_on(3));
  set_threads(0);
}

TEST(TravellingFrame, SameBitsAfterARestart) {
  const std::string plastic =
      "plasticity = \"von_mises\"\nyield_strength = \"2 kPa\"\nfailure_strain = 0.2";
  for (const std::string& law : {TravellingText{}.material, plastic}) {
    TravellingText text;
    text.material = law;
    const Case c = text.read();
    const auto straight = run_to_shift(c, 2);
    take_steps(*straight, 50);
    auto resumed = make_simulation(c);
    resumed->restore(saved(*straight));
    expect_same_state(saved(*straight), saved(*resumed));
    // Restarts directly before and after a shift too.
    while (straight->shifts() < 3) {
      straight->advance();
      resumed->advance();
      if (straight->step() % 40 != 0 && straight->shifts() < 3) continue;
      const Archive archive = saved(*resumed);
      resumed = make_simulation(c);
      resumed->restore(archive);
    }
    take_steps(*straight, 100);
    take_steps(*resumed, 100);
    expect_same_run(*straight, *resumed);
  }
}

INSTANTIATE_TEST_SUITE_P(Dimensions, TravellingFrameIn, testing::Values(2, 3));

// Of a graded, nearly incompressible body too.
TEST(TravellingFrame, SameBitsAfterARestartIn3D) {
  const Case c = graded_window().read();
  const auto straight = run_to_shift(c, 1);
  auto resumed = make_simulation(c);
  resumed->restore(saved(*straight));
  expect_same_state(saved(*straight), saved(*resumed));
  take_steps(*straight, 60);
  take_steps(*resumed, 60);
  expect_same_run(*straight, *resumed);
  EXPECT_NEAR(straight->balance().mass_error(), 0.0, 1e-12);
  EXPECT_LT(std::abs(straight->balance().energy_drift()), 0.02);
}

// The balance closes as well as that of a run in one long block.
TEST(TravellingFrame, BalanceClosesOverShifts) {
  TravellingText text;
  const auto moving = run_to_shift(text.read(), 5);
  const auto whole = make_simulation(long_block(text).read());
  while (whole->time() < moving->time()) whole->advance();
  const Balance a = moving->balance(), b = whole->balance();
  EXPECT_GT(a.mass_left, 0.0);
  EXPECT_NEAR(a.mass_error(), 0.0, 1e-12);
  EXPECT_NEAR(a.momentum_error(), 0.0, 1e-4);
  EXPECT_NEAR(a.energy_drift(), b.energy_drift(), 0.01);
  // What is left behind and what is in the window are together what the long block holds.
  const auto held = [](const Balance& balance) {
    return balance.kinetic + balance.solid_energy() + balance.pressure_work;
  };
  EXPECT_NEAR(held(a) + a.energy_left + a.energy_out, held(b) + b.energy_out,
              0.05 * b.energy_supplied());
}

}  // namespace
}  // namespace kerf::test
