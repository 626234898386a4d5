// SPDX-License-Identifier: Apache-2.0
// libFuzzer: whatever the bytes of a mesh, it is read or refused, and a mesh that was read answers
// where it is. The first byte of an input chooses the format, and whether the mesh is read alone or
// as part of a case, which takes 50 times as long. assimp leaks memory of damaged files.
#include "fuzz/fuzzed.hpp"
#include "geometry/closed_surface.hpp"
#include "input/read.hpp"
#include "model/case.hpp"
#include "support/temporary_folder.hpp"
#include "support/triangle_meshes.hpp"

namespace kerf::test {
namespace {

constexpr const char* case_text = R"(title = "A part"
dimension = 3
[time]
end = "1 ms"
[[body]]
name = "part"
material = "tofu"
spacing = "2 mm"
shape = {{ type = "mesh", file = "{}", scale = "1 mm" }}
)";

void ask(const ClosedSurface& surface) {
  Point middle{}, corner = surface.box().minimum;
  for (std::size_t a = 0; a < 3; ++a)
    middle[a] = 0.5 * (surface.box().minimum[a] + surface.box().maximum[a]);
  for (const Point& point : {middle, corner, Point{}}) {
    static_cast<void>(surface.contains(point));
    static_cast<void>(surface.feet(point, 1e-3));
  }
}

void read_in_case(const std::string& content, const TemporaryFolder& folder, const char* format) {
  const std::string file = std::string("part.") + format;
  put(folder / file, content);
  const std::string place = (folder / "case.toml").string();
  ask(*parse_case(fmt::format(case_text, file), place).bodies.at(0).shape.mesh.surface);
}

void read_alone(const std::string& content, const char* format) {
  try {
    TriangleMesh mesh = read_triangles(content, format);
    if (!find_opening(mesh).empty()) return;
    const ClosedSurface surface(std::move(mesh));
    if (surface.volume() > 0.0) ask(surface);
  } catch (const MeshError&) {
    return;
  }
}

}  // namespace
}  // namespace kerf::test

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  using namespace kerf::test;
  std::vector<std::string> inputs;
  for (const auto& mesh : {cube_mesh(3.0), sphere_mesh(2.0, 0)}) {
    for (const char alone : {0, 2}) {
      inputs.push_back(static_cast<char>(alone) + stl_binary(mesh));
      inputs.push_back(static_cast<char>(alone) + stl_text(mesh));
      inputs.push_back(static_cast<char>(alone + 1) + obj_text(mesh));
    }
  }
  put_first_inputs(*argc, *argv, inputs);
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace kerf::test;
  static const TemporaryFolder folder;
  if (size == 0) return 0;
  const char* format = data[0] % 2 == 0 ? "stl" : "obj";
  const std::string content = bytes_of(data + 1, size - 1);
  const bool is_alone = data[0] % 32 > 1;
  read_or_refuse("case.toml", [&] {
    return is_alone ? read_alone(content, format) : read_in_case(content, folder, format);
  });
  return 0;
}
