// SPDX-License-Identifier: Apache-2.0
#include "analysis/fragment_sizes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kerf {
namespace {

struct Weighted {
  double value = 0.0;
  double mass = 0.0;
};

// Returns the values below which the shares of the mass lie; each entry stands in the middle of its
// own mass, and values between two entries are interpolated linearly.
std::array<double, 3> find_shares(std::vector<Weighted> entries) {
  std::sort(entries.begin(), entries.end(),
            [](const Weighted& a, const Weighted& b) { return a.value < b.value; });
  double total = 0.0;
  for (const Weighted& entry : entries) total += entry.mass;
  std::array<double, 3> values{};
  for (std::size_t n = 0; n < values.size(); ++n) {
    const double wanted = fragment_shares[n] * total;
    double below = 0.0, last_middle = 0.0, last_value = entries.front().value;
    values[n] = entries.back().value;
    for (const Weighted& entry : entries) {
      const double middle = below + entry.mass / 2.0;
      if (middle >= wanted) {
        const double part =
            middle > last_middle ? (wanted - last_middle) / (middle - last_middle) : 1.0;
        values[n] = last_value + part * (entry.value - last_value);
        break;
      }
      below += entry.mass;
      last_middle = middle;
      last_value = entry.value;
    }
  }
  return values;
}

double equivalent_diameter(double volume, int dimension) {
  return dimension == 3 ? std::cbrt(6.0 * volume / std::numbers::pi)
                        : std::sqrt(4.0 * volume / std::numbers::pi);
}

}  // namespace

FragmentSizes measure_fragments(const std::vector<Fragment>& fragments, double total_mass,
                                int dimension) {
  FragmentSizes sizes;
  std::vector<Weighted> mass, diameter, speed;
  for (const Fragment& fragment : fragments) {
    if (fragment.mass > piece_mass_fraction * total_mass) continue;
    const auto& v = fragment.velocity;
    mass.push_back({fragment.mass, fragment.mass});
    diameter.push_back({equivalent_diameter(fragment.volume, dimension), fragment.mass});
    speed.push_back({std::hypot(v[0], v[1], v[2]), fragment.mass});
    sizes.total_mass += fragment.mass;
    sizes.largest_mass = std::max(sizes.largest_mass, fragment.mass);
  }
  sizes.count = mass.size();
  if (mass.empty()) return sizes;
  sizes.mass = find_shares(std::move(mass));
  sizes.diameter = find_shares(std::move(diameter));
  sizes.speed = find_shares(std::move(speed));
  return sizes;
}

const MetricList<FragmentSizes>& FragmentSizes::metrics() {
  static const MetricList<FragmentSizes> list{
      {"small_fragments.count", "1", "small fragments",
       "Number of intact fragments too small to count as pieces.", &FragmentSizes::count},
      {"small_fragments.total_mass", extensive("kg"), "mass of the small fragments",
       "Mass of all small fragments together.", &FragmentSizes::total_mass},
      {"small_fragments.largest", extensive("kg"), "mass of the largest small fragment",
       "Mass of the heaviest small fragment.", &FragmentSizes::largest_mass},
      {"small_fragments.mass", extensive("kg"), "masses of small fragments",
       "Fragment masses below which 10, 50 and 90 % of the mass of the small fragments lie.",
       &FragmentSizes::mass},
      {"small_fragments.diameter", "m", "diameters of small fragments",
       "Diameters of the disc or sphere of the same volume, below which 10, 50 and 90 % of the "
       "mass of the small fragments lie.",
       &FragmentSizes::diameter},
      {"small_fragments.speed", "m/s", "speeds of small fragments",
       "Speeds below which 10, 50 and 90 % of the mass of the small fragments lie.",
       &FragmentSizes::speed}};
  return list;
}

FragmentSizes FragmentSizes::measure(const KerfScene& scene) {
  return measure_fragments(scene.fragments, scene.view.workpiece.total_mass,
                           scene.view.frame.dimension);
}

}  // namespace kerf
