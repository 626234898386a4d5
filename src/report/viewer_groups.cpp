// SPDX-License-Identifier: Apache-2.0
#include "report/viewer_groups.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "model/case.hpp"
#include "model/sources.hpp"

namespace kerf {

namespace {

constexpr std::size_t most_names = 256;
constexpr std::size_t named_pieces = 6;  // the largest ones

// Returns the materials that sources have, in the order of the case, and -1 at the end.
std::vector<int> used_materials(const Case& description) {
  std::vector<int> used = source_materials(description);
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  if (!used.empty() && used.front() < 0) std::rotate(used.begin(), used.begin() + 1, used.end());
  return used;
}

std::vector<std::string> material_names(const Case& description) {
  std::vector<std::string> names;
  for (const int material : used_materials(description))
    names.push_back(
        material < 0 ? "rigid" : description.materials.at(static_cast<std::size_t>(material)).name);
  return names;
}

std::vector<std::string> piece_names() {
  std::vector<std::string> names{"largest piece"};
  for (std::size_t n = 2; n <= named_pieces; ++n) names.push_back(fmt::format("piece {}", n));
  names.push_back("smaller pieces");
  names.push_back("no solid");
  return names;
}

bool is_of_solid(Category category) {
  return category == Category::solid || category == Category::fractured;
}

// Numbers the pieces by their mass, the heaviest first.
std::vector<float> piece_values(const Frame& frame) {
  std::map<std::uint32_t, double> mass;
  for (std::size_t i = 0; i < frame.piece.size(); ++i)
    if (is_of_solid(frame.category[i])) mass[frame.piece[i]] += static_cast<double>(frame.mass[i]);
  std::vector<std::pair<double, std::uint32_t>> order;
  for (const auto& [piece, of_piece] : mass) order.push_back({-of_piece, piece});
  std::sort(order.begin(), order.end());
  std::map<std::uint32_t, float> rank;
  for (std::size_t n = 0; n < order.size(); ++n)
    rank[order[n].second] = static_cast<float>(std::min(n, named_pieces));
  std::vector<float> values;
  for (std::size_t i = 0; i < frame.piece.size(); ++i)
    values.push_back(is_of_solid(frame.category[i]) ? rank.at(frame.piece[i])
                                                    : static_cast<float>(named_pieces + 1));
  return values;
}

// Returns for each source the number of its material among the used ones.
std::vector<float> material_numbers(const Case& description) {
  const std::vector<int> used = used_materials(description);
  std::vector<float> numbers;
  for (const int material : source_materials(description))
    numbers.push_back(
        static_cast<float>(std::find(used.begin(), used.end(), material) - used.begin()));
  return numbers;
}

}  // namespace

std::vector<ViewerGroups> viewer_groups(const Frame& frame, const Case& description) {
  std::vector<ViewerGroups> groups{{"body", "body", source_names(description)},
                                   {"material", "material", material_names(description)}};
  std::erase_if(groups, [](const ViewerGroups& one) {
    return one.names.size() < 2 || one.names.size() > most_names;
  });
  if (!frame.piece.empty()) groups.push_back({"piece", "piece", piece_names()});
  return groups;
}

std::optional<std::vector<float>> group_values(const std::string& key, const Frame& frame,
                                               const Case& description) {
  const std::size_t sources = description.bodies.size() + description.jets.size();
  if (key == "piece")
    return frame.piece.empty() ? std::vector<float>(frame.id.size(), 0.0f) : piece_values(frame);
  if (key != "body" && key != "material") return std::nullopt;
  const std::vector<float> materials = material_numbers(description);
  std::vector<float> values;
  for (const std::size_t source : frame.source) {
    const std::size_t known = std::min(source, sources - 1);
    values.push_back(key == "body" ? static_cast<float>(known) : materials[known]);
  }
  return values;
}

}  // namespace kerf
