// SPDX-License-Identifier: Apache-2.0
// These signals are sums over the particles of a "body", or of the water of a "jet", that are in a
// region at the time, such as a section of a stream. The region is where the formula "within" of x,
// y, z in m is not 0.
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <memory>

#include "model/case.hpp"
#include "model/expression.hpp"
#include "verification/signal.hpp"

namespace kerf {

namespace {

std::size_t named_jet(const Parameters& parameters, const Beginning& beginning) {
  const std::string name = parameters.text("jet");
  const auto& jets = beginning.description.jets;
  for (std::size_t j = 0; j < jets.size(); ++j)
    if (jets[j].name == name) return beginning.description.bodies.size() + j;
  parameters.fail(fmt::format("there is no jet \"{}\"", name));
}

struct Region {
  Region(const Parameters& parameters, const Beginning& beginning)
      : source(parameters.has("jet") ? named_jet(parameters, beginning)
                                     : named_body(parameters, beginning)),
        within(parameters.text("within"), {"x", "y", "z"}) {}

  bool has(const Frame& frame, std::size_t row) const {
    return frame.source[row] == source && within(frame.position[row]) != 0.0;
  }

  // Returns the index of its material; -1 for a rigid body.
  int material(const Case& description) const {
    const auto& bodies = description.bodies;
    return source < bodies.size() ? bodies[source].material
                                  : description.jets[source - bodies.size()].material;
  }

  std::size_t source;  // as in Frame
  Expression within;
};

}  // namespace

// Volume at the reference density (2D: area) of the body's particles in the region, over the number
// `over`: with the length of a section of a stream, the stream's width. It uses the mass, because a
// particle at a surface has a lower density.
Signal region_volume_signal(const Parameters& parameters, const Beginning& beginning) {
  const auto region = std::make_shared<const Region>(parameters, beginning);
  const int material = region->material(beginning.description);
  if (material < 0) parameters.fail("a rigid body has no density");
  const double density =
      beginning.description.materials[static_cast<std::size_t>(material)].density;
  const double over = density * parameters.number("over", "", 1.0);
  return [region, over](Moment& moment) {
    const Frame& frame = moment.frame();
    double mass = 0.0;
    for (std::size_t row = 0; row < frame.id.size(); ++row)
      if (region->has(frame, row)) mass += frame.mass[row];
    return mass / over;
  };
}

// Mass-weighted mean velocity of the body's particles in the region along the axis `axis`; 0 while
// there is none.
Signal region_velocity_signal(const Parameters& parameters, const Beginning& beginning) {
  const auto region = std::make_shared<const Region>(parameters, beginning);
  const std::size_t axis = named_axis(parameters);
  return [region, axis](Moment& moment) {
    const Frame& frame = moment.frame();
    double momentum = 0.0, mass = 0.0;
    for (std::size_t row = 0; row < frame.id.size(); ++row) {
      if (!region->has(frame, row)) continue;
      mass += frame.mass[row];
      momentum += double(frame.mass[row]) * frame.velocity[row][axis];
    }
    return mass > 0.0 ? momentum / mass : 0.0;
  };
}

// How far the body's particles in the region reach along the axis `axis`, m: the greatest
// coordinate, and half a spacing; minus infinity while there is none.
Signal reach_signal(const Parameters& parameters, const Beginning& beginning) {
  const auto region = std::make_shared<const Region>(parameters, beginning);
  const std::size_t axis = named_axis(parameters);
  return [region, axis](Moment& moment) {
    const Frame& frame = moment.frame();
    double reach = -std::numeric_limits<double>::infinity();
    for (std::size_t row = 0; row < frame.id.size(); ++row)
      if (region->has(frame, row))
        reach = std::max(reach, frame.position[row][axis] + 0.5 * double(frame.spacing[row]));
    return reach;
  };
}

}  // namespace kerf
