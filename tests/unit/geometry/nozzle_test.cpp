// SPDX-License-Identifier: Apache-2.0
// Inflow against the integral of rho V A, and its lattice.
#include "geometry/nozzle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "support/small_cases.hpp"

namespace kerf::test {
namespace {

constexpr double density = 998.0;

double section(const Jet& jet, int dimension) {
  return dimension == 2 ? jet.width : std::numbers::pi * jet.width * jet.width / 4.0;
}

struct Named {
  const char* name;
  int dimension;
  Jet description;
};

std::vector<Named> jets() {
  std::vector<Named> all;
  for (int dimension : {2, 3}) {
    all.push_back({"whole", dimension, jet(10e-3, 1e-3, {}, 0.02)});
    all.push_back({"not a multiple", dimension, jet(9.37e-3, 1e-3, {0.01, 0.02, 0.0}, 0.02)});
    all.push_back({"narrower than a spacing", dimension, jet(0.4e-3, 1e-3, {}, 0.02)});
    Jet inclined = jet(5.2e-3, 0.7e-3, {0.01, 0.05, -0.01}, 0.013);
    inclined.angle = 0.6;
    inclined.azimuth = dimension == 3 ? 1.1 : 0.0;
    inclined.start = 1.3e-3;
    inclined.stop = 7.7e-3;
    all.push_back({"inclined, for a while", dimension, inclined});
    Jet profiled = jet(8e-3, 1e-3, {}, 0.02);
    profiled.profile = "(1 - 0.9*r)^(1/7)";
    all.push_back({"profile", dimension, profiled});
  }
  return all;
}

// Returns times of steps of random length, 0.1 to 1.5 spacings long.
std::vector<double> times_until(double end, const Jet& jet) {
  std::mt19937 engine(9);
  std::uniform_real_distribution<double> length(0.1, 1.5);
  std::vector<double> times{0.0};
  while (times.back() < end)
    times.push_back(times.back() + length(engine) * jet.spacing / jet.speed);
  return times;
}

double along(const Nozzle& nozzle, const Point& p) {
  double sum = 0.0;
  for (std::size_t a = 0; a < 3; ++a) sum += (p[a] - nozzle.exit()[a]) * nozzle.direction()[a];
  return sum;
}

TEST(Nozzle, MassIsTheIntegralOfTheFlow) {
  for (const auto& [name, dimension, description] : jets()) {
    SCOPED_TRACE(std::string(name) + (dimension == 2 ? ", slot" : ", round"));
    Nozzle nozzle(description, density, dimension);
    const double flow = density * description.speed * section(description, dimension);  // kg/s
    std::size_t emitted = 0;
    for (double t : times_until(0.02, description)) {
      emitted += nozzle.emit(t).size();
      const double open = std::max(0.0, std::min(t, description.stop) - description.start);
      const double mass = static_cast<double>(emitted) * nozzle.particle_mass();
      const double carried = nozzle.mass_due(t) - nozzle.mass_emitted();
      EXPECT_NEAR(nozzle.mass_emitted(), mass, 1e-12 * mass);
      EXPECT_NEAR(mass + carried, flow * open, 1e-12 * flow * std::max(open, 1e-3));
      // The remainder is less than a layer, and the emitted mass never exceeds the integral.
      const double layer = nozzle.particle_mass() * static_cast<double>(nozzle.columns());
      EXPECT_GE(carried, -1e-12 * flow * 0.02);
      EXPECT_LT(carried, layer * (1.0 + 1e-9));
    }
    EXPECT_GT(emitted, 20 * nozzle.columns());
  }
}

// The mass of a particle is that of a cell: rho d^2 (d^3) if the width is a multiple of d.
TEST(Nozzle, ParticlesHaveTheMassOfTheirCell) {
  const Nozzle slot(jet(10e-3, 1e-3, {}, 0.02), density, 2);
  EXPECT_EQ(slot.columns(), 10u);
  EXPECT_NEAR(slot.particle_mass(), density * 1e-6, 1e-12 * density * 1e-6);
  const Nozzle round(jet(10e-3, 1e-3, {}, 0.02), density, 3);
  EXPECT_NEAR(static_cast<double>(round.columns()), 25.0 * std::numbers::pi, 4.0);
  EXPECT_NEAR(round.particle_mass(), density * 1e-9, 0.05 * density * 1e-9);
}

// At a plane through the axis the columns of one side remain unchanged: half the flow. Two planes
// leave a quarter.
TEST(Nozzle, EndsAtSymmetryPlanes) {
  const Box domain{{0.0, -1.0, 0.0}, {1.0, 1.0, 1.0}};
  const Faces one{{true, false, false}, {}}, two{{true, false, true}, {}};
  for (int dimension : {2, 3}) {
    const Jet description = jet(10e-3, 1e-3, {}, 0.02);
    const Nozzle whole(description, density, dimension);
    Nozzle half(description, density, dimension), quarter = half;
    half.cut_at(one, domain);
    quarter.cut_at(dimension == 3 ? two : one, domain);
    EXPECT_EQ(2 * half.columns(), whole.columns());
    EXPECT_EQ((dimension == 3 ? 4 : 2) * quarter.columns(), whole.columns());
    EXPECT_EQ(half.particle_mass(), whole.particle_mass());
    EXPECT_NEAR(2.0 * half.mass_due(0.01), whole.mass_due(0.01), 1e-12 * whole.mass_due(0.01));
    for (const InletParticle& particle : half.emit(0.01)) EXPECT_GT(particle.position[0], 0.0);
    EXPECT_LT(half.mass_due(0.01) - half.mass_emitted(),
              static_cast<double>(half.columns()) * half.particle_mass());
  }
}

// Columns are distributed evenly about the axis, within the section, on the side of the slot in the
// paper.
TEST(Nozzle, ColumnsFillTheSection) {
  for (const auto& [name, dimension, description] : jets()) {
    SCOPED_TRACE(std::string(name) + (dimension == 2 ? ", slot" : ", round"));
    const Nozzle nozzle(description, density, dimension);
    const auto water = nozzle.standing_water();
    Point mean{};
    for (std::size_t k = 0; k < nozzle.columns(); ++k) {
      const Point& p = water[k].position;
      const double s = along(nozzle, p);
      double square = 0.0;
      for (std::size_t a = 0; a < 3; ++a) {
        const double offset = p[a] - nozzle.exit()[a] - s * nozzle.direction()[a];
        mean[a] += offset;
        square += offset * offset;
      }
      EXPECT_LE(std::sqrt(square), 0.5 * description.width);
      if (dimension == 2) {
        EXPECT_EQ(p[2], description.position[2] - 0.0);
      }
    }
    for (double m : mean) EXPECT_NEAR(m, 0.0, 1e-12 * description.width * 100.0);
  }
}

TEST(Nozzle, DirectionAndExit) {
  Jet description = jet(5e-3, 1e-3, {0.1, 0.2, 0.3}, 0.05);
  description.angle = std::numbers::pi / 6.0;
  description.azimuth = std::numbers::pi / 2.0;
  const Nozzle nozzle(description, density, 3);
  const Point direction{0.0, -std::sqrt(3.0) / 2.0, 0.5};
  for (std::size_t a = 0; a < 3; ++a) {
    EXPECT_NEAR(nozzle.direction()[a], direction[a], 1e-15);
    EXPECT_NEAR(nozzle.exit()[a], description.position[a] - 0.05 * direction[a], 1e-15);
  }
}

// Returns the particles of each column, moved along it at their own speed since their entry,
// including the initial water.
class Columns {
 public:
  struct Mover {
    double place, speed;  // along the jet
  };

  explicit Columns(const Nozzle& nozzle) : nozzle_(nozzle), columns_(nozzle.columns()) {
    const auto standing = nozzle.standing_water();
    for (std::size_t k = 0; k < standing.size(); ++k)
      columns_[k % nozzle.columns()].push_back(
          {along(nozzle, standing[k].position), standing[k].speed});
  }

  void go_on_to(double t) {
    const double open = nozzle_.open_time(t) - nozzle_.open_time(last_);
    for (auto& column : columns_)
      for (Mover& mover : column) mover.place += mover.speed * open;
    const auto before = nozzle_.emitted();
    const auto water = nozzle_.emit(t);
    std::size_t next = 0;
    for (std::size_t k = 0; k < columns_.size(); ++k)
      for (std::uint64_t n = before[k]; n < nozzle_.emitted()[k]; ++n, ++next)
        columns_[k].push_back({along(nozzle_, water.at(next).position), water[next].speed});
    EXPECT_EQ(next, water.size());
    last_ = t;
  }

  // They are sorted from the last one.
  std::vector<std::vector<Mover>> sorted() const {
    auto result = columns_;
    for (auto& column : result)
      std::sort(column.begin(), column.end(),
                [](const Mover& a, const Mover& b) { return a.place < b.place; });
    return result;
  }

 private:
  Nozzle nozzle_;
  std::vector<std::vector<Mover>> columns_;
  double last_ = 0.0;
};

// Neighbours are d apart everywhere, so there is one particle at each site.
TEST(Nozzle, LayersAreASpacingApart) {
  for (const auto& [name, dimension, description] : jets()) {
    SCOPED_TRACE(std::string(name) + (dimension == 2 ? ", slot" : ", round"));
    Columns columns(Nozzle(description, density, dimension));
    for (double t : times_until(0.01, description)) columns.go_on_to(t);
    const double d = description.spacing;
    for (const auto& column : columns.sorted()) {
      for (std::size_t n = 1; n < column.size(); ++n)
        EXPECT_NEAR(column[n].place - column[n - 1].place, d, 1e-11 * d);
      // A particle that has just left the nozzle has water behind it over the full support, 3 d.
      const auto free = std::find_if(column.begin(), column.end(),
                                     [](const auto& mover) { return mover.place > 0.0; });
      ASSERT_NE(free, column.end());
      EXPECT_LE(column.front().place, free->place - 3.0 * d * (1.0 - 1e-9));
    }
  }
}

TEST(Nozzle, NothingBeforeTheStartNorAfterTheStop) {
  Jet description = jet(5e-3, 1e-3, {}, 0.02);
  description.start = 1e-3;
  description.stop = 2e-3;
  Nozzle nozzle(description, density, 2);
  EXPECT_TRUE(nozzle.emit(0.999e-3).empty());
  EXPECT_EQ(nozzle.emit(1.9999e-3).size(), 4 * nozzle.columns());  // 4.9995 spacings
  EXPECT_EQ(nozzle.emit(2.001e-3).size(), nozzle.columns());       // the fifth, at the stop
  EXPECT_TRUE(nozzle.emit(1.0).empty());
  EXPECT_EQ(nozzle.open_time(1.0), 1e-3);
}

TEST(Nozzle, ProfileKeepsTheMeanSpeed) {
  Jet description = jet(10e-3, 1e-3, {}, 0.02);
  description.profile = "1 - r^2";
  for (int dimension : {2, 3}) {
    Nozzle nozzle(description, density, dimension);
    const auto water = nozzle.standing_water();
    double mean = 0.0, fastest = 0.0;
    for (std::size_t k = 0; k < nozzle.columns(); ++k) {
      mean += water[k].speed / static_cast<double>(nozzle.columns());
      fastest = std::max(fastest, water[k].speed);
    }
    EXPECT_NEAR(mean, 5.0, 1e-12 * 5.0);
    // For a parabola the speed on the axis is 3/2 of the mean of a slot, twice that of a round
    // section.
    EXPECT_NEAR(fastest / mean, dimension == 2 ? 1.5 : 2.0, 0.05);
  }
}

// A nozzle with the restored counts of another emits the same particles.
TEST(Nozzle, ResumesFromItsCounts) {
  for (const auto& [name, dimension, description] : jets()) {
    SCOPED_TRACE(std::string(name) + (dimension == 2 ? ", slot" : ", round"));
    Nozzle whole(description, density, dimension);
    Nozzle resumed = whole;
    const auto times = times_until(0.008, description);
    for (std::size_t n = 0; n < times.size(); ++n) {
      if (n % 5 == 0) {
        resumed = Nozzle(description, density, dimension);
        resumed.restore(whole.emitted());
      }
      const auto a = whole.emit(times[n]), b = resumed.emit(times[n]);
      ASSERT_EQ(a.size(), b.size());
      for (std::size_t k = 0; k < a.size(); ++k) {
        EXPECT_EQ(a[k].position, b[k].position);
        EXPECT_EQ(a[k].speed, b[k].speed);
      }
    }
    EXPECT_EQ(whole.mass_emitted(), resumed.mass_emitted());
  }
}

// The count is the same integer for any length of the run and of its steps.
TEST(Nozzle, CountDoesNotDependOnTheSteps) {
  const Jet description = jet(7e-3, 1e-3, {}, 0.02);
  Nozzle fine(description, density, 2), coarse(description, density, 2);
  std::size_t count = 0;
  for (int n = 0; n <= 100000; ++n) count += fine.emit(n * 1e-4 / 7.0).size();
  EXPECT_EQ(count, coarse.emit(100000 * 1e-4 / 7.0).size());
  EXPECT_EQ(fine.mass_emitted(), coarse.mass_emitted());
}

}  // namespace
}  // namespace kerf::test
