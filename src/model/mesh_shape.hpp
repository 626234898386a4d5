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
  double scale = 0.0;    // m, what one unit of the file is
  Point position{};      // m, where the origin of the file comes to lie
  Point rotation{};      // rad, about x, then about y, then about z, before it is moved there
  std::shared_ptr<const std::string> content;    // the bytes of the file
  std::shared_ptr<const ClosedSurface> surface;  // placed, in m: follows from all the above

  // The same bytes in the same place are the same region, wherever the file lies.
  bool operator==(const MeshShape& other) const {
    return checksum == other.checksum && scale == other.scale && position == other.position &&
           rotation == other.rotation;
  }
};

// CRC-64 of the bytes of a file, 16 hexadecimal digits: a file that was changed has another one.
std::string mesh_checksum(const std::string& content);

// "stl" of "Part.STL".
std::string mesh_format(const std::string& file);

// What a result folder calls its copy of the file, and case.used.toml the file: a name that follows
// from the bytes.
std::string kept_mesh_name(const MeshShape& mesh);
bool is_kept_mesh_name(const std::string& name);

// Every mesh of the bodies of a case, once for each place that names it.
std::vector<const MeshShape*> meshes_of(const Case& description);

}  // namespace kerf
