// SPDX-License-Identifier: Apache-2.0
// Triangle meshes from files: STL (binary or text) or OBJ.
#pragma once

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "model/machine.hpp"

namespace kerf {

struct TriangleMesh {
  std::vector<Point> corners;  // distinct positions
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

// The message is one sentence without its full stop, which states why the bytes are no mesh.
struct MeshError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Reads the bytes of a file of that format ("stl" or "obj"), in the units of the file.
// Coordinates are those of the file, to the seven digits that these formats hold. Corners at equal
// positions are merged; triangles with two equal corners are skipped. Throws MeshError.
TriangleMesh read_triangles(const std::string& content, const std::string& format);

// Returns why the triangles do not enclose a volume, or an empty text if they do: every edge must
// belong to two triangles that traverse it in opposite directions, as neighbours that face the same
// side do.
std::string find_opening(const TriangleMesh& mesh);

}  // namespace kerf
