// SPDX-License-Identifier: Apache-2.0
#include "geometry/triangle_mesh.hpp"

#include <assimp/BaseImporter.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <charconv>
#include <cmath>
#include <exception>
#include <map>
#include <memory>

namespace kerf {

namespace {

// Registers the reader of one format only, so that the library does not guess another one. Other
// formats are not supported, because some readers of the library (that of PLY) do not terminate on
// truncated files.
void keep_only(Assimp::Importer& importer, const std::string& format) {
  const std::size_t wanted = importer.GetImporterIndex(format.c_str());
  if (wanted >= importer.GetImporterCount()) throw MeshError("that format is not supported");
  const Assimp::BaseImporter* kept = importer.GetImporter(wanted);
  for (std::size_t i = importer.GetImporterCount(); i-- > 0;) {
    std::unique_ptr<Assimp::BaseImporter> other(importer.GetImporter(i));
    if (other.get() == kept || importer.UnregisterLoader(other.get()) != aiReturn_SUCCESS)
      static_cast<void>(other.release());
  }
}

// Returns the shortest decimal number that rounds to this one in single precision: 0.3, not
// 0.300000012.
double decimal(float value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  double result = 0.0;
  std::from_chars(text.data(), end, result);
  return result + 0.0;  // turns -0 into 0, so that equal positions have equal bits
}

class Gatherer {
 public:
  void add(const aiMesh& part) {
    for (unsigned f = 0; f < part.mNumFaces; ++f) {
      const aiFace& face = part.mFaces[f];
      if (face.mNumIndices != 3) continue;  // single points and lines
      std::array<std::uint32_t, 3> triangle{};
      for (unsigned k = 0; k < 3; ++k) {
        if (face.mIndices[k] >= part.mNumVertices) throw MeshError("a triangle lacks a corner");
        triangle[k] = number_of(part.mVertices[face.mIndices[k]]);
      }
      if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0])
        mesh_.triangles.push_back(triangle);
    }
  }
  TriangleMesh take() { return std::move(mesh_); }

 private:
  std::uint32_t number_of(const aiVector3D& corner) {
    const Point position{decimal(corner.x), decimal(corner.y), decimal(corner.z)};
    if (!std::isfinite(corner.x) || !std::isfinite(corner.y) || !std::isfinite(corner.z))
      throw MeshError("a coordinate is not a finite number");
    const auto [entry, is_new] =
        number_.try_emplace(position, static_cast<std::uint32_t>(mesh_.corners.size()));
    if (is_new) mesh_.corners.push_back(position);
    return entry->second;
  }

  std::map<Point, std::uint32_t> number_;
  TriangleMesh mesh_;
};

struct Edge {
  std::uint32_t low = 0, high = 0;  // corners
  bool upward = false;              // whether its triangle has the direction low to high
  bool same_place(const Edge& other) const { return low == other.low && high == other.high; }
};

std::vector<Edge> sorted_edges(const TriangleMesh& mesh) {
  std::vector<Edge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (const auto& triangle : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = triangle[k], to = triangle[(k + 1) % 3];
      edges.push_back({std::min(from, to), std::max(from, to), from < to});
    }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return std::array{a.low, a.high, std::uint32_t{a.upward}} <
           std::array{b.low, b.high, std::uint32_t{b.upward}};
  });
  return edges;
}

std::string position_text(const Point& position) {
  return fmt::format("({}, {}, {})", position[0], position[1], position[2]);
}

}  // namespace

TriangleMesh read_triangles(const std::string& content, const std::string& format) {
  Assimp::Importer importer;
  keep_only(importer, format);
  try {
    const aiScene* scene = importer.ReadFileFromMemory(content.data(), content.size(),
                                                       aiProcess_Triangulate, format.c_str());
    if (!scene) throw MeshError(fmt::format("it is not a valid {} file", format));
    Gatherer gatherer;
    for (unsigned m = 0; m < scene->mNumMeshes; ++m) gatherer.add(*scene->mMeshes[m]);
    TriangleMesh mesh = gatherer.take();
    if (mesh.triangles.empty()) throw MeshError("it has no triangle");
    return mesh;
  } catch (const MeshError&) {
    throw;
  } catch (const std::exception& error) {
    throw MeshError(fmt::format("it is not a valid {} file ({})", format, error.what()));
  }
}

std::string find_opening(const TriangleMesh& mesh) {
  const std::vector<Edge> edges = sorted_edges(mesh);
  std::size_t open = 0, turned = 0;
  const Edge* example = nullptr;
  for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
    while (end < edges.size() && edges[end].same_place(edges[begin])) ++end;
    const bool pair = end - begin == 2;
    if (pair && edges[begin].upward != edges[begin + 1].upward) continue;
    if (!example || (!pair && open == 0)) example = &edges[begin];
    ++(pair ? turned : open);
  }
  if (!example) return {};
  const std::string where = fmt::format("for example that from {} to {}, in units of the file",
                                        position_text(mesh.corners[example->low]),
                                        position_text(mesh.corners[example->high]));
  if (open > 0)
    return fmt::format("the surface is not closed: {} edges do not belong to two triangles, {}",
                       open, where);
  return fmt::format("{} pairs of neighbouring triangles face opposite sides, {}", turned, where);
}

}  // namespace kerf
