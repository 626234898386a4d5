// SPDX-License-Identifier: Apache-2.0
// In a run of a fast jet the neighbour list has, at the moment when the pairs are summed, every
// pair within reach, against all pairs; and it is not built for every step.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstring>
#include <set>

#include "input/read.hpp"
#include "model/case.hpp"
#include "simulation/run_settings.hpp"
#include "standard/standard.hpp"

namespace kerf {
// They are in the engine.
extern template class ParticleRun<2, Mixed, StandardTraits>;
extern template class ParticleRun<3, Mixed, StandardTraits>;
extern template class Standard<2, Mixed>;
extern template class Standard<3, Mixed>;
}  // namespace kerf

namespace kerf::test {
namespace {

std::string fast_jet(int dimension) {
  const bool plane = dimension == 2;
  const auto point = [&](const char* x, const char* y) {
    return plane ? fmt::format("[\"{}\", \"{}\"]", x, y)
                 : fmt::format("[\"{0}\", \"{1}\", \"{0}\"]", x, y);
  };
  return fmt::format(R"(title = "a jet at 0.6 of the speed of sound"
dimension = {}
formulation = "standard"
[time]
end = "1 ms"
[domain]
minimum = {}
maximum = {}
[materials.water]
kind = "water"
density = "1000 kg/m3"
sound_speed = "300 m/s"
[materials.gel]
kind = "elastic"
density = "1000 kg/m3"
youngs_modulus = "10 MPa"
poisson_ratio = 0.3
[[body]]
name = "block"
material = "gel"
shape = {{ type = "box", minimum = {}, maximum = {} }}
spacing = "0.25 mm"
[[jet]]
name = "jet"
material = "water"
speed = "180 m/s"
{} = "1 mm"
position = {}
standoff = "1 mm"
spacing = "0.25 mm"
)",
                     dimension, point("-6 mm", "-4 mm"), point("6 mm", "6 mm"),
                     point("-2 mm", "-2 mm"), point("2 mm", "0 mm"), plane ? "width" : "diameter",
                     point("0 mm", "0 mm"));
}

template <int D>
class ListedRun final : private Standard<D, Mixed> {
  using Run = Standard<D, Mixed>;

 public:
  explicit ListedRun(const Case& description) : Run(run_settings(description)) {}

  void take_step() {
    const auto before = to_host(Run::particles_.build_position);
    Run::advance();
    const auto after = to_host(Run::particles_.build_position);
    builds += after.size() != before.size() ||
              std::memcmp(after.data(), before.data(), after.size() * sizeof(after[0])) != 0;
  }
  // Checks the list for the middle of the last step, which drift and prescribed motion have reached
  // from its start.
  void check() {
    const auto view = Run::particles_.view();
    const auto list = Run::list_.view();
    const double half = 0.5 * Run::last_step().dt;
    std::vector<Vector<D, double>> middle;
    for (Index i = 0; i < Run::particles_.size(); ++i)
      middle.push_back(view.start_position[i] +
                       half * Vector<D, double>::from(view.start_velocity[i]));
    for (Index i = 0; i < middle.size(); ++i) {
      const std::set<Index> listed(list.neighbour + list.begin[i], list.neighbour + list.end[i]);
      for (Index j = 0; j < middle.size(); ++j) {
        if (j == i) continue;
        const double reach = ContactPairs::reach(view, i, j);
        if (!(norm(middle[i] - middle[j]) < reach)) continue;
        ++pairs;
        came += !(norm(view.build_position[i] - view.build_position[j]) < reach);
        missing += listed.count(j) == 0;
      }
    }
  }

  int builds = 0;  // of lists in steps
  long pairs = 0, came = 0,
       missing = 0;  // within reach; of them since the list was built; unlisted
};

template <int D>
void expect_complete_lists() {
  ListedRun<D> run(parse_case(fast_jet(D), "fast.toml"));
  constexpr int steps = 120, checked_every = D == 2 ? 1 : 12;
  for (int step = 0; step < steps; ++step) {
    run.take_step();
    if (step % checked_every == checked_every - 1) run.check();
  }
  EXPECT_EQ(run.missing, 0) << "of " << run.pairs;
  EXPECT_GT(run.came, 0.001 * static_cast<double>(run.pairs));
  EXPECT_LT(run.builds, 9 * steps / 10) << D;
}

TEST(ListInRun, HasEveryPairOfAFastJet2D) {
  expect_complete_lists<2>();
}
TEST(ListInRun, HasEveryPairOfAFastJet3D) {
  expect_complete_lists<3>();
}

}  // namespace
}  // namespace kerf::test
