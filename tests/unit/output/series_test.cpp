// SPDX-License-Identifier: Apache-2.0
#include "output/series.hpp"
#include "model/case.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "core/error.hpp"
#include "output/files.hpp"
#include "support/temporary_folder.hpp"

namespace kerf {
namespace {

using test::message_of;
using test::TemporaryFolder;
using testing::HasSubstr;

Case case_with_probes() {
  Case description;
  description.probes.push_back({Probe::Kind::point, "wall, left", {}, {0, 1, 0}});
  description.probes.push_back({Probe::Kind::plane, "floor", {}, {0, 1, 0}});
  return description;
}

SeriesSample sample_at(std::uint64_t step) {
  SeriesSample sample;
  sample.step = step;
  sample.time = 0.1 * static_cast<double>(step);
  sample.particles = 1000 + step;
  sample.last_step = {1.0 / 3.0, "acoustic (water), \"soft\"", 4};
  sample.balance.mass_out = 0.25;
  sample.balance.mass_erased = 0.5;
  sample.balance.momentum_now = {1.0, -2.0, 3.0};
  sample.cut.front_depth = 1e-3 / 7.0;
  sample.cut.pieces = 2;
  sample.probes = {1e5, 1, 2, 3, -10, -20, -30};
  return sample;
}

std::vector<std::string> header_words(const Case& description) {
  std::vector<std::string> words;
  for (const SeriesColumn& column : series_columns(description)) words.push_back(header_of(column));
  return words;
}

TEST(SeriesColumns, CarryTheirUnits) {
  Case description;
  const std::vector<std::string> flat = header_words(description);
  for (const char* name : {"time_s", "step", "dt_s", "limit", "front_depth_m", "cut_depth_m",
                           "fractured_mass_kg_per_m", "removed_mass_kg_per_m", "mass_in_kg_per_m",
                           "momentum_now_x_N_s_per_m", "kinetic_J_per_m", "force_rigid_y_N_per_m",
                           "energy_drift", "momentum_error", "mass_error", "pieces"})
    EXPECT_EQ(std::count(flat.begin(), flat.end(), name), 1) << name;
  description.dimension = 3;
  const std::vector<std::string> solid = header_words(description);
  for (const char* name :
       {"fractured_mass_kg", "momentum_now_z_N_s", "kinetic_J", "force_rigid_z_N"})
    EXPECT_EQ(std::count(solid.begin(), solid.end(), name), 1) << name;
}

TEST(SeriesColumns, HaveNamesOfTheirOwn) {
  const std::vector<std::string> words = header_words(case_with_probes());
  EXPECT_EQ(std::set<std::string>(words.begin(), words.end()).size(), words.size());
}

class SeriesFile : public testing::Test {
 protected:
  TemporaryFolder folder_;
  std::filesystem::path path_ = folder_ / "series.csv";
  Case description_ = case_with_probes();
};

TEST_F(SeriesFile, ReadsBackWhatWasWritten) {
  SeriesWriter writer(path_, description_);
  writer.start();
  for (const std::uint64_t step : {0u, 5u}) writer.append(sample_at(step));
  const SeriesTable table(path_, description_);
  EXPECT_EQ(table.rows(), 2u);
  EXPECT_EQ(table.numbers("time"), (std::vector<double>{0.0, 0.5}));
  EXPECT_EQ(table.numbers("dt"), (std::vector<double>{1.0 / 3.0, 1.0 / 3.0}));
  EXPECT_EQ(table.texts("limit")[1], "acoustic (water), \"soft\"");
  EXPECT_EQ(table.numbers("front_depth")[0], 1e-3 / 7.0);
  EXPECT_EQ(table.numbers("removed_mass")[0], 0.75);
  EXPECT_EQ(table.numbers("momentum_now_y")[0], -2.0);
  EXPECT_EQ(table.numbers("wall, left_pressure")[0], 1e5);
  EXPECT_EQ(table.numbers("wall, left_velocity_z")[0], 3.0);
  EXPECT_EQ(table.numbers("floor_force_x")[0], -10.0);
}

TEST_F(SeriesFile, TruncatedAndContinuedFileIsComplete) {
  SeriesWriter whole(path_, description_);
  whole.start();
  for (std::uint64_t step = 0; step < 10; ++step) whole.append(sample_at(step));
  const std::string expected = read_file(path_);

  // The run is killed after step 7, in the middle of a row; the checkpoint is of step 4.
  SeriesWriter killed(path_, description_);
  killed.start();
  for (std::uint64_t step = 0; step < 8; ++step) killed.append(sample_at(step));
  append_to_file(path_, "0.8,8,0.33");
  SeriesWriter resumed(path_, description_);
  resumed.cut_back(4, 5);
  EXPECT_EQ(resumed.rows(), 5u);
  for (std::uint64_t step = 5; step < 10; ++step) resumed.append(sample_at(step));
  EXPECT_EQ(read_file(path_), expected);
}

TEST_F(SeriesFile, RefusesForeignFiles) {
  SeriesWriter writer(path_, description_);
  writer.start();
  writer.append(sample_at(0));
  const auto refusal = [&](std::uint64_t step, std::size_t rows) {
    return message_of<UserError>([&] { SeriesWriter(path_, description_).cut_back(step, rows); });
  };
  EXPECT_THAT(refusal(0, 2), HasSubstr("holds 1 rows up to step 0 where the checkpoint has 2"));
  EXPECT_THAT(message_of<UserError>([&] { SeriesWriter(path_, Case{}).cut_back(0, 1); }),
              HasSubstr("its columns are not those of this run"));
  append_to_file(path_, "1,2,3\n");
  EXPECT_THAT(refusal(9, 2), HasSubstr("line 3 is damaged"));
  std::filesystem::remove(path_);
  EXPECT_THAT(refusal(0, 1), HasSubstr("cannot read " + path_.string()));
}

}  // namespace
}  // namespace kerf
