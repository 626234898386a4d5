// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "output/hdf5.hpp"
#include "study/metrics.hpp"
#include "study/study_answers.hpp"
#include "study/study_table.hpp"

namespace kerf {

namespace {

void write_column(const hdf5::Handle& group, const std::string& name, std::string_view unit,
                  const std::vector<double>& values) {
  const hdf5::Handle array = hdf5::write(group, name, hdf5::block(values));
  hdf5::write_text_attribute(array, "unit", unit.empty() ? "1" : std::string(unit));
}

// Of a key that holds words: the place of each in the list, which is an attribute.
void write_words(const hdf5::Handle& group, const Axis& axis, const std::vector<RunRow>& runs) {
  std::vector<std::int64_t> places;
  for (const RunRow& row : runs) {
    const auto word = row.trial.setting.words.find(axis.name());
    const auto place = word == row.trial.setting.words.end()
                           ? axis.words.end()
                           : std::find(axis.words.begin(), axis.words.end(), word->second);
    places.push_back(place == axis.words.end() ? -1 : place - axis.words.begin());
  }
  const hdf5::Handle array = hdf5::write(group, axis.name(), hdf5::block(places));
  hdf5::write_text_attribute(array, "words", fmt::format("{}", fmt::join(axis.words, "\n")));
}

std::vector<double> numbers_of(const std::vector<RunRow>& runs, const std::string& key) {
  std::vector<double> values;
  for (const RunRow& row : runs) {
    const auto found = row.trial.setting.numbers.find(key);
    values.push_back(found == row.trial.setting.numbers.end() ? std::nan("") : found->second);
  }
  return values;
}

}  // namespace

std::string study_hdf5(const StudyPlan& plan, const std::vector<RunRow>& runs) {
  const hdf5::Handle file = hdf5::create();
  const hdf5::Handle table = hdf5::create_group(file, "runs");
  hdf5::write_text_attribute(table, "title", plan.title);
  std::vector<std::uint64_t> ids;
  std::vector<std::int64_t> states, repeats;
  std::vector<double> refinements, spacings;
  for (const RunRow& row : runs) {
    constexpr int hexadecimal = 16;
    ids.push_back(std::strtoull(row.id.c_str(), nullptr, hexadecimal));
    states.push_back(static_cast<std::int64_t>(row.state));
    repeats.push_back(row.trial.repeat);
    refinements.push_back(row.trial.refinement);
    spacings.push_back(row.spacing);
  }
  hdf5::write(table, "id", hdf5::block(ids));
  const hdf5::Handle state = hdf5::write(table, "state", hdf5::block(states));
  hdf5::write_text_attribute(state, "words", fmt::format("{}", fmt::join(run_state_words, "\n")));
  hdf5::write(table, "repeat", hdf5::block(repeats));
  write_column(table, "refinement", "", refinements);
  write_column(table, "spacing", "m", spacings);
  for (const Axis& axis : all_axes(plan)) {
    if (axis.words.empty())
      write_column(table, axis.name(), axis.path.unit(), numbers_of(runs, axis.name()));
    else
      write_words(table, axis, runs);
  }
  for (const std::string& name : shown_metrics(plan)) {
    std::vector<double> values;
    for (const RunRow& row : runs) {
      const auto found = row.metrics.find(name);
      values.push_back(found == row.metrics.end() ? std::nan("") : found->second);
    }
    write_column(table, name, metric_unit(name), values);
  }
  return hdf5::bytes_of(file);
}

}  // namespace kerf
