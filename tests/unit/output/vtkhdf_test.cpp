// SPDX-License-Identifier: Apache-2.0
// The oracle is VTK's own reader (Debian's python3-vtk9).
#include "output/vtkhdf.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "output/files.hpp"
#include "support/frames.hpp"
#include "support/temporary_folder.hpp"

namespace kerf {
namespace {

using nlohmann::json;

struct ClosePipe {
  void operator()(std::FILE* pipe) const { pclose(pipe); }
};

json read_with_vtk(const std::filesystem::path& path) {
  const std::string command = fmt::format("/usr/bin/python3 {}/tests/unit/output/read_vtkhdf.py {}",
                                          KERF_SOURCE_DIR, path.string());
  const std::unique_ptr<std::FILE, ClosePipe> pipe(popen(command.c_str(), "r"));
  std::string text;
  char buffer[4096];
  while (const std::size_t count = std::fread(buffer, 1, sizeof buffer, pipe.get()))
    text.append(buffer, count);
  const json content = json::parse(text, nullptr, false);
  if (content.is_discarded())
    throw std::runtime_error("VTK read nothing; is Debian's python3-vtk9 installed?");
  return content;
}

Frame three_particles() {
  Frame frame;
  frame.dimension = 2;
  frame.time = 0.0123;
  frame.step = 77;
  test::add_particle(frame, {-0.1, 1.0 / 3.0, 0.0}, Category::water, 1e-3);
  test::add_particle(frame, {0.2, -0.7, 0.25}, Category::fractured, 2e-3);
  test::add_particle(frame, {0.3, 0.1, -0.5}, Category::rigid, 2e-3);
  frame.upstream[0] = 1;
  frame.columns.push_back({"strain", "1", 1, {0.1f, 0.2f, 0.3f}});
  frame.columns.push_back({"deviatoric_stress", "Pa", 6, {}});
  for (int i = 0; i < 18; ++i) frame.columns.back().values.push_back(static_cast<float>(i) / 7.0f);
  return frame;
}

template <class T>
void expect_values(const json& array, const char* type, const std::vector<T>& values) {
  EXPECT_EQ(array.at("type"), type);
  EXPECT_EQ(array.at("values").get<std::vector<T>>(), values);
}

class VtkHdf : public testing::Test {
 protected:
  void SetUp() override {
    FrameWriter writer(folder_.path(), "case");
    writer.write(frame_);
    content_ = read_with_vtk(folder_ / "frames/case_00000.vtkhdf");
  }
  test::TemporaryFolder folder_;
  Frame frame_ = three_particles();
  json content_;
};

TEST_F(VtkHdf, HasOneVertexPerParticleInDoublePrecision) {
  EXPECT_EQ(content_.at("class"), "vtkUnstructuredGrid");
  EXPECT_EQ(content_.at("points_type"), "double");
  EXPECT_EQ(content_.at("points"), json(frame_.position));
  EXPECT_EQ(content_.at("cell_types"), json({1, 1, 1}));
  EXPECT_EQ(content_.at("cell_points"), json({0, 1, 2}));
  EXPECT_EQ(content_.at("bounds"), json({-0.1, 0.3, -0.7, 1.0 / 3.0, -0.5, 0.25}));
}

TEST_F(VtkHdf, HasEveryFieldOfTheFrame) {
  const json& arrays = content_.at("arrays");
  EXPECT_EQ(arrays.size(), 11u);
  expect_values(arrays.at("id"), "unsigned int", frame_.id);
  expect_values(arrays.at("source"), "unsigned short", frame_.source);
  expect_values(arrays.at("spacing"), "float", frame_.spacing);
  expect_values(arrays.at("mass"), "float", frame_.mass);
  expect_values(arrays.at("density"), "float", frame_.density);
  expect_values(arrays.at("pressure"), "float", frame_.pressure);
  expect_values(arrays.at("upstream"), "unsigned char", frame_.upstream);
  expect_values(arrays.at("category"), "unsigned char", std::vector<std::uint8_t>{0, 2, 3});
  expect_values(arrays.at("strain"), "float", frame_.columns[0].values);
  const json& velocity = arrays.at("velocity").at("values");
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_EQ(velocity[i][k].get<float>(), static_cast<float>(frame_.velocity[i][k]));
}

TEST_F(VtkHdf, KeepsTheComponentsOfAColumnTogether) {
  const json& stress = content_.at("arrays").at("deviatoric_stress").at("values");
  ASSERT_EQ(stress.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 6; ++k)
      EXPECT_EQ(stress[i][k].get<float>(), frame_.columns[1].values[6 * i + k]);
}

TEST_F(VtkHdf, HasItsTime) {
  EXPECT_EQ(content_.at("time").get<double>(), frame_.time);
}

TEST_F(VtkHdf, EqualFramesGiveEqualBytes) {
  EXPECT_EQ(vtkhdf_bytes(frame_), read_file(folder_ / "frames/case_00000.vtkhdf"));
}

TEST(VtkHdfSeries, ListsFramesAndTimesAlsoAfterARestore) {
  const test::TemporaryFolder folder;
  Frame frame = three_particles();
  FrameWriter writer(folder.path(), "case");
  writer.write(frame);
  frame.time = 0.5;
  writer.write(frame);
  FrameWriter resumed(folder.path(), "case");
  resumed.restore({0.0123});
  frame.time = 0.6;
  resumed.write(frame);
  const json series = json::parse(read_file(folder / "case.vtkhdf.series"));
  EXPECT_EQ(series.at("file-series-version"), "1.0");
  ASSERT_EQ(series.at("files").size(), 2u);
  EXPECT_EQ(series["files"][0], json({{"name", "frames/case_00000.vtkhdf"}, {"time", 0.0123}}));
  EXPECT_EQ(series["files"][1], json({{"name", "frames/case_00001.vtkhdf"}, {"time", 0.6}}));
  EXPECT_EQ(read_with_vtk(folder / "frames/case_00001.vtkhdf").at("time"), 0.6);
}

TEST(VtkHdfSeries, AFrameWithoutParticlesIsAFile) {
  const test::TemporaryFolder folder;
  FrameWriter(folder.path(), "case").write(Frame{});
  EXPECT_GT(std::filesystem::file_size(folder / "frames/case_00000.vtkhdf"), 0u);
}

}  // namespace
}  // namespace kerf
