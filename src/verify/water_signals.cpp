// SPDX-License-Identifier: Apache-2.0
// Signals of water on other matter: how far a jet has come into another liquid, and whether water
// leaks into a solid.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "measure/jet_axis.hpp"
#include "verify/signal.hpp"

namespace kerf {

namespace {

// Where particles are, by x.
using Line = std::vector<std::array<double, 2>>;

// Height of the line at x; no line where x lies beyond its ends.
double height_at(const Line& line, double x) {
  const auto right = std::lower_bound(line.begin(), line.end(), x,
                                      [](const auto& point, double at) { return point[0] < at; });
  if (right == line.begin() || right == line.end()) return -std::numeric_limits<double>::infinity();
  const auto left = right - 1;
  const double share = (x - (*left)[0]) / ((*right)[0] - (*left)[0]);
  return (*left)[1] + share * ((*right)[1] - (*left)[1]);
}

}  // namespace

// Depth, below the point aimed at, of the boundary between the first jet and a body of another
// liquid on the axis of the jet: the mean of the deepest water of the jet and the body's particle
// nearest to the nozzle, within a quarter of the jet's width of the axis.
Signal jet_tip_signal(const Parameters& parameters, const Beginning& beginning) {
  const std::size_t body = named_body(parameters, beginning);
  const std::size_t jet = beginning.description.bodies.size();
  const JetAxis axis(beginning.description.jets.at(0), beginning.description.dimension);
  return [body, jet, axis](Moment& moment) {
    const Frame& frame = moment.frame();
    double deepest = -axis.standoff, nearest = std::numeric_limits<double>::infinity();
    for (std::size_t row = 0; row < frame.id.size(); ++row) {
      if (axis.distance(frame.position[row]) > 0.25 * axis.width) continue;
      const double depth = axis.depth(frame.position[row]);
      if (frame.source[row] == jet) deepest = std::max(deepest, depth);
      if (frame.source[row] == body) nearest = std::min(nearest, depth);
    }
    return 0.5 * (deepest + std::min(nearest, std::max(deepest, 0.0) + axis.width));
  };
}

// Largest depth of water beneath the top of a body, in spacings of the body; negative above it. The
// top is the line through the particles that were its uppermost row, where they are now, and half a
// spacing above them. 2D only.
Signal deepest_water_signal(const Parameters& parameters, const Beginning& beginning) {
  if (beginning.description.dimension != 2) parameters.fail("the signal is one of 2D");
  const std::size_t body = named_body(parameters, beginning);
  const double spacing = beginning.description.bodies[body].spacing;
  const Frame& first = beginning.frame;
  double top = -std::numeric_limits<double>::infinity();
  for (std::size_t row = 0; row < first.id.size(); ++row)
    if (first.source[row] == body) top = std::max(top, first.position[row][1]);
  const auto uppermost = std::make_shared<std::vector<bool>>(first.id.size(), false);
  for (std::size_t row = 0; row < first.id.size(); ++row)
    if (first.source[row] == body && first.position[row][1] > top - 0.5 * spacing)
      (*uppermost)[first.id[row]] = true;
  return [uppermost, spacing](Moment& moment) {
    const Frame& frame = moment.frame();
    Line line;
    for (std::size_t row = 0; row < frame.id.size(); ++row)
      if (frame.id[row] < uppermost->size() && (*uppermost)[frame.id[row]])
        line.push_back({frame.position[row][0], frame.position[row][1] + 0.5 * spacing});
    std::sort(line.begin(), line.end());
    double deepest = -std::numeric_limits<double>::infinity();
    for (std::size_t row = 0; row < frame.id.size(); ++row)
      if (frame.category[row] == Category::water)
        deepest = std::max(
            deepest, (height_at(line, frame.position[row][0]) - frame.position[row][1]) / spacing);
    return deepest;
  };
}

}  // namespace kerf
