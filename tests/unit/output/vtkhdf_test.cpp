// SPDX-License-Identifier: Apache-2.0
// The oracle is VTK's own reader (Debian's python3-vtk9).
#include "output/vtkhdf.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "output/files.hpp"
#include "output/read_frame.hpp"
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
  frame.source = {0, 1, 2};
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
    FrameWriter writer(folder_.path(), "case", legend_);
    writer.write(frame_);
    content_ = read_with_vtk(folder_ / "frames/case_00000.vtkhdf");
  }
  test::TemporaryFolder folder_;
  Frame frame_ = three_particles();
  FrameLegend legend_{{"block", "plate", "jet"}, {"tofu", "water", "rigid"}, {0, 2, 1}, {}};
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
  EXPECT_EQ(arrays.size(), 15u);
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
  FrameLegend legend = legend_;
  for (std::size_t i = 1; i < 3; ++i) legend.start[frame_.id[i]] = frame_.position[i];
  EXPECT_EQ(vtkhdf_bytes(frame_, legend), read_file(folder_ / "frames/case_00000.vtkhdf"));
}

TEST_F(VtkHdf, NamesBodiesMaterialsAndUnits) {
  expect_values(content_.at("arrays").at("material"), "unsigned char",
                std::vector<std::uint8_t>{0, 2, 1});
  const json& texts = content_.at("texts");
  EXPECT_EQ(texts.at("body_names"), json(legend_.bodies));
  EXPECT_EQ(texts.at("material_names"), json(legend_.materials));
  EXPECT_THAT(texts.at("units").get<std::vector<std::string>>(),
              testing::IsSupersetOf({"velocity / m/s", "pressure / Pa", "stress / Pa",
                                     "displacement / m", "spacing / m"}));
}

TEST_F(VtkHdf, TheStressIsTheDeviatoricOneLessThePressure) {
  const json& stress = content_.at("arrays").at("stress").at("values");
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 6; ++k) {
      const float share = k < 3 ? frame_.pressure[i] : 0.0f;
      EXPECT_EQ(stress[i][k].get<float>(), frame_.columns[1].values[6 * i + k] - share);
    }
}

TEST_F(VtkHdf, ADerivedArrayIsNotReadBack) {
  const Frame read = read_frame(folder_ / "frames/case_00000.vtkhdf", 2);
  std::vector<std::string> names;
  for (const Column& column : read.columns) names.push_back(column.name);
  EXPECT_THAT(names, testing::UnorderedElementsAre("strain", "deviatoric_stress"));
}

// Water has no reference; a resumed run knows the first frame.
TEST_F(VtkHdf, DisplacementsCountFromTheFirstFrame) {
  Frame later = frame_;
  later.position[1][1] += 0.5;
  FrameWriter resumed(folder_.path(), "case");
  resumed.restore({frame_.time});
  resumed.write(later);
  const json arrays = read_with_vtk(folder_ / "frames/case_00001.vtkhdf").at("arrays");
  EXPECT_EQ(arrays.at("displacement").at("values")[1], json({0.0, 0.5, 0.0}));
  EXPECT_EQ(arrays.at("displacement").at("values")[2], json({0.0, 0.0, 0.0}));
  EXPECT_TRUE(arrays.at("displacement").at("values")[0][0].is_null());
  EXPECT_EQ(arrays.at("reference_position").at("values")[1], json(frame_.position[1]));
}

TEST(VtkHdfSize, IsPacked) {
  Frame frame;
  for (int i = 0; i < 20000; ++i)
    test::add_particle(frame, {1e-3 * i, 0.0, 0.0}, Category::solid, 1e-3);
  const std::size_t plain = 20000 * (24 + 8 + 8 + 12 + 1 + 4 + 2 + 4 * 4 + 1);
  EXPECT_LT(vtkhdf_bytes(frame).size(), plain / 2);
}

// A stub stands for ParaView: the script must run to its end and name what the run has.
TEST_F(VtkHdf, AScriptOpensTheRunColouredAndWithALegend) {
  const auto stub = folder_ / "stub/paraview";
  std::filesystem::create_directories(stub);
  write_file(stub / "__init__.py", "");
  write_file(stub / "simple.py",
             "from unittest.mock import MagicMock\n"
             "import os\n"
             "names = 'OpenDataFile GetActiveViewOrCreate Show ColorBy GetColorTransferFunction "
             "GetScalarBar GetAnimationScene ResetCamera Render'.split()\n"
             "globals().update({name: MagicMock() for name in names})\n"
             "def opened(path):\n"
             "    assert os.path.exists(path), path\n"
             "    return MagicMock()\n"
             "OpenDataFile.side_effect = opened\n"
             "def done(view):\n"
             "    assert ColorBy.call_args[0][1] == ('POINTS', 'category')\n"
             "    assert 'fractured' in GetColorTransferFunction.return_value.Annotations\n"
             "    print('rendered')\n"
             "Render.side_effect = done\n");
  const std::string command =
      fmt::format("cd / && PYTHONPATH={} /usr/bin/python3 {}", (folder_ / "stub").string(),
                  (folder_ / "case.paraview.py").string());
  const std::unique_ptr<std::FILE, ClosePipe> pipe(popen(command.c_str(), "r"));
  char said[64] = "";
  EXPECT_NE(std::fgets(said, sizeof said, pipe.get()), nullptr);
  EXPECT_STREQ(said, "rendered\n");
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
