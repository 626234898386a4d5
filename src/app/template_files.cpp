// SPDX-License-Identifier: Apache-2.0
#include "app/template_files.hpp"

#include <fmt/format.h>

#include "app/embedded.hpp"
#include "output/files.hpp"

namespace kerf {

std::string_view template_title(std::string_view text) {
  const std::string_view line = text.substr(0, text.find('\n'));
  const auto colon = line.find(": ");
  return colon == std::string_view::npos ? line : line.substr(colon + 2);
}

std::vector<std::string> write_meshes(std::string_view text, const std::filesystem::path& folder) {
  std::vector<std::string> sentences;
  for (const EmbeddedText& mesh : case_meshes()) {
    const std::string file = fmt::format("{}.stl", mesh.name);
    if (text.find(fmt::format("\"{}\"", file)) == std::string_view::npos) continue;
    const bool is_there = std::filesystem::exists(folder / file);
    if (!is_there) write_file(folder / file, mesh.text);
    sentences.push_back(
        fmt::format("{} {}: the case reads it from its own folder.", file,
                    is_there ? "exists already and was not changed" : "was written"));
  }
  return sentences;
}

}  // namespace kerf
