// SPDX-License-Identifier: Apache-2.0
// This file reads what a run has left for the pages on it.
#include <fmt/format.h>

#include "core/error.hpp"
#include "output/files.hpp"
#include "report/html.hpp"
#include "report/report_parts.hpp"

namespace kerf {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

fs::path file_of(const fs::path& folder, const Json& picture) {
  return folder / picture.at("file").get<std::string>();
}

std::string picture_figure(const fs::path& folder, const Json& picture) {
  return fmt::format("<figure><img alt=\"The particles at {:.4g} ms\" src=\"{}\"></figure>\n",
                     1e3 * picture.at("time").get<double>(),
                     html::png_address(read_file(file_of(folder, picture))));
}

std::string last_picture(const Json& result, const fs::path& folder) {
  const Json& list = result.at("pictures");
  return list.empty() ? "" : picture_figure(folder, list.back());
}

void refuse_result(const fs::path& path, const char* why) {
  throw UserError(
      fmt::format("{} is damaged ({}). Remove it, and make it again with 'kerf run CASE "
                  "--out {} --resume'.",
                  path.string(), why, path.parent_path().string()),
      exit_files);
}

Json read_result(const fs::path& path) {
  if (!fs::exists(path))
    throw UserError(fmt::format("there is no {}: the run has not ended yet. Continue it with 'kerf "
                                "run CASE --out {} --resume'.",
                                path.string(), path.parent_path().string()),
                    exit_files);
  return using_result(path, [&] { return Json::parse(read_file(path)); });
}

// The sign has the same meaning as the colour.
std::string verdict_part(const Json& result, bool has_jet) {
  struct Answer {
    const char *kind, *sign;
  };
  static constexpr Answer no_jet{"none", ""}, yes{"yes", "<b>✓</b>"}, no{"no", "<b>✗</b>"},
      perhaps{"none", "<b>?</b>"};
  const auto is = [&](const Json& of, const char* key) { return of.at(key).get<bool>(); };
  Answer answer = !has_jet ? no_jet : is(result, "cut_through") ? yes : no;
  if (const auto exposure = result.find("exposure"); exposure != result.end())
    answer = is(*exposure, "cuts") ? yes : is(*exposure, "may_cut") ? perhaps : no;
  return fmt::format("<p class=\"verdict {}\">{}<span>{}</span></p>\n", answer.kind, answer.sign,
                     html::escape(result.at("verdict").get<std::string>()));
}

}  // namespace kerf
