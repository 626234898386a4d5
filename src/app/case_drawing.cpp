// SPDX-License-Identifier: Apache-2.0
#include "app/case_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/shape_outline.hpp"
#include "geometry/jet_direction.hpp"
#include "geometry/shapes.hpp"
#include "model/case.hpp"
#include "output/readable.hpp"
#include "report/drawing.hpp"
#include "report/html.hpp"

namespace kerf {

namespace {

constexpr double width = 420.0;                       // pixels
constexpr double most_oblong = 4.0, most_high = 1.1;  // width over height, and height over width
constexpr double margin = 0.04;                       // share of the drawing around the domain
constexpr std::size_t most_bodies = 200;              // drawn

Point middle_of(const Box& box) {
  Point middle{};
  for (std::size_t a = 0; a < 3; ++a) middle[a] = 0.5 * (box.minimum[a] + box.maximum[a]);
  return middle;
}

Colour colour_of_body(const Body& body) {
  if (body.role == Role::rigid) return palette::plate;
  return body.role == Role::water ? palette::water : palette::solid;
}

class CasePicture {
 public:
  CasePicture(const Case& description, std::size_t across);
  CaseDrawing draw();

 private:
  double height() const { return plane_.scale * high_; }
  void add_domain();
  void add_body(const Body& body);
  void add_jet(const Jet& jet);
  void add_traverse(const Jet& jet, const Point& exit);
  void add_probes();
  void add_scale();
  void add_area(const SectionPart& part, Colour colour, std::string_view name);

  const Case& case_;
  double high_ = 0.0;  // m, of what is shown; plane_of() sets it
  SectionPlane plane_;
  Drawing drawing_;
};

// Returns the plane, its corner and scale, for a drawing of the domain or, where that is very
// oblong, of the part of it around the jet. Sets the height that is shown, m.
SectionPlane plane_of(const Case& description, std::size_t across, double& high) {
  const Box& domain = description.domain;
  SectionPlane plane;
  plane.dimension = description.dimension;
  plane.across = across;
  Point middle = middle_of(domain);
  plane.through = description.jets.empty() ? middle : description.jets.front().position;
  double wide = domain.maximum[across] - domain.minimum[across];
  high = domain.maximum[1] - domain.minimum[1];
  const auto shorten = [&](double& length, double most, std::size_t axis) {
    if (length <= most) return;
    middle[axis] = std::clamp(plane.through[axis], domain.minimum[axis] + 0.5 * most,
                              domain.maximum[axis] - 0.5 * most);
    length = most;
  };
  shorten(wide, most_oblong * high, across);
  shorten(high, most_high * wide, 1);
  wide *= 1.0 + 2.0 * margin;
  high += 2.0 * margin * wide;
  plane.scale = width / wide;
  plane.corner[across] = middle[across] - 0.5 * wide;
  plane.corner[1] = middle[1] + 0.5 * high;
  return plane;
}

CasePicture::CasePicture(const Case& description, std::size_t across)
    : case_(description),
      plane_(plane_of(description, across, high_)),
      drawing_(width, std::ceil(height()) + 30.0,
               fmt::format("Geometry of the case: {} and y", across == 0 ? "x" : "z")) {}

void CasePicture::add_area(const SectionPart& part, Colour colour, std::string_view name) {
  drawing_.add(fmt::format(
      "<path d=\"{}\" fill=\"{}\" fill-rule=\"evenodd\" {}><title>{}</title></path>", part.path,
      hex(colour), part.is_sampled ? "" : stroke(palette::ink, 0.5), html::escape(name)));
}

void CasePicture::add_domain() {
  const Box& domain = case_.domain;
  const double left = plane_.x(domain.minimum), right = plane_.x(domain.maximum),
               top = plane_.y(domain.maximum), bottom = plane_.y(domain.minimum);
  const std::string plain = stroke(palette::faint, 1.0, "6 5"),
                    mirror = stroke(palette::curves[0], 2.0, "12 4 2 4");
  const Faces& planes = case_.symmetry;
  const std::size_t a = plane_.across;
  drawing_.line(left, top, left, bottom, planes.minimum[a] ? mirror : plain);
  drawing_.line(right, top, right, bottom, planes.maximum[a] ? mirror : plain);
  drawing_.line(left, top, right, top, planes.maximum[1] ? mirror : plain);
  drawing_.line(left, bottom, right, bottom, planes.minimum[1] ? mirror : plain);
}

void CasePicture::add_body(const Body& body) {
  std::string name = body.name;
  if (body.material >= 0)
    name += fmt::format(" ({})", case_.materials[static_cast<std::size_t>(body.material)].name);
  const auto parts = section_of(body.shape, plane_);
  for (const SectionPart& part : parts) add_area(part, colour_of_body(body), name);
  const Box box = bounding_box(body.shape, case_.dimension);
  const double left = std::max(plane_.x(box.minimum), 0.0),
               right = std::min(plane_.x(box.maximum), width), top = plane_.y(box.maximum),
               bottom = std::min(plane_.y(box.minimum), height());
  constexpr double letter = 8.0, line = 18.0;  // pixels
  const bool has_room =
      right - left > letter * static_cast<double>(name.size()) && bottom - top > line;
  if (parts.empty() || !has_room) return;
  drawing_.text(0.5 * (left + right), std::max(top, 0.0) + line, html::escape(name), Anchor::middle,
                "stroke=\"#fff\" stroke-width=\"3\" paint-order=\"stroke\"");
}

// Draws the water between the nozzle and the workpiece, as the case describes it.
void CasePicture::add_jet(const Jet& jet) {
  const Point direction = jet_direction(jet);
  Point exit = jet.position;
  for (std::size_t a = 0; a < 3; ++a) exit[a] -= jet.standoff * direction[a];
  const double along_x = direction[plane_.across], along_y = -direction[1];
  const double length = std::hypot(along_x, along_y);
  if (!(length > 0.0)) return;
  const double c = along_x / length, s = along_y / length;
  Point beside{};  // at right angles to the water, in the plane of the drawing
  beside[plane_.across] = -s;
  beside[1] = -c;
  const double wide = width_along(jet, beside, case_.dimension);
  const double half = 0.5 * wide * plane_.scale, way = jet.standoff * length * plane_.scale;
  // Returns a rectangle along the jet, between two distances from its exit.
  const auto strip = [&](double from, double to, double half_width) {
    std::string path;
    for (const auto& [l, w] : {std::pair{from, -1.0}, {to, -1.0}, {to, 1.0}, {from, 1.0}})
      path += fmt::format("{}{:.2f} {:.2f}", path.empty() ? "M" : "L",
                          plane_.x(exit) + l * c - w * half_width * s,
                          plane_.y(exit) + l * s + w * half_width * c);
    return path + "z";
  };
  add_area({strip(0.0, way, half)}, palette::water, jet.name);
  add_area({strip(-4.0 * half - 6.0, 0.0, 1.6 * half + 3.0)}, palette::faint,
           jet.name + ": nozzle");
  drawing_.line(plane_.x(exit), plane_.y(exit), plane_.x(exit) + (way + 30.0) * c,
                plane_.y(exit) + (way + 30.0) * s, stroke(palette::ink, 1.0, "8 3 2 3"));
  add_traverse(jet, exit);
}

// Draws an arrow along the motion of the nozzle.
void CasePicture::add_traverse(const Jet& jet, const Point& exit) {
  const double speed = jet.traverse[plane_.across];
  if (speed == 0.0) return;
  constexpr double gap = 16.0, length = 44.0, head = 6.0;  // pixels
  const double sign = speed > 0.0 ? 1.0 : -1.0;
  const double begin = plane_.x(exit) + sign * gap, end = begin + sign * length, y = plane_.y(exit);
  drawing_.path(fmt::format("M{:.1f} {:.1f}H{:.1f}l{:.1f} -{}m0 {}l{:.1f} -{}", begin, y, end,
                            -sign * head, head, 2.0 * head, sign * head, head),
                stroke(palette::ink, 1.5));
}

void CasePicture::add_probes() {
  for (const Probe& probe : case_.probes)
    drawing_.add(
        fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\" fill=\"{}\" {}><title>{}"
                    "</title></circle>",
                    plane_.x(probe.position), plane_.y(probe.position), hex(palette::paper),
                    stroke(palette::ink, 1.5), html::escape(probe.name)));
}

void CasePicture::add_scale() {
  const double wide = width / plane_.scale, step = round_interval(wide, 5.0);
  const double y = std::ceil(height()) + 12.0, left = 10.0, right = left + step * plane_.scale;
  drawing_.add(fmt::format("<rect x=\"0\" y=\"{:.1f}\" width=\"{}\" height=\"30\" fill=\"{}\"/>",
                           std::ceil(height()), width, hex(palette::paper)));
  drawing_.path(fmt::format("M{0:.1f} {1:.1f}v8v-4H{2:.1f}v-4v8", left, y, right),
                stroke(palette::ink, 1.5));
  drawing_.text(right + 8.0, y + 9.0, readable(step, "m"), Anchor::left);
  if (case_.symmetry.any())
    drawing_.text(width - 8.0, y + 9.0, "dots and dashes: symmetry", Anchor::right,
                  fmt::format("fill-opacity=\"0.7\""));
}

CaseDrawing CasePicture::draw() {
  for (std::size_t n = 0; n < std::min(case_.bodies.size(), most_bodies); ++n)
    add_body(case_.bodies[n]);
  for (const Jet& jet : case_.jets) add_jet(jet);
  add_domain();
  add_probes();
  add_scale();
  const std::size_t normal = plane_.normal();
  const std::string title = case_.dimension == 2
                                ? "The plane of the case"
                                : fmt::format("Section at {} = {}", normal == 2 ? "z" : "x",
                                              readable(plane_.through[normal], "m"));
  return {title, drawing_.svg()};
}

}  // namespace

std::vector<CaseDrawing> draw_case(const Case& description) {
  std::vector<CaseDrawing> drawings{CasePicture(description, 0).draw()};
  if (description.dimension == 3) drawings.push_back(CasePicture(description, 2).draw());
  return drawings;
}

}  // namespace kerf
