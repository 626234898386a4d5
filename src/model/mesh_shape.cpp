// SPDX-License-Identifier: Apache-2.0
#include "model/mesh_shape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/crc.hpp>
#include <filesystem>
#include <string_view>

#include "model/case.hpp"

namespace kerf {

namespace {

constexpr std::string_view kept_prefix = "mesh-";
constexpr std::size_t checksum_digits = 16;

void collect(const Shape& shape, std::vector<const MeshShape*>& meshes) {
  if (shape.kind == Shape::Kind::mesh) meshes.push_back(&shape.mesh);
  for (const Shape& part : shape.parts) collect(part, meshes);
}

}  // namespace

std::string mesh_checksum(const std::string& content) {
  // The polynomial of ECMA-182, as the XZ format has it.
  boost::crc_optimal<64, 0x42F0E1EBA9EA3693u, ~0ull, ~0ull, true, true> sum;
  sum.process_bytes(content.data(), content.size());
  return fmt::format("{:016x}", sum.checksum());
}

std::string mesh_format(const std::string& file) {
  std::string format = std::filesystem::path(file).extension().string();
  if (!format.empty()) format.erase(0, 1);
  std::transform(format.begin(), format.end(), format.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return format;
}

std::string kept_mesh_name(const MeshShape& mesh) {
  return fmt::format("{}{}.{}", kept_prefix, mesh.checksum, mesh_format(mesh.file));
}

bool is_kept_mesh_name(const std::string& name) {
  if (!name.starts_with(kept_prefix)) return false;
  const std::string rest = name.substr(kept_prefix.size());
  return rest.find_first_not_of("0123456789abcdef") == checksum_digits &&
         rest[checksum_digits] == '.' && rest.find('.', checksum_digits + 1) == std::string::npos;
}

std::vector<const MeshShape*> meshes_of(const Case& description) {
  std::vector<const MeshShape*> meshes;
  for (const Body& body : description.bodies) {
    collect(body.shape, meshes);
    if (body.grading.around) collect(*body.grading.around, meshes);
  }
  for (const Load& load : description.loads)
    if (load.region) collect(*load.region, meshes);
  return meshes;
}

}  // namespace kerf
