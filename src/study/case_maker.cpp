// SPDX-License-Identifier: Apache-2.0
#include "study/case_maker.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/uuid.hpp>
#include <filesystem>
#include <limits>
#include <sstream>

#include "analysis/derived.hpp"
#include "core/error.hpp"
#include "input/read.hpp"
#include "input/refine.hpp"
#include "input/write_used.hpp"
#include "model/case.hpp"
#include "study/layout.hpp"

namespace kerf {

namespace {

double finest_spacing(const Case& description) {
  double finest = std::numeric_limits<double>::infinity();
  for (const Body& body : description.bodies) finest = std::min(finest, body.spacing);
  for (const Jet& jet : description.jets) finest = std::min(finest, jet.spacing);
  return finest;
}

// Removes line numbers from a message: they refer to text that no user wrote.
std::string without_place(const std::string& message, const std::string& file_name) {
  std::string result;
  std::istringstream lines(message);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(file_name + ":"))
      line = line.substr(std::min(line.find(": ", file_name.size()), line.size() - 2) + 2);
    result += "\n  " + line;
  }
  return result;
}

// Whether the key holds a number without unit, which words give beside "none".
bool is_plain_number(const Axis& axis) {
  return axis.path.is_number() && axis.path.unit().empty();
}

}  // namespace

UserError refused_case(const std::string& study_file, const std::string& setting,
                       const UserError& problems, const std::string& case_name) {
  return UserError(fmt::format("{}: with {} the case is not valid:{}", study_file, setting,
                               without_place(problems.what(), case_name)));
}

std::string text_id(const std::string& text) {
  constexpr std::size_t digits = 15;
  const boost::uuids::name_generator_sha1 generator(boost::uuids::ns::oid());
  std::string id;
  for (const unsigned char byte : generator(text)) id += fmt::format("{:02x}", byte);
  return id.substr(0, digits);
}

CaseMaker::CaseMaker(const StudyPlan& plan)
    : title_(plan.title),
      study_file_(plan.file),
      file_name_(
          (std::filesystem::path(plan.base_name).parent_path() / (plan.name + ".toml")).string()),
      base_(plan.base),
      axes_(plan.axes) {
  if (plan.threshold) axes_.push_back(plan.threshold->axis);
  if (!plan.calibration) return;
  axes_.push_back(plan.calibration->axis);
  for (const Axis& axis : plan.calibration->at_axes) axes_.push_back(axis);
}

// Returns the title of the pictures and the report of a run.
std::string CaseMaker::title_of(const Setting& setting) const {
  const std::string where = show(setting, axes_);
  return where.empty() ? title_ : fmt::format("{}: {}", title_, where);
}

ResolvedCase CaseMaker::make(const Trial& trial) const {
  toml::table table = base_;
  for (const Axis& axis : axes_) {
    const auto number = trial.setting.numbers.find(axis.name());
    const auto word = trial.setting.words.find(axis.name());
    if (number != trial.setting.numbers.end())
      set_number(table, axis.path, axis.of_case(number->second));
    if (word == trial.setting.words.end()) continue;
    if (is_plain_number(axis) && word->second != "none")
      set_number(table, axis.path, std::stod(word->second));
    else
      set_key(table, axis.path, toml::value<std::string>(word->second));
  }
  std::ostringstream written;
  written << table;
  try {
    Case description = refined(parse_case(written.str(), file_name_), trial.refinement);
    change_layout(description, trial.repeat);
    ResolvedCase result;
    result.id = text_id(write_used(description));  // under the title of the base
    description.title = title_of(trial.setting);
    result.text = write_used(description);
    result.spacing = finest_spacing(description);
    result.memory = derive(description).memory;
    for (const MeshShape* mesh : meshes_of(description))
      result.meshes[kept_mesh_name(*mesh)] = mesh->content;
    return result;
  } catch (const UserError& error) {
    throw refused_case(study_file_, show(trial.setting, axes_), error, file_name_);
  }
}

}  // namespace kerf
