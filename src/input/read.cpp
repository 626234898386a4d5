// SPDX-License-Identifier: Apache-2.0
#include "input/read.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>

#include "core/error.hpp"
#include "input/draft.hpp"
#include "input/parse_toml.hpp"
#include "model/case.hpp"

namespace kerf {

namespace {

constexpr std::uintmax_t largest_file = 64u << 20;  // bytes

// Refuses a file that describes a study of a case.
void refuse_study(Reading& reading, const toml::table& table, std::string_view file_name) {
  if (table.contains("dimension")) return;
  for (const char* key : {"vary", "search", "calibrate", "base"})
    if (const toml::node* node = table.get(key)) {
      reading.problems.mention(key, static_cast<int>(node->source().begin.line), "");
      reading.problems.add({key, "this is a study, which varies a case, and not a case", "a case",
                            fmt::format("Use \"kerf study {}\"", file_name)});
      reading.problems.throw_if_any();
    }
}

// Reads the dimension first, because the reading of all other keys depends on it.
int read_dimension(Reading& reading, const toml::table& table) {
  Section section(reading, table, "", "");
  Case result;
  section.read_one("dimension", result);
  reading.problems.throw_if_any();
  return result.dimension;
}

void read_top(Draft& draft, const toml::table& table) {
  Section top(draft.reading, table, "", "");
  Case& result = draft.result;
  result.formulation = top.word<Formulation>("formulation");
  draft.reading.formulation = formulation_name(result.formulation);
  top.read(result);
  top.read(draft);
  read_domain(draft, top);
  read_materials(draft, top);
  read_jets(draft, top);
  read_machine(draft, top);
  read_workpiece(draft, top);
  read_bodies(draft, top);
  read_loads(draft, top);
  read_time(draft, top);
  read_probes(draft, top);
  read_extras(draft, top);
  read_output(draft, top);
  if (!top.has("body") && !top.has("jet") && !top.has("machine"))
    top.refuse("body", "the case holds no body and no jet", "Add a [[body]] or a [[jet]]",
               "at least one body or jet");
  top.refuse_unknown();
  draft.reading.problems.throw_if_any();
}

}  // namespace

Case parse_case(std::string_view text, std::string_view file_name, const ReadEffort& effort) {
  const toml::table table = parse_toml(text, file_name);
  const std::filesystem::path folder = std::filesystem::path(file_name).parent_path();
  Draft draft{Reading{Problems(std::string(file_name)), folder},
              {},
              {},
              {},
              {},
              {},
              false,
              Quality::normal,
              effort};
  refuse_study(draft.reading, table, file_name);
  draft.reading.dimension = read_dimension(draft.reading, table);
  read_top(draft, table);
  finish(draft);
  draft.reading.problems.throw_if_any();
  check_symmetry(draft);
  check_bodies(draft);
  check_joints(draft);
  check_loads(draft);
  check_jets(draft);
  check_nozzles(draft);
  check_probes(draft);
  check_fracture(draft);
  draft.reading.problems.throw_if_any();
  return draft.result;
}

std::string case_text(const std::filesystem::path& file) {
  std::error_code error;
  const auto size = std::filesystem::file_size(file, error);
  if (error)
    throw UserError(fmt::format("{}: the case file cannot be read: {}. Check its name, or make one "
                                "with \"kerf new\".",
                                file.string(), error.message()),
                    exit_files);
  if (size > largest_file)
    throw UserError(
        fmt::format("{}: the file is {} bytes long. Allowed: at most {} bytes. Is this "
                    "a case file?",
                    file.string(), size, largest_file));
  std::ifstream stream(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (!stream)
    throw UserError(
        fmt::format("{}: the case file cannot be read. Check its permissions.", file.string()),
        exit_files);
  return text;
}

Case read_case(const std::filesystem::path& file, const ReadEffort& effort) {
  return parse_case(case_text(file), file.string(), effort);
}

}  // namespace kerf
