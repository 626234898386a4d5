// SPDX-License-Identifier: Apache-2.0
// Shapes of the type "mesh": keys, files, refusals, and the used case.
#include "model/mesh_shape.hpp"
#include "model/case.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/run_folder.hpp"
#include "core/error.hpp"
#include "geometry/fill.hpp"
#include "geometry/shapes.hpp"
#include "input/read.hpp"
#include "input/write_used.hpp"
#include "support/temporary_folder.hpp"
#include "support/triangle_meshes.hpp"

namespace kerf::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class MeshShapes : public testing::Test {
 protected:
  std::string text(const std::string& keys) const {
    return R"(title = "mesh"
dimension = 3
[time]
end = "1 ms"
[[body]]
name = "part"
material = "tofu"
spacing = "0.5 mm"
shape = { type = "mesh", )" +
           keys + " }\n";
  }
  Case read(const std::string& keys) const {
    write_file(folder_ / "case.toml", text(keys));
    return read_case(folder_ / "case.toml");
  }
  std::string refusal(const std::string& keys) const {
    return message_of<UserError>([&] { read(keys); });
  }
  TemporaryFolder folder_;
};

TEST_F(MeshShapes, TheFileIsRelativeToTheCase) {
  write_file(folder_ / "cube.stl", stl_binary(cube_mesh(4.0)));
  const Case millimetres = read("file = \"cube.stl\"");
  EXPECT_EQ(bounding_box(millimetres.bodies[0].shape, 3), (Box{{0, 0, 0}, {4e-3, 4e-3, 4e-3}}));
  EXPECT_EQ(fill(millimetres.bodies[0], 3).size(), 512u);
  EXPECT_NEAR(volume_estimate(millimetres.bodies[0].shape, 3), 64e-9, 1e-21);
  const Case placed = read(
      "file = \"cube.stl\", scale = \"0.5 mm\", position = [\"1 mm\", \"2 mm\", \"3 mm\"], "
      "rotation = [\"-90 deg\", \"0 deg\", \"0 deg\"]");
  const Box box = bounding_box(placed.bodies[0].shape, 3);
  const Point low{1e-3, 2e-3, 1e-3}, high{3e-3, 4e-3, 3e-3};
  for (std::size_t a = 0; a < 3; ++a) {
    EXPECT_NEAR(box.minimum[a], low[a], 1e-18);
    EXPECT_NEAR(box.maximum[a], high[a], 1e-18);
  }
}

// Finer particles fill the volume of a sphere better.
TEST_F(MeshShapes, ParticlesFillTheVolume) {
  write_file(folder_ / "ball.stl", stl_text(sphere_mesh(4.0, 4)));
  Body ball = read("file = \"ball.stl\"").bodies[0];
  const double volume = volume_estimate(ball.shape, 3);
  for (const double spacing : {0.5e-3, 0.25e-3, 0.125e-3}) {
    ball.spacing = spacing;
    const double filled = static_cast<double>(fill(ball, 3).size()) * particle_volume(ball, 3);
    // The error for the points of a lattice in a sphere is of second order in spacing over radius.
    EXPECT_NEAR(filled / volume, 1.0, 2.0 * std::pow(spacing / 4e-3, 2)) << spacing;
  }
}

TEST_F(MeshShapes, TheUsedCaseFindsTheCopy) {
  write_file(folder_ / "ring.obj", obj_text(torus_mesh(3.0, 1.0, 16)));
  const Case original = read("file = \"ring.obj\", rotation = [\"0.3 rad\", \"0 deg\", \"1 deg\"]");
  const std::filesystem::path run = folder_ / "run";
  make_folder(run);
  const std::string used = write_used(original);
  write_file(run / "case.used.toml", used);
  keep_meshes(original, run);
  const Case again = read_case(run / "case.used.toml");
  EXPECT_EQ(again, original);
  EXPECT_EQ(write_used(again), used);
  EXPECT_EQ(fill(again.bodies[0], 3), fill(original.bodies[0], 3));
  const std::string name = kept_mesh_name(original.bodies[0].shape.mesh);
  EXPECT_EQ(read_file(run / name), read_file(folder_ / "ring.obj"));
  EXPECT_TRUE(is_kept_mesh_name(name)) << name;
  EXPECT_FALSE(is_kept_mesh_name("mesh-of-mine.stl"));
  // Another mesh under the old name is refused.
  write_file(run / name, obj_text(torus_mesh(3.0, 1.0, 17)));
  EXPECT_THAT(message_of<UserError>([&] { read_case(run / "case.used.toml"); }),
              AllOf(HasSubstr("shape.checksum = "), HasSubstr("that of the file is ")));
}

// A checkpoint compares the text of the used case.
TEST_F(MeshShapes, AChangedFileIsAnotherCase) {
  write_file(folder_ / "part.stl", stl_binary(cube_mesh(4.0)));
  const std::string before = write_used(read("file = \"part.stl\""));
  write_file(folder_ / "part.stl", stl_binary(cube_mesh(4.01)));
  EXPECT_NE(write_used(read("file = \"part.stl\"")), before);
}

TEST_F(MeshShapes, AForcedRunClearsTheCopies) {
  write_file(folder_ / "part.stl", stl_binary(cube_mesh(4.0)));
  const Case description = read("file = \"part.stl\"");
  const std::filesystem::path run = folder_ / "run";
  make_folder(run);
  write_file(run / "case.used.toml", write_used(description));
  keep_meshes(description, run);
  write_file(run / "mesh-of-mine.stl", "mine");
  const RunFolder cleared(run, write_used(description), Existing::replace);
  EXPECT_FALSE(std::filesystem::exists(run / kept_mesh_name(description.bodies[0].shape.mesh)));
  EXPECT_TRUE(std::filesystem::exists(run / "mesh-of-mine.stl"));
}

TEST_F(MeshShapes, InvalidMeshesAreRefused) {
  TriangleMesh open = cube_mesh(4.0);
  open.triangles.pop_back();
  write_file(folder_ / "open.stl", stl_binary(open));
  write_file(folder_ / "text.stl", "this is no mesh");
  write_file(folder_ / "cube.step", "ISO-10303-21;");
  write_file(folder_ / "flat.stl",
             stl_text({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}}));
  EXPECT_THAT(refusal("file = \"open.stl\""),
              AllOf(HasSubstr("case.toml:9: body[1].shape.file = \"open.stl\": the surface is not "
                              "closed: 3 edges do not belong to two triangles"),
                    HasSubstr("Allowed: STL (binary or text) or OBJ files of a closed surface. "
                              "Repair the mesh")));
  EXPECT_THAT(refusal("file = \"text.stl\""), HasSubstr("it is not a valid stl file"));
  EXPECT_THAT(refusal("file = \"flat.stl\""), HasSubstr("the surface encloses no volume"));
  EXPECT_THAT(refusal("file = \"cube.step\""), HasSubstr("not that of a supported format"));
  EXPECT_THAT(refusal("file = \"none.stl\""), HasSubstr("there is no file"));
  EXPECT_THAT(refusal("file = \"/dev/zero.stl\""), HasSubstr("there is no file"));
  EXPECT_THAT(refusal("scale = \"1 mm\""), HasSubstr("the key is missing"));
  std::string plane = text("file = \"open.stl\"");
  plane.replace(plane.find("dimension = 3"), 13, "dimension = 2");
  EXPECT_THAT(message_of<UserError>([&] { parse_case(plane, "plane.toml"); }),
              HasSubstr("a mesh needs a 3D case"));
}

}  // namespace
}  // namespace kerf::test
