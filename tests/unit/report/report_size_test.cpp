// SPDX-License-Identifier: Apache-2.0
// The report of a long run with many particles is small.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "output/files.hpp"
#include "output/vtkhdf.hpp"
#include "report/report.hpp"
#include "report/viewer_data.hpp"
#include "report/viewer_files.hpp"
#include "support/fake_run.hpp"
#include "support/temporary_folder.hpp"

namespace kerf {
namespace {

// Particles at random positions, which are compressed less well than real ones.
Frame crowd(std::size_t count, double time) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  Frame frame;
  frame.time = time;
  for (std::size_t i = 0; i < count; ++i) {
    frame.position.push_back({0.02 * share(generator) - 0.01, 0.01 * share(generator), 0.0});
    frame.velocity.push_back({share(generator), 0.0, 0.0});
    frame.id.push_back(static_cast<std::uint32_t>(i));
    frame.pressure.push_back(static_cast<float>(share(generator)));
  }
  frame.category.resize(count, Category::solid);
  frame.source.resize(count, 0);
  frame.spacing.resize(count, 1e-4f);
  frame.mass.resize(count, 1e-5f);
  frame.density.resize(count, 1000.0f);
  frame.upstream.resize(count, 0);
  return frame;
}

// The files of a run: its frames are one file at different times.
class ManyParticles : public testing::Test {
 protected:
  ManyParticles() {
    write_file(folder_ / "frame.vtkhdf", vtkhdf_bytes(crowd(particles, 0.0)));
    for (std::size_t n = 0; n < 60; ++n)
      files_.push_back({folder_ / "frame.vtkhdf", 1e-3 * static_cast<double>(n)});
  }
  static constexpr std::size_t particles = 20000;
  static std::size_t size_of(const nlohmann::ordered_json& frames) { return frames.dump().size(); }

  test::TemporaryFolder folder_;
  Case description_ = test::fake_case();
  std::vector<FrameFile> files_;
};

TEST_F(ManyParticles, AreAllShownWithinTheSizeLimit) {
  ViewerPacker packer(description_);
  packer.add_frames({files_.begin(), files_.begin() + 5});
  packer.fit(5'000'000);
  EXPECT_EQ(packer.share(), 1.0);
  EXPECT_EQ(viewer_frames(packer, 5'000'000).size(), 5u);
}

TEST_F(ManyParticles, FramesAreLeftOutFirst) {
  ViewerPacker packer(description_);
  packer.add_frames(files_);
  const std::size_t whole = packer.whole_entry(0).dump().size();
  packer.fit(10 * whole);
  EXPECT_EQ(packer.share(), 1.0);
  const auto frames = viewer_frames(packer, 10 * whole);
  EXPECT_LE(size_of(frames), 10 * whole);
  EXPECT_GE(frames.size(), 8u);
  EXPECT_EQ(frames.front().at("time"), 0.0);
  EXPECT_EQ(frames.back().at("time"), files_.back().time);
}

TEST_F(ManyParticles, ThenTheSameParticlesInEveryFrame) {
  ViewerPacker packer(description_);
  packer.add_frames(files_);
  const std::size_t budget = packer.whole_entry(0).dump().size();
  packer.fit(budget);
  const auto frames = viewer_frames(packer, budget);
  EXPECT_LE(size_of(frames), budget);
  EXPECT_GE(frames.size(), 8u);
  const auto kept = frames.front().at("count").get<double>();
  EXPECT_NEAR(kept / particles, packer.share(), 0.01);
  for (const auto& frame : frames) EXPECT_EQ(frame.at("data"), frames.front().at("data"));
  // The total area is constant: fewer particles, larger ones.
  const double spacing = packer.head().at("spacings").at(0).get<double>();
  EXPECT_NEAR(packer.share() * spacing * spacing, 1e-8, 1e-12);
}

TEST(ReportSize, StaysBelowTheLimit) {
  if (viewer_text("script").empty()) GTEST_SKIP() << "the viewer was not built";
  Case description = test::fake_case();
  const test::TemporaryFolder folder;
  test::run_fake(description, folder / "out");
  // Eight frames exceed the budget.
  const std::string frame = vtkhdf_bytes(crowd(300'000, 0.0));
  for (const FrameFile& file : frame_files(folder / "out")) write_file(file.path, frame);
  write_report(folder / "out", description);
  const std::string page = read_file(folder / "out/report.html");
  EXPECT_LT(page.size(), report_limit);
  EXPECT_GT(page.size(), report_limit / 2);
  EXPECT_THAT(page, testing::HasSubstr("of the particles, drawn larger"));
}

TEST(ThinFigures, KeepPeaksAndEnds) {
  constexpr std::size_t rows = 100'000, most = 1000;
  std::vector<double> time(rows), y(rows, 1.0), broken(rows, std::nan(""));
  for (std::size_t i = 0; i < rows; ++i) time[i] = 1e-6 * static_cast<double>(i);
  y[54'321] = 7.0;
  y[54'322] = -3.0;
  std::vector<ReportFigure> figures{{"a", {"a", "m"}, {{"a", y}, {"b", broken}}}};
  thin_figures(figures, time, most);
  ASSERT_EQ(time.size(), most);
  EXPECT_TRUE(std::is_sorted(time.begin(), time.end()));
  EXPECT_EQ(time.front(), 0.0);
  EXPECT_EQ(time.back(), 1e-6 * (rows - 1));
  const std::vector<double>& thinned = figures[0].curves[0].y;
  ASSERT_EQ(thinned.size(), most);
  const auto peak = std::find(thinned.begin(), thinned.end(), 7.0);
  ASSERT_NE(peak, thinned.end());
  EXPECT_EQ(*(peak + 1), -3.0);
  EXPECT_TRUE(std::isnan(figures[0].curves[1].y[3]));
}

TEST(ThinFigures, KeepShortCurves) {
  std::vector<double> time{0.0, 1.0, 2.0};
  std::vector<ReportFigure> figures{{"a", {"a", "m"}, {{"a", {3.0, 4.0, 5.0}}}}};
  thin_figures(figures, time, 3);
  EXPECT_EQ(time.size(), 3u);
  EXPECT_EQ(figures[0].curves[0].y, (std::vector<double>{3.0, 4.0, 5.0}));
}

}  // namespace
}  // namespace kerf
