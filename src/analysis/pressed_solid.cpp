// SPDX-License-Identifier: Apache-2.0
#include "analysis/pressed_solid.hpp"

#include <algorithm>

#include "analysis/workpiece.hpp"
#include "geometry/shapes.hpp"
#include "model/case.hpp"

namespace kerf {
namespace {

bool is_within(const Box& box, const Point& x, int dimension) {
  for (std::size_t a = 0; a < static_cast<std::size_t>(dimension); ++a)
    if (x[a] < box.minimum[a] || x[a] > box.maximum[a]) return false;
  return true;
}

// Whether the shape holds the point and all points that are this deep, m, along the axes from it.
bool is_deep_inside(const Shape& shape, const Point& x, double deep, int dimension) {
  if (!contains(shape, x, dimension)) return false;
  for (std::size_t a = 0; a < static_cast<std::size_t>(dimension); ++a)
    for (const double way : {-deep, deep}) {
      Point beside = x;
      beside[a] += way;
      if (!contains(shape, beside, dimension)) return false;
    }
  return true;
}

bool moves(const Body& body) {
  const auto is_set = [](const std::string& text) { return !text.empty() && text != "0"; };
  return std::any_of(body.velocity.begin(), body.velocity.end(), is_set) ||
         std::any_of(body.displacement.begin(), body.displacement.end(), is_set);
}

}  // namespace

std::vector<RigidShape> resting_rigid_shapes(const Case& description) {
  std::vector<RigidShape> shapes;
  for (const Body& body : description.bodies)
    if (body.role == Role::rigid && !moves(body)) shapes.push_back({body.shape, body.spacing});
  return shapes;
}

double pressed_share(const Workpiece& workpiece, const Frame& frame,
                     const std::vector<std::uint32_t>& rows,
                     const std::vector<RigidShape>& bodies) {
  const std::size_t once = workpiece.position.size() / workpiece.images.count();
  double pressed = 0.0;
  for (const RigidShape& body : bodies) {
    const Box box = bounding_box(body.shape, workpiece.dimension);
    for (std::size_t slot = 0; slot < once; ++slot) {
      if (!is_intact(frame, rows[slot])) continue;
      const Point& x = frame.position[rows[slot]];
      const double deep = std::max(body.spacing, workpiece.size[slot]);
      if (is_within(box, x, workpiece.dimension) &&
          is_deep_inside(body.shape, x, deep, workpiece.dimension))
        pressed += workpiece.mass[slot];
    }
  }
  return workpiece.total_mass > 0.0 ? pressed * workpiece.images.count() / workpiece.total_mass
                                    : 0.0;
}

}  // namespace kerf
