// SPDX-License-Identifier: Apache-2.0
#include "analysis/kerf_shape.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "analysis/kerf_lag.hpp"
#include "analysis/kerf_width.hpp"

namespace kerf {
namespace {

SectionProbe make_probe(const KerfAxes& axes, const KerfPath& path, double spacing) {
  SectionProbe probe;
  const double width = axes.jet.width;
  probe.breadth = std::max(depth_breadth_fraction * width, 2.0 * spacing);
  probe.tube_low = std::min(path.begin[0], path.end[0]) - width / 2.0;
  probe.tube_high = std::max(path.begin[0], path.end[0]) + width / 2.0;
  probe.reach = width / 2.0;
  return probe;
}

// Returns the sections that the axis has passed; for a nozzle at rest, those beside it.
std::vector<KerfSection> passed_sections(const std::vector<KerfSection>& sections,
                                         const KerfPath& path, double bin) {
  std::vector<KerfSection> passed;
  for (const KerfSection& section : sections)
    if (section.thickness > 0.0 && section.position >= path.begin[1] - bin / 2.0 &&
        section.position <= path.end[1] + bin / 2.0)
      passed.push_back(section);
  return passed;
}

// Returns a point for each column (2D) or section (3D) of the map.
std::vector<ProfilePoint> find_course(const KerfMap& map,
                                      const std::vector<KerfSection>& sections) {
  std::vector<ProfilePoint> course;
  if (map.grid.dimension == 2) {
    for (std::size_t i = 0; i < map.grid.count[0]; ++i)
      if (map.column(i, 0).exists) course.push_back({map.grid.at(0, i), map.column(i, 0).depth});
  } else {
    for (const KerfSection& section : sections)
      if (section.thickness > 0.0) course.push_back({section.position, section.depth});
  }
  return course;
}

std::vector<ProfilePoint> find_radial_course(const KerfMap& map) {
  std::vector<ProfilePoint> course;
  for (std::size_t i = 0; i < map.grid.count[0]; ++i)
    for (std::size_t j = 0; j < map.grid.count[1]; ++j)
      if (map.column(i, j).exists)
        course.push_back(
            {std::hypot(map.grid.at(0, i), map.grid.at(1, j)), map.column(i, j).depth});
  return course;
}

// Returns means over bins; one bin is centred at 0 or, for distances, begins at 0.
std::vector<ProfilePoint> bin_profile(const std::vector<ProfilePoint>& course, double bin,
                                      bool radial) {
  struct Sum {
    double position = 0.0, depth = 0.0, count = 0.0;
  };
  std::map<long, Sum> bins;
  for (const ProfilePoint& point : course) {
    Sum& sum = bins[std::lround(std::floor(point.position / bin + (radial ? 0.0 : 0.5)))];
    sum.position += point.position;
    sum.depth += point.depth;
    sum.count += 1.0;
  }
  std::vector<ProfilePoint> profile;
  for (const auto& [number, sum] : bins)
    profile.push_back({sum.position / sum.count, sum.depth / sum.count});
  return profile;
}

// Returns the path without its end on which solid is still being cut; all of it where there is
// nothing else.
KerfPath settled_part(const KerfPath& path) {
  KerfPath settled = path;
  const double along[] = {path.end[0] - path.begin[0], path.end[1] - path.begin[1]};
  const double length = std::hypot(along[0], along[1]);
  if (!(length > path.unsettled)) return settled;
  for (std::size_t a = 0; a < 2; ++a) settled.end[a] -= path.unsettled * along[a] / length;
  return settled;
}

// Returns the share of the path that is cut through, of that on which cutting has ended. In 2D the
// path lies in the section, across its columns.
double find_through_share(const KerfMap& map, const std::vector<KerfSection>& all_passed,
                          const KerfPath& way, double bin, double spacing) {
  const KerfPath path = settled_part(way);
  const std::vector<KerfSection> passed = passed_sections(all_passed, path, bin);
  double count = 0.0, through = 0.0;
  const auto add = [&](double depth, double thickness) {
    count += 1.0;
    through += depth >= thickness - spacing ? 1.0 : 0.0;
  };
  if (map.grid.dimension == 3) {
    for (const KerfSection& section : passed) add(section.depth, section.thickness);
  } else {
    const double low = std::min(path.begin[0], path.end[0]);
    const double high = std::max(path.begin[0], path.end[0]);
    for (std::size_t i = 0; i < map.grid.count[0]; ++i) {
      const double across = map.grid.at(0, i);
      if (const KerfColumn& column = map.column(i, 0);
          column.exists && across >= low && across <= high)
        add(column.depth, column.bottom - column.top);
    }
  }
  return count > 0.0 ? through / count : 0.0;
}

std::vector<double> profile_column(const KerfShape& shape, double ProfilePoint::*member) {
  std::vector<double> values;
  for (const ProfilePoint& point : shape.profile) values.push_back(point.*member);
  return values;
}

}  // namespace

const MetricList<KerfShape>& KerfShape::metrics() {
  using S = KerfShape;
  static const MetricList<S> list{
      {"thickness", "m", "thickness of the workpiece at the {}",
       "Median thickness of what is cut, along the jet.", &S::thickness},
      {"depth", "m", "depth of the {}", "Median depth of the {} below the face, along the jet.",
       &S::depth},
      {"through", "1", "{} reaches the far face",
       "Whether the depth of the {} is within one spacing of the thickness.", &S::through},
      {"through_share", share(), "share of the path on which the {} is through",
       "Share of the path of the axis since contact on which the {} reaches the far face, of the "
       "part on which cutting has ended.",
       &S::through_share},
      {"top.below", "m", "level of the top width of the {}",
       "Depth below the face at which the top width is measured.",
       [](const S& s) { return s.top.below; }},
      {"top.width", "m", "width of the {} at the top", "Width of the {} near the face.",
       [](const S& s) { return s.top.width; }},
      {"middle.below", "m", "level of the middle width of the {}",
       "Depth below the face at which the middle width is measured.",
       [](const S& s) { return s.middle.below; }},
      {"middle.width", "m", "width of the {} in the middle",
       "Width of the {} at half its depth; null where that is in a gap between layers, or where a "
       "crack "
       "parts the workpiece and nothing is removed.",
       [](const S& s) { return s.middle.width; }},
      {"bottom.below", "m", "level of the bottom width of the {}",
       "Depth below the face at which the bottom width is measured.",
       [](const S& s) { return s.bottom.below; }},
      {"bottom.width", "m", "width of the {} at the bottom",
       "Width of the {} near its deepest level.", [](const S& s) { return s.bottom.width; }},
      {"taper", "rad", "taper of the {}",
       "Angle of one face of the {} to the jet; positive where the {} is narrower below.",
       &S::taper},
      {"lag", "m", "lag of the {}",
       "Distance along the traverse by which the front of the {} at the bottom trails that at the "
       "top.",
       &S::lag},
      {"profile.position", "m", "positions of the profile of the {}",
       "Positions along the {}, or distances from the axis for a nozzle at rest in 3D.",
       [](const S& s) { return profile_column(s, &ProfilePoint::position); }},
      {"profile.depth", "m", "depths of the profile of the {}",
       "Depths of the {} at these positions.",
       [](const S& s) { return profile_column(s, &ProfilePoint::depth); }}};
  return list;
}

KerfShape measure_shape(const KerfMap& map, const KerfAxes& axes, const KerfPath& path,
                        double spacing) {
  KerfShape shape;
  const SectionProbe probe = make_probe(axes, path, spacing);
  const double bin = std::max(axes.jet.width / 4.0, 2.0 * spacing);
  std::vector<KerfSection> sections;
  // In 2D the path of a nozzle that travels lies in the section, whose thickness may vary along it.
  const bool is_path_across = map.grid.dimension == 2 && axes.moves();
  for (std::size_t j = 0; j < map.grid.count[1]; ++j) {
    KerfSection section = measure_section(map, j, probe);
    if (!is_path_across) section.depth = std::min(section.depth, section.thickness);
    sections.push_back(section);
  }
  const std::vector<KerfSection> passed = passed_sections(sections, path, bin);
  if (passed.empty()) return shape;
  std::vector<double> depths, thicknesses;
  for (const KerfSection& section : passed) {
    depths.push_back(section.depth);
    thicknesses.push_back(section.thickness);
  }
  shape.depth = median(depths);
  shape.thickness = median(thicknesses);
  shape.through = shape.depth >= shape.thickness - spacing;
  shape.through_share = axes.moves() ? find_through_share(map, passed, path, bin, spacing)
                                     : (shape.through ? 1.0 : 0.0);
  measure_widths(map, passed, probe, spacing, shape);
  const std::vector<ProfilePoint> course = find_course(map, sections);
  const bool radial = map.grid.dimension == 3 && !axes.moves();
  shape.profile = bin_profile(radial ? find_radial_course(map) : course, bin, radial);
  if (axes.moves()) shape.lag = measure_lag(map, axes, path, probe, shape);
  return shape;
}

}  // namespace kerf
