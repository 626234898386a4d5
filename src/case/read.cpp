// SPDX-License-Identifier: Apache-2.0
#include "case/read.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>

#include "case/draft.hpp"
#include "core/error.hpp"

namespace kerf {

namespace {

constexpr std::uintmax_t largest_file = 64u << 20;  // bytes

toml::table parse_toml(std::string_view text, std::string_view file_name) {
  try {
    return toml::parse(text, file_name);
  } catch (const toml::parse_error& error) {
    throw UserError(fmt::format("{}:{}: this is not valid TOML: {}. Correct the line.", file_name,
                                static_cast<int>(error.source().begin.line), error.description()));
  }
}

void read_time(Draft& draft, Section& top) {
  const toml::table empty;
  const toml::table* written = top.table("time");
  Section section(draft.reading, written ? *written : empty, "time", written ? "time" : "");
  TimeControl& time = draft.result.time;
  const double standard = standard_end(draft);
  if (standard > 0.0)
    time.end = section.number("end", standard);
  else if (!section.has("end"))
    section.refuse("end", "the key is missing", "Add it: when the run ends");
  else
    time.end = section.number("end");
  time.courant = section.number("courant");
  time.maximum_step = section.number("maximum_step");
  section.refuse_unknown();
}

void read_domain(Draft& draft, Section& top) {
  const toml::table* written = top.table("domain");
  draft.has_domain = written != nullptr;
  if (!written) return;
  Section section(draft.reading, *written, "domain", "domain");
  Box& domain = draft.result.domain;
  domain.minimum = section.vector("minimum");
  domain.maximum = section.vector("maximum");
  section.assume(formulation_name(draft.result.formulation));
  if (section.has("symmetry")) draft.result.symmetry = section.faces("symmetry");
  for (int a = 0; a < draft.reading.dimension; ++a) {
    const auto axis = static_cast<std::size_t>(a);
    if (domain.minimum[axis] < domain.maximum[axis]) continue;
    section.refuse("maximum",
                   fmt::format("entry {} is not greater than that of the minimum", a + 1),
                   "Swap the corners or correct one", "beyond the minimum along each axis");
    break;
  }
  section.refuse_unknown();
}

void read_extras(Draft& draft, Section& top) {
  if (const toml::table* written = top.table("backflow_eraser")) {
    Section section(draft.reading, *written, "backflow_eraser", "backflow_eraser");
    draft.result.eraser = Eraser{section.number("speed_fraction")};
    section.refuse_unknown();
  }
  if (const toml::table* written = top.table("artificial_stress")) {
    Section section(draft.reading, *written, "artificial_stress", "artificial_stress");
    draft.result.artificial_stress = {section.number("epsilon"), section.number("exponent")};
    section.refuse_unknown();
  }
}

void read_numerics(Draft& draft, Section& top) {
  const toml::table* written = top.table("numerics");
  if (!written) return;
  Section section(draft.reading, *written, "numerics", "numerics");
  Numerics& numerics = draft.result.numerics;
  numerics.water = law_of<WaterScheme>(section.text("water"), water_scheme_words);
  numerics.shifting = section.flag("shifting");
  numerics.subcycles = section.integer("subcycles");
  section.refuse_unknown();
}

// The dimension decides how everything else is read.
int read_dimension(Reading& reading, const toml::table& table) {
  Section section(reading, table, "", "");
  const int dimension = section.integer("dimension");
  reading.problems.throw_if_any();
  return dimension;
}

void read_top(Draft& draft, const toml::table& table) {
  Section top(draft.reading, table, "", "");
  Case& result = draft.result;
  result.dimension = draft.reading.dimension;
  result.title = top.text("title");
  result.formulation =
      top.text("formulation") == "standard" ? Formulation::standard : Formulation::shinohara2004;
  result.precision =
      top.text("precision") == "double" ? PrecisionKind::double_precision : PrecisionKind::mixed;
  top.assume(formulation_name(result.formulation));
  result.smoothing_ratio = top.number("smoothing_ratio");
  result.gravity = top.vector("gravity");
  draft.quality = law_of<Quality>(top.text("quality"), quality_words);
  read_domain(draft, top);
  read_materials(draft, top);
  read_jets(draft, top);
  read_machine(draft, top);
  read_bodies(draft, top);
  read_time(draft, top);
  read_probes(draft, top);
  read_extras(draft, top);
  read_numerics(draft, top);
  read_output(draft, top);
  if (!top.has("body") && !top.has("jet") && !top.has("machine"))
    top.refuse("body", "the case holds no body and no jet", "Add a [[body]] or a [[jet]]",
               "at least one body or jet");
  top.refuse_unknown();
  draft.reading.problems.throw_if_any();
}

}  // namespace

Case parse_case(std::string_view text, std::string_view file_name) {
  const toml::table table = parse_toml(text, file_name);
  const std::filesystem::path folder = std::filesystem::path(file_name).parent_path();
  Draft draft{
      Reading{Problems(std::string(file_name)), folder}, {}, {}, {}, {}, false, Quality::normal};
  draft.reading.dimension = read_dimension(draft.reading, table);
  read_top(draft, table);
  finish(draft);
  draft.reading.problems.throw_if_any();
  check_symmetry(draft);
  check_bodies(draft);
  check_jets(draft);
  check_probes(draft);
  draft.reading.problems.throw_if_any();
  return draft.result;
}

Case read_case(const std::filesystem::path& file) {
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
  return parse_case(text, file.string());
}

}  // namespace kerf
