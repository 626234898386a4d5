// SPDX-License-Identifier: Apache-2.0
#include "study/design.hpp"

#include <boost/random/sobol.hpp>
#include <boost/random/uniform_01.hpp>
#include <numeric>
#include <utility>

#include "core/random.hpp"

namespace kerf {

namespace {

// Returns a permutation of 0 ... count - 1 (Fisher & Yates) from the generator's random numbers.
std::vector<std::size_t> shuffled(std::size_t count, std::uint64_t seed) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t left = count; left > 1; --left) {
    const auto chosen =
        static_cast<std::size_t>(random_number(seed, left) * static_cast<double>(left));
    std::swap(order[left - 1], order[chosen]);
  }
  return order;
}

}  // namespace

std::vector<Setting> grid(const std::vector<Axis>& axes) {
  std::vector<Setting> settings{Setting{}};
  for (const Axis& axis : axes) {
    std::vector<Setting> longer;
    for (const Setting& setting : settings)
      for (std::size_t level = 0; level < axis.levels(); ++level) {
        longer.push_back(setting);
        axis.put_level(level, longer.back());
      }
    settings = std::move(longer);
  }
  return settings;
}

std::vector<std::vector<double>> latin_hypercube(std::size_t dimensions, std::size_t count,
                                                 std::uint64_t seed) {
  std::vector<std::vector<double>> points(count, std::vector<double>(dimensions));
  for (std::size_t d = 0; d < dimensions; ++d) {
    const std::uint64_t order_seed = random_bits(seed, 2 * d);
    const std::uint64_t place_seed = random_bits(seed, 2 * d + 1);
    const auto order = shuffled(count, order_seed);
    for (std::size_t i = 0; i < count; ++i)
      points[i][d] = (static_cast<double>(order[i]) + random_number(place_seed, i)) /
                     static_cast<double>(count);
  }
  return points;
}

std::vector<std::vector<double>> sobol(std::size_t dimensions, std::size_t count) {
  boost::random::sobol engine(dimensions);
  boost::random::uniform_01<double> uniform;
  std::vector<std::vector<double>> points(count, std::vector<double>(dimensions));
  for (auto& point : points)
    for (double& coordinate : point) coordinate = uniform(engine);
  return points;
}

std::vector<Setting> settings_of(const Design& design, const std::vector<Axis>& axes) {
  if (design.kind == DesignKind::grid) return grid(axes);
  const auto points = design.kind == DesignKind::sobol
                          ? sobol(axes.size(), design.runs)
                          : latin_hypercube(axes.size(), design.runs, design.seed);
  std::vector<Setting> settings(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t d = 0; d < axes.size(); ++d) axes[d].put_share(points[i][d], settings[i]);
  return settings;
}

}  // namespace kerf
