// SPDX-License-Identifier: Apache-2.0
// Signals of water on other matter: how far a jet has come into another liquid, and whether water
// leaks into a solid.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "analysis/jet_axis.hpp"
#include "model/case.hpp"
#include "verification/signal.hpp"

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

// The share of the flow of the first jet in the direction of its inclination (+x): mass times speed
// along x of its water between `beyond` and `beyond` + `band` from the point aimed at, which moves
// away from it on that side, over the sum of both sides; 1/2 before there is any.
Signal forward_share_signal(const Parameters& parameters, const Beginning& beginning) {
  const auto source = static_cast<std::uint16_t>(beginning.description.bodies.size());
  const double x = beginning.description.jets.at(0).position[0];
  const double beyond = parameters.number("beyond", "m");
  const double band = parameters.number("band", "m");
  return [source, x, beyond, band](Moment& moment) {
    const Frame& frame = moment.frame();
    double forwards = 0.0, backwards = 0.0;
    for (std::size_t row = 0; row < frame.id.size(); ++row) {
      const double offset = frame.position[row][0] - x;
      const double distance = std::abs(offset);
      if (frame.source[row] != source || distance < beyond || distance > beyond + band) continue;
      const double flow = double(frame.mass[row]) * frame.velocity[row][0];  // the jet comes in
      if (offset > 0.0 && flow > 0.0) forwards += flow;
      if (offset < 0.0 && flow < 0.0) backwards -= flow;
    }
    const double sum = forwards + backwards;
    return sum > 0.0 ? forwards / sum : 0.5;
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
