// SPDX-License-Identifier: Apache-2.0
// These signals describe symmetry, splitting and stretch.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>

#include "analysis/pieces.hpp"
#include "analysis/workpiece.hpp"
#include "model/case.hpp"
#include "verification/signal.hpp"

namespace kerf {

namespace {

struct Entry {
  std::uint16_t source;
  std::array<double, 3> position;
};

// Returns the distance between the mirror image of a particle and the nearest particle of its
// source. `sorted` is sorted by source and y, which the mirror does not change, so that few
// particles are tested.
double distance_to_image(const Entry& one, const std::vector<Entry>& sorted, std::size_t axis,
                         double reach) {
  std::array<double, 3> image = one.position;
  image[axis] = -image[axis];
  const auto first =
      std::lower_bound(sorted.begin(), sorted.end(), one, [&](const Entry& a, const Entry& b) {
        return a.source != b.source ? a.source < b.source : a.position[1] < b.position[1] - reach;
      });
  double least = reach;
  for (auto other = first; other != sorted.end(); ++other) {
    if (other->source != one.source || other->position[1] > image[1] + least) break;
    least = std::min(least, std::hypot(other->position[0] - image[0], other->position[1] - image[1],
                                       other->position[2] - image[2]));
  }
  return least;
}

}  // namespace

// Largest distance, over particles and in spacings, between a particle's mirror image in the plane
// x = 0 (or z = 0) and the particle of the same body or jet nearest to it; at most 1.
Signal asymmetry_signal(const Parameters& parameters, const Beginning& beginning) {
  const std::size_t axis = parameters.text("axis") == "z" ? 2 : 0;
  double spacing = std::numeric_limits<double>::infinity();
  for (const float s : beginning.frame.spacing) spacing = std::min<double>(spacing, s);
  return [axis, spacing](Moment& moment) {
    const Frame& frame = moment.frame();
    std::vector<Entry> entries;
    for (std::size_t row = 0; row < frame.id.size(); ++row)
      entries.push_back({frame.source[row], frame.position[row]});
    std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
      return a.source != b.source ? a.source < b.source : a.position[1] < b.position[1];
    });
    double worst = 0.0;
    for (const Entry& entry : entries)
      worst = std::max(worst, distance_to_image(entry, entries, axis, spacing) / spacing);
    return worst;
  };
}

// Splitting of the jet: mass of its water above the surface at which it aims that moves away from
// the axis at more than a tenth of its speed, on the side with less of it, as a length of jet over
// its width.
Signal jet_split_signal(const Parameters&, const Beginning& beginning) {
  const Jet jet = beginning.description.jets.at(0);
  const auto source = static_cast<std::uint16_t>(beginning.description.bodies.size());
  const double density =
      beginning.description.materials.at(static_cast<std::size_t>(jet.material)).density;
  return [jet, source, density](Moment& moment) {
    const Frame& frame = moment.frame();
    double left = 0.0, right = 0.0;
    for (std::size_t row = 0; row < frame.id.size(); ++row) {
      if (frame.source[row] != source || frame.position[row][1] < jet.position[1]) continue;
      const double x = frame.position[row][0] - jet.position[0];
      const double v = frame.velocity[row][0];
      if (std::abs(v) < 0.1 * jet.speed) continue;
      if (x > 0.0 && v > 0.0) right += frame.mass[row];
      if (x < 0.0 && v < 0.0) left += frame.mass[row];
    }
    return std::min(left, right) / (density * jet.width * jet.width);
  };
}

// Share of the fractured solid whose initial position is within one jet width of the axis.
Signal fractured_below_jet_signal(const Parameters&, const Beginning& beginning) {
  const Jet jet = beginning.description.jets.at(0);
  auto offset = std::make_shared<std::vector<double>>(beginning.frame.id.size(), 0.0);
  for (std::size_t row = 0; row < beginning.frame.id.size(); ++row)
    (*offset)[beginning.frame.id[row]] =
        std::hypot(beginning.frame.position[row][0] - jet.position[0],
                   beginning.frame.position[row][2] - jet.position[2]);
  return [offset, width = jet.width](Moment& moment) {
    const Frame& frame = moment.frame();
    double below = 0.0, total = 0.0;
    for (std::size_t row = 0; row < frame.id.size(); ++row) {
      if (frame.category[row] != Category::fractured) continue;
      total += frame.mass[row];
      if ((*offset)[frame.id[row]] < width) below += frame.mass[row];
    }
    return total > 0.0 ? below / total : 0.0;
  };
}

// Largest distance between solid particles that are neighbours in the initial layout, over their
// initial distance.
Signal largest_stretch_signal(const Parameters&, const Beginning& beginning) {
  const auto solid =
      std::make_shared<const Workpiece>(make_workpiece(beginning.description, beginning.frame));
  const auto neighbours = find_bonds(*solid);
  return [solid, neighbours](Moment& moment) {
    const Frame& frame = moment.frame();
    const auto rows = locate(*solid, frame);
    const auto distance = [](const Point& a, const Point& b) {
      return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    };
    double largest = 0.0;
    for (const auto& [a, b] : neighbours) {
      if (rows[a] == Workpiece::none || rows[b] == Workpiece::none) continue;
      largest = std::max(largest, distance(frame.position[rows[a]], frame.position[rows[b]]) /
                                      distance(solid->position[a], solid->position[b]));
    }
    return largest;
  };
}

}  // namespace kerf
