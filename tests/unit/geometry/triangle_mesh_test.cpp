// SPDX-License-Identifier: Apache-2.0
// Meshes from files, valid and damaged.
#include "geometry/triangle_mesh.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "support/triangle_meshes.hpp"

namespace kerf::test {
namespace {

using testing::HasSubstr;

struct Format {
  const char* name;
  const char* extension;
  std::string (*write)(const TriangleMesh&);
};
constexpr Format formats[] = {
    {"binary STL", "stl", stl_binary}, {"text STL", "stl", stl_text}, {"OBJ", "obj", obj_text}};

std::string refusal(const std::string& content, const std::string& format) {
  try {
    read_triangles(content, format);
  } catch (const MeshError& error) {
    return error.what();
  }
  return "(read)";
}

TEST(TriangleMesh, EveryFormatGivesTheSameMesh) {
  const TriangleMesh torus = torus_mesh(3.0, 1.0, 12);
  for (const Format& format : formats) {
    const TriangleMesh read = read_triangles(format.write(torus), format.extension);
    EXPECT_EQ(read.triangles.size(), torus.triangles.size()) << format.name;
    EXPECT_EQ(read.corners.size(), torus.corners.size()) << format.name;
    EXPECT_EQ(find_opening(read), "") << format.name;
  }
}

// 0.3 is 0.300000012 in single precision; the file has 0.3.
TEST(TriangleMesh, CoordinatesAreThoseOfTheFile) {
  for (const Format& format : formats) {
    const TriangleMesh read = read_triangles(format.write(cube_mesh(0.3)), format.extension);
    for (const Point& corner : read.corners)
      for (const double x : corner) EXPECT_TRUE(x == 0.0 || x == 0.3) << format.name << ' ' << x;
  }
}

TEST(TriangleMesh, TrianglesWithoutAreaAreSkipped) {
  TriangleMesh cube = cube_mesh(1.0);
  cube.triangles.push_back({3, 3, 5});
  const TriangleMesh read = read_triangles(stl_text(cube), "stl");
  EXPECT_EQ(read.triangles.size(), 12u);
  EXPECT_EQ(find_opening(read), "");
}

TEST(TriangleMesh, OpenEdgesAreFound) {
  TriangleMesh lacking = cube_mesh(1.0);
  lacking.triangles.pop_back();
  EXPECT_THAT(find_opening(lacking), HasSubstr("3 edges do not belong to two triangles"));
  TriangleMesh doubled = cube_mesh(1.0);
  doubled.triangles.push_back(doubled.triangles.front());
  EXPECT_THAT(find_opening(doubled), HasSubstr("3 edges do not belong to two triangles"));
  TriangleMesh turned = cube_mesh(1.0);
  std::swap(turned.triangles[0][0], turned.triangles[0][1]);
  EXPECT_THAT(find_opening(turned), HasSubstr("3 pairs of neighbouring triangles"));
}

TEST(TriangleMesh, InvalidFilesAreRefused) {
  EXPECT_NE(refusal("", "stl"), "(read)");
  EXPECT_NE(refusal("solid\nendsolid\n", "stl"), "(read)");
  EXPECT_NE(refusal("\x89PNG\r\n\x1a\n and so on and on and on", "stl"), "(read)");
  EXPECT_NE(refusal("v 0 0 0\nv 1 0 0\nv 0 1 0\n", "obj"), "(read)");
  // The format of a valid file with another extension is not guessed.
  EXPECT_NE(refusal(obj_text(cube_mesh(1.0)), "stl"), "(read)");
  const TriangleMesh endless{{{0, 0, 0}, {1, 0, 0}, {0, HUGE_VAL, 0}}, {{0, 1, 2}}};
  EXPECT_NE(refusal(stl_binary(endless), "stl"), "(read)");
}

// Truncated files and files with random changes are either read or refused.
TEST(TriangleMesh, DamagedFilesAreHandled) {
  std::mt19937 random(5);
  for (const Format& format : formats) {
    const std::string whole = format.write(sphere_mesh(1.0, 1));
    int refused = 0;
    for (int n = 0; n < 1000; ++n) {
      std::string spoilt = whole.substr(0, n % 2 == 0 ? random() % whole.size() : whole.size());
      for (unsigned k = 0; k < n % 2 * (1 + random() % 8); ++k)
        spoilt[random() % spoilt.size()] = static_cast<char>(random());
      try {
        refused += find_opening(read_triangles(spoilt, format.extension)).empty() ? 0 : 1;
      } catch (const MeshError&) {
        ++refused;
      }
    }
    // Changes of a normal, of the header or of a last digit do not open a surface.
    EXPECT_GT(refused, 500) << format.name;
  }
}

}  // namespace
}  // namespace kerf::test
