// SPDX-License-Identifier: Apache-2.0
// Triangles out of a file: STL (binary or text) or OBJ.
#pragma once

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "model/machine.hpp"

namespace kerf {

struct TriangleMesh {
  std::vector<Point> corners;  // each place once
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

// One sentence without its full stop: why the bytes are no mesh.
struct MeshError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Reads the bytes of a file of that format ("stl" or "obj"), in the units of the file.
// Coordinates are what the file says, to the seven digits that these formats hold. Corners at one
// place become one; triangles that have two of them are left out. Throws MeshError.
TriangleMesh read_triangles(const std::string& content, const std::string& format);

// Why the triangles do not enclose a volume: every edge must belong to two of them that go along it
// in opposite directions, as neighbours do that face the same side. Empty when they do.
std::string find_opening(const TriangleMesh& mesh);

}  // namespace kerf
