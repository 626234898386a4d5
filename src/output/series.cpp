// SPDX-License-Identifier: Apache-2.0
#include "output/series.hpp"

#include <fmt/format.h>

#include <charconv>
#include <limits>

#include "core/error.hpp"
#include "output/files.hpp"

namespace kerf {
namespace {

// Returns the cells of one line; quoted cells keep their commas (RFC 4180).
std::vector<std::string> cells_of(std::string_view line) {
  std::vector<std::string> cells(1);
  bool inside = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool doubled = inside && line[i] == '"' && i + 1 < line.size() && line[i + 1] == '"';
    if (doubled)
      cells.back() += line[i++];
    else if (line[i] == '"')
      inside = !inside;
    else if (line[i] == ',' && !inside)
      cells.emplace_back();
    else
      cells.back() += line[i];
  }
  return cells;
}

// Returns the complete lines; the incomplete last line of a killed run is left out.
std::vector<std::string_view> lines_of(std::string_view content) {
  std::vector<std::string_view> lines;
  for (std::size_t end; (end = content.find('\n')) != std::string_view::npos;) {
    lines.push_back(content.substr(0, end));
    content.remove_prefix(end + 1);
  }
  return lines;
}

std::string header_line(const std::vector<SeriesColumn>& columns) {
  std::vector<std::string> names;
  for (const SeriesColumn& column : columns) names.push_back(header_of(column));
  return fmt::format("{}", fmt::join(names, ","));
}

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& why) {
  throw UserError(fmt::format("{}: {}. Start the run again with --force, or restore the file "
                              "that the run wrote.",
                              path.string(), why),
                  exit_files);
}

double number_of(const std::string& text) {
  double value = std::numeric_limits<double>::quiet_NaN();
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

}  // namespace

SeriesWriter::SeriesWriter(std::filesystem::path path, const Case& description)
    : path_(std::move(path)), columns_(series_columns(description)) {}

std::string SeriesWriter::header() const {
  return header_line(columns_) + "\n";
}

void SeriesWriter::start() {
  write_file(path_, header());
  rows_ = 0;
}

void SeriesWriter::append(const SeriesSample& sample) {
  std::vector<std::string> cells;
  for (const SeriesColumn& column : columns_) cells.push_back(column.text(sample));
  append_to_file(path_, fmt::format("{}\n", fmt::join(cells, ",")));
  ++rows_;
}

void SeriesWriter::cut_back(std::uint64_t step, std::size_t rows) {
  const std::string content = read_file(path_);
  const std::vector<std::string_view> lines = lines_of(content);
  if (lines.empty() || lines.front() != header_line(columns_))
    refuse(path_, "its columns are not those of this run");
  std::string kept = header();
  std::size_t count = 0;
  for (std::size_t i = 1; i < lines.size() && count < rows; ++i) {
    const std::vector<std::string> cells = cells_of(lines[i]);
    if (cells.size() != columns_.size()) refuse(path_, fmt::format("line {} is damaged", i + 1));
    if (number_of(cells[1]) > static_cast<double>(step)) break;
    kept.append(lines[i]).push_back('\n');
    ++count;
  }
  if (count != rows)
    refuse(path_, fmt::format("it holds {} rows up to step {} where the checkpoint has {}", count,
                              step, rows));
  write_file(path_, kept);
  rows_ = rows;
}

void SeriesWriter::sync() const {
  sync_file(path_);
}

SeriesTable::SeriesTable(const std::filesystem::path& path, const Case& description) {
  const std::string content = read_file(path);
  const std::vector<std::string_view> lines = lines_of(content);
  const std::vector<SeriesColumn> columns = series_columns(description);
  if (lines.empty() || lines.front() != header_line(columns))
    refuse(path, "its columns are not those of this case");
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const std::vector<std::string> cells = cells_of(lines[i]);
    if (cells.size() != columns.size()) refuse(path, fmt::format("line {} is damaged", i + 1));
    for (std::size_t k = 0; k < cells.size(); ++k) columns_[columns[k].name].push_back(cells[k]);
    ++rows_;
  }
  for (const SeriesColumn& column : columns) columns_[column.name];
}

std::vector<double> SeriesTable::numbers(const std::string& name) const {
  std::vector<double> values;
  for (const std::string& text : texts(name)) values.push_back(number_of(text));
  return values;
}

const std::vector<std::string>& SeriesTable::texts(const std::string& name) const {
  const auto found = columns_.find(name);
  require(found != columns_.end(), "a column of the series");
  return found->second;
}

}  // namespace kerf
