// SPDX-License-Identifier: Apache-2.0
// A region that a closed surface out of a file encloses.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "model/machine.hpp"

namespace kerf {

class ClosedSurface;
struct Case;

struct MeshShape {
  std::string file;      // as the case names it
  std::string checksum;  // of the bytes of the file, 16 hexadecimal digits
  double scale = 0.0;    // m per unit of the file
  Point position{};      // m, position of the origin of the file
  Point rotation{};      // rad, about x, then about y, then about z, before it is moved there
  std::shared_ptr<const std::string> content;    // the bytes of the file
  std::shared_ptr<const ClosedSurface> surface;  // m, as placed; derived from the other members

  // Two shapes are equal if the bytes of their files and their placements are, whatever the paths.
  bool operator==(const MeshShape& other) const {
    return checksum == other.checksum && scale == other.scale && position == other.position &&
           rotation == other.rotation;
  }
};

// Returns the CRC-64 of the bytes of a file, 16 hexadecimal digits, by which changes are detected.
std::string mesh_checksum(const std::string& content);

// Returns the format by the extension of the file name: "stl" for "Part.STL".
std::string mesh_format(const std::string& file);

// Returns the name of the copy of the file in a result folder, which case.used.toml refers to. It
// depends on the bytes of the file only.
std::string kept_mesh_name(const MeshShape& mesh);
bool is_kept_mesh_name(const std::string& name);

// Returns the meshes of the bodies of a case, one entry for each reference to a mesh.
std::vector<const MeshShape*> meshes_of(const Case& description);

}  // namespace kerf
