// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>

#include "geometry/closed_surface.hpp"
#include "input/draft.hpp"

namespace kerf {

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t largest_mesh = 256u << 20;  // bytes
constexpr const char* formats_allowed = "STL (binary or text) or OBJ files of a closed surface";

// Returns the bytes of the file, or records a problem.
std::shared_ptr<const std::string> load(Section& section, const fs::path& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) {
    section.refuse("file", fmt::format("there is no file {}", path.string()),
                   "Put it there, or correct the name", "a path relative to the case file");
    return nullptr;
  }
  const auto size = fs::file_size(path, error);
  if (error || size > largest_mesh) {
    section.refuse("file", fmt::format("the file is {} bytes long", size),
                   "Reduce the mesh: a few hundred thousand triangles suffice",
                   fmt::format("at most {} bytes", largest_mesh));
    return nullptr;
  }
  std::ifstream stream(path, std::ios::binary);
  auto content = std::make_shared<const std::string>(std::istreambuf_iterator<char>(stream),
                                                     std::istreambuf_iterator<char>());
  if (stream) return content;
  section.refuse("file", fmt::format("{} cannot be read", path.string()), "Check its permissions",
                 "a file that may be read");
  return nullptr;
}

void read_surface(Section& section, MeshShape& mesh) {
  try {
    TriangleMesh triangles = read_triangles(*mesh.content, mesh_format(mesh.file));
    const std::string opening = find_opening(triangles);
    if (!opening.empty())
      return section.refuse("file", opening,
                            "Repair the mesh in the program that made it, or with one that repairs "
                            "meshes for printing",
                            formats_allowed);
    place_mesh(triangles, mesh);
    auto surface = std::make_shared<const ClosedSurface>(std::move(triangles));
    if (!(surface->volume() > 0.0))
      return section.refuse("file", "the surface encloses no volume", "Name another mesh",
                            formats_allowed);
    mesh.surface = std::move(surface);
  } catch (const MeshError& error) {
    section.refuse("file", error.what(), "Write it again with the program that made it",
                   formats_allowed);
  }
}

}  // namespace

void read_mesh(Section& section, Shape& shape) {
  if (section.reading().dimension == 2)
    return section.refuse("type", "a mesh needs a 3D case", "Use a polygon", "\"polygon\" in 2D");
  MeshShape& mesh = shape.mesh;
  const std::string expected = mesh.checksum;
  if (mesh.file.empty()) return;
  const std::string format = mesh_format(mesh.file);
  if (format != "stl" && format != "obj")
    return section.refuse("file", "the extension of the file is not that of a supported format",
                          "Export the part as STL", formats_allowed);
  mesh.content = load(section, section.reading().folder / mesh.file);
  if (!mesh.content) return;
  mesh.checksum = mesh_checksum(*mesh.content);
  if (!expected.empty() && expected != mesh.checksum)
    return section.refuse("checksum", fmt::format("that of the file is {}", mesh.checksum),
                          "Restore the original file, or remove the key",
                          "the checksum of the file");
  read_surface(section, mesh);
}

}  // namespace kerf
