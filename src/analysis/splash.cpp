// SPDX-License-Identifier: Apache-2.0
#include "analysis/splash.hpp"

#include <algorithm>
#include <cmath>

namespace kerf {
namespace {

using Vector3 = KerfAxes::Vector3;

// The face of the workpiece around the axis as a plane, in local coordinates.
struct Face {
  bool exists = false;
  Vector3 point{};   // m
  Vector3 normal{};  // unit, out of the workpiece
};

// Returns the least-squares plane through the tops of the columns within a jet width of the axis.
Face fit_face(const KerfMap& map, const KerfAxes& axes, const Vector3& axis) {
  std::vector<Vector3> tops;
  for (std::size_t i = 0; i < map.grid.count[0]; ++i)
    for (std::size_t j = 0; j < map.grid.count[1]; ++j) {
      const double across = map.grid.at(0, i), along = map.grid.at(1, j);
      if (map.column(i, j).exists &&
          std::hypot(across - axis[0], along - axis[1]) <= axes.jet.width)
        tops.push_back({across, along, map.column(i, j).top});
    }
  Face face;
  if (tops.empty()) return face;
  face.exists = true;
  for (const Vector3& top : tops)
    for (std::size_t a = 0; a < 3; ++a) face.point[a] += top[a] / static_cast<double>(tops.size());
  double uu = 0.0, us = 0.0, ss = 0.0, uz = 0.0, sz = 0.0;
  for (const Vector3& top : tops) {
    const double u = top[0] - face.point[0], s = top[1] - face.point[1], z = top[2] - face.point[2];
    uu += u * u, us += u * s, ss += s * s, uz += u * z, sz += s * z;
  }
  const double determinant = uu * ss - us * us;
  double slope_u = uu > 0.0 ? uz / uu : 0.0, slope_s = 0.0;
  if (determinant > 1e-9 * uu * uu) {
    slope_u = (uz * ss - sz * us) / determinant;
    slope_s = (sz * uu - uz * us) / determinant;
  }
  const double length = std::sqrt(1.0 + slope_u * slope_u + slope_s * slope_s);
  face.normal = {slope_u / length, slope_s / length, -1.0 / length};
  return face;
}

// Whether a particle is in the space of a jet, where this is now, or within a spacing of it.
bool is_in_a_jet(const KerfView& view, std::size_t row) {
  return std::any_of(view.workpiece.jets.begin(), view.workpiece.jets.end(), [&](JetAxis jet) {
    jet.aim = jet.point_at(0.0, view.frame.time);
    return jet.distance(view.frame.position[row]) < jet.width / 2.0 + view.frame.spacing[row];
  });
}

}  // namespace

const MetricList<Splash>& Splash::metrics() {
  static const MetricList<Splash> list{
      {"splash.mass", extensive("kg"), "mass of the splash",
       "Mass of the jets' water that flies away from the face of the workpiece.", &Splash::mass},
      {"splash.angle", "rad", "angle of the splash",
       "Mass-weighted mean angle between the splash and the face; 0 is along the face.",
       &Splash::angle},
      {"splash.spread", "rad", "spread of the splash angle",
       "Mass-weighted standard deviation of the angle of the splash.", &Splash::spread}};
  return list;
}

Splash Splash::measure(const KerfScene& scene) {
  const auto& [view, map, axes, path, shape, fragments, conditions] = scene;
  Splash splash;
  const Frame& frame = view.frame;
  const Face face = fit_face(map, axes, path.end);
  if (!face.exists) return splash;
  double sum = 0.0, squares = 0.0;
  for (std::size_t row = 0; row < frame.position.size(); ++row) {
    if (!view.workpiece.is_jet_water(frame, row)) continue;
    const double spacing = frame.spacing[row];
    const Vector3 x = axes.local(frame.position[row]);
    const Vector3 from_face{x[0] - face.point[0], x[1] - face.point[1], x[2] - face.point[2]};
    if (KerfAxes::dot(from_face, face.normal) < spacing) continue;
    if (is_in_a_jet(view, row)) continue;
    const Vector3 velocity = axes.turned(frame.velocity[row]);
    const double speed = std::sqrt(KerfAxes::dot(velocity, velocity));
    const double away = KerfAxes::dot(velocity, face.normal);
    if (away <= 0.0 || speed < least_splash_speed * conditions.jet_speed) continue;
    const double mass = frame.mass[row], angle = std::asin(std::min(1.0, away / speed));
    splash.mass += mass;
    sum += mass * angle;
    squares += mass * angle * angle;
  }
  if (splash.mass <= 0.0) return splash;
  splash.angle = sum / splash.mass;
  splash.spread = std::sqrt(std::max(0.0, squares / splash.mass - splash.angle * splash.angle));
  return splash;
}

}  // namespace kerf
