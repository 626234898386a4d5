// SPDX-License-Identifier: Apache-2.0
// A mesh from a file, with the real program: the result folder keeps a copy, which a resumed run
// uses.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "faults/program.hpp"
#include "support/temporary_folder.hpp"
#include "support/triangle_meshes.hpp"

namespace kerf::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const std::string case_text = R"(title = "A cube out of a file"
dimension = 3
[time]
end = "0.5 ms"
[[body]]
name = "part"
material = "tofu"
spacing = "1 mm"
velocity_expression = ["10*x", "0", "0"]
shape = { type = "mesh", file = "part.stl" }
)";

TEST(MeshOfARun, IsCopiedAndCompared) {
  const TemporaryFolder folder;
  write_file(folder / "case.toml", case_text);
  write_file(folder / "part.stl", stl_binary(cube_mesh(6.0)));
  const auto run = [&](const fs::path& file, const std::string& out,
                       const std::string& more = "--quiet") {
    return Program({"run", file.string(), "--out", (folder / out).string(), more},
                   folder / "output.txt")
        .wait();
  };
  ASSERT_EQ(run(folder / "case.toml", "a").exit_code, 0);
  ASSERT_EQ(run(folder / "a/case.used.toml", "b").exit_code, 0);
  EXPECT_EQ(read_file(folder / "a/case.used.toml"), read_file(folder / "b/case.used.toml"));
  EXPECT_EQ(read_file(folder / "a/series.csv"), read_file(folder / "b/series.csv"));
  EXPECT_EQ(run(folder / "case.toml", "a", "--resume").exit_code, 0);
  // The same cube with another diagonal in one face is a different file.
  TriangleMesh other = cube_mesh(6.0);
  other.triangles[0] = {0, 2, 1};
  other.triangles[1] = {2, 3, 1};
  write_file(folder / "part.stl", stl_binary(other));
  const Ending refused = run(folder / "case.toml", "a", "--resume");
  EXPECT_EQ(refused.exit_code, exit_files);
  EXPECT_THAT(refused.output, HasSubstr("checkpoint.h5 belongs to another case"));
  EXPECT_EQ(run(folder / "case.toml", "a", "--force").exit_code, 0);
}

}  // namespace
}  // namespace kerf::test
