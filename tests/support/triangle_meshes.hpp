// SPDX-License-Identifier: Apache-2.0
// Closed surfaces of known volume and the files that contain them.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <numbers>
#include <string>

#include "geometry/triangle_mesh.hpp"

namespace kerf::test {

// A cube with edges of `size` from `low`; its normals point outwards.
inline TriangleMesh cube_mesh(double size, Point low = {0.0, 0.0, 0.0}) {
  TriangleMesh mesh;
  for (int k = 0; k < 8; ++k)
    mesh.corners.push_back(
        {low[0] + size * (k & 1), low[1] + size * (k >> 1 & 1), low[2] + size * (k >> 2)});
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

// A torus about the z axis; `sides` quadrilaterals around either circle.
inline TriangleMesh torus_mesh(double radius, double tube, std::uint32_t sides) {
  TriangleMesh mesh;
  const double step = 2.0 * std::numbers::pi / sides;
  for (std::uint32_t i = 0; i < sides; ++i)
    for (std::uint32_t j = 0; j < sides; ++j) {
      const double r = radius + tube * std::cos(j * step);
      mesh.corners.push_back(
          {r * std::cos(i * step), r * std::sin(i * step), tube * std::sin(j * step)});
      const std::uint32_t across = (i + 1) % sides, up = (j + 1) % sides;
      const std::uint32_t a = i * sides + j, b = across * sides + j;
      const std::uint32_t c = across * sides + up, d = i * sides + up;
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    }
  return mesh;
}

// A sphere about the origin: an octahedron whose triangles are divided into four `splits` times.
inline TriangleMesh sphere_mesh(double radius, int splits) {
  TriangleMesh mesh;
  mesh.corners = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                    {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int n = 0; n < splits; ++n) {
    TriangleMesh finer;
    for (const auto& t : mesh.triangles) {
      const auto first = static_cast<std::uint32_t>(finer.corners.size());
      for (std::size_t k = 0; k < 3; ++k) finer.corners.push_back(mesh.corners[t[k]]);
      for (std::size_t k = 0; k < 3; ++k) {
        const Point &a = mesh.corners[t[k]], &b = mesh.corners[t[(k + 1) % 3]];
        const Point sum{a[0] + b[0], a[1] + b[1], a[2] + b[2]};
        const double length = std::hypot(sum[0], sum[1], sum[2]);
        finer.corners.push_back({sum[0] / length, sum[1] / length, sum[2] / length});
      }
      for (const std::array<std::uint32_t, 3>& child :
           {std::array<std::uint32_t, 3>{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}})
        finer.triangles.push_back({first + child[0], first + child[1], first + child[2]});
    }
    mesh = finer;
  }
  for (Point& corner : mesh.corners)
    for (double& x : corner) x *= radius;
  return mesh;
}

inline std::string stl_text(const TriangleMesh& mesh) {
  std::string text = "solid part\n";
  for (const auto& triangle : mesh.triangles) {
    text += "facet normal 0 0 0\n outer loop\n";
    for (const std::uint32_t corner : triangle) {
      const Point& x = mesh.corners[corner];
      text += fmt::format("  vertex {:.9g} {:.9g} {:.9g}\n", x[0], x[1], x[2]);
    }
    text += " endloop\nendfacet\n";
  }
  return text + "endsolid part\n";
}

inline std::string stl_binary(const TriangleMesh& mesh) {
  std::string bytes(80, ' ');
  const auto append = [&](const auto& value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    bytes.append(raw, sizeof value);
  };
  append(static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const auto& triangle : mesh.triangles) {
    for (int k = 0; k < 3; ++k) append(0.0f);
    for (const std::uint32_t corner : triangle)
      for (const double x : mesh.corners[corner]) append(static_cast<float>(x));
    append(std::uint16_t{0});
  }
  return bytes;
}

inline std::string obj_text(const TriangleMesh& mesh) {
  std::string text = "# part\n";
  for (const Point& x : mesh.corners)
    text += fmt::format("v {:.9g} {:.9g} {:.9g}\n", x[0], x[1], x[2]);
  for (const auto& t : mesh.triangles)
    text += fmt::format("f {} {} {}\n", t[0] + 1, t[1] + 1, t[2] + 1);
  return text;
}

}  // namespace kerf::test
