// SPDX-License-Identifier: Apache-2.0
#include "output/checkpoint.hpp"

#include <fmt/format.h>

#include <sstream>
#include <utility>

#include "core/error.hpp"
#include "core/version.hpp"
#include "output/files.hpp"
#include "output/hdf5.hpp"
#include "output/seal.hpp"

namespace kerf {
namespace {

using hdf5::Handle;

// The version of the format; it increases whenever the meaning or the layout of the content
// changes.
constexpr int format_version = 19;
constexpr const char* kind = "checkpoint";
constexpr const char* remedy = "Start the run again with --force.";

[[noreturn]] void refuse_damaged(const std::filesystem::path& path) {
  throw UserError(
      fmt::format("{} is damaged or is not a checkpoint of Kerf. {}", path.string(), remedy),
      exit_files);
}

std::vector<std::uint8_t> bytes(const std::string& text) {
  return {text.begin(), text.end()};
}

void write_text(const Handle& group, const std::string& name, const std::string& text) {
  const std::vector<std::uint8_t> values = bytes(text);
  hdf5::write(group, name, hdf5::block(values));
}

std::string read_text(const Handle& group, const std::string& name) {
  const auto values = hdf5::read_array<std::uint8_t>(group, name);
  return {values.begin(), values.end()};
}

void write_archive(const Handle& file, const std::string& name, const Archive& archive) {
  const Handle group = hdf5::create_group(file, name);
  const Handle arrays = hdf5::create_group(group, "arrays");
  for (const auto& [key, array] : archive.arrays)
    std::visit(
        [&, &key = key](const auto& values) { hdf5::write(arrays, key, hdf5::block(values)); },
        array);
  const Handle texts = hdf5::create_group(group, "texts");
  for (const auto& [key, text] : archive.texts) write_text(texts, key, text);
}

template <class T>
bool read_as(const Handle& dataset, ArchiveArray& array) {
  if (!hdf5::stored_as(dataset, hdf5::type_of<T>())) return false;
  std::vector<T> values(hdf5::size_of(dataset));
  hdf5::read(dataset, hdf5::type_of<T>(), values.data());
  array = std::move(values);
  return true;
}

ArchiveArray read_typed(const Handle& arrays, const std::string& name) {
  const Handle dataset = hdf5::open_dataset(arrays, name);
  ArchiveArray array;
  const bool known =
      read_as<double>(dataset, array) || read_as<float>(dataset, array) ||
      read_as<std::uint64_t>(dataset, array) || read_as<std::uint32_t>(dataset, array) ||
      read_as<std::uint16_t>(dataset, array) || read_as<std::uint8_t>(dataset, array);
  if (!known) throw hdf5::Error("an array of an unknown type");
  return array;
}

Archive read_archive(const Handle& file, const std::string& name) {
  Archive archive;
  const Handle group = hdf5::open_group(file, name);
  const Handle arrays = hdf5::open_group(group, "arrays");
  for (const std::string& key : hdf5::arrays_in(arrays))
    archive.arrays[key] = read_typed(arrays, key);
  const Handle texts = hdf5::open_group(group, "texts");
  for (const std::string& key : hdf5::arrays_in(texts)) archive.texts[key] = read_text(texts, key);
  return archive;
}

// Describes the first line in which two cases differ.
std::string difference(const std::string& stored, const std::string& now) {
  std::istringstream stored_lines(stored), now_lines(now);
  std::string was, is;
  for (int line = 1;; ++line) {
    const bool more_was = static_cast<bool>(std::getline(stored_lines, was));
    const bool more_is = static_cast<bool>(std::getline(now_lines, is));
    if (more_was && more_is && was == is) continue;
    return fmt::format("line {} of case.used.toml was '{}' and is '{}'", line,
                       more_was ? was : "(nothing)", more_is ? is : "(nothing)");
  }
}

void check_seal(const std::filesystem::path& path) {
  const auto version = sealed_version(read_file(path), kind);
  if (!version) refuse_damaged(path);
  if (*version == format_version) return;
  throw UserError(fmt::format("{} has version {} of the checkpoint format, this program (kerf {}) "
                              "reads version {}. Continue with the program that wrote it, or start "
                              "the run again with --force.",
                              path.string(), *version, program_version, format_version),
                  exit_files);
}

}  // namespace

void write_checkpoint(const std::filesystem::path& path, const std::string& case_text,
                      const Checkpoint& checkpoint) {
  std::string content;
  {
    const Handle file = hdf5::create();
    write_text(file, "program_version", program_version);
    write_text(file, "case", case_text);
    write_archive(file, "simulation", checkpoint.simulation);
    write_archive(file, "run", checkpoint.run);
    content = hdf5::bytes_of(file);
  }
  write_file(path, sealed(std::move(content), kind, format_version));
}

std::string case_of_checkpoint(const std::filesystem::path& path) {
  check_seal(path);
  try {
    return read_text(hdf5::open(path), "case");
  } catch (const hdf5::Error&) {
    refuse_damaged(path);
  }
}

Checkpoint read_checkpoint(const std::filesystem::path& path, const std::string& case_text) {
  if (!std::filesystem::exists(path))
    throw UserError(fmt::format("there is no checkpoint {}. {}", path.string(), remedy),
                    exit_files);
  check_seal(path);
  try {
    const Handle file = hdf5::open(path);
    const std::string stored = read_text(file, "case");
    if (stored != case_text)
      throw UserError(fmt::format("{} belongs to another case: {}. Continue with that case, or "
                                  "choose another folder with --out.",
                                  path.string(), difference(stored, case_text)),
                      exit_files);
    return {read_archive(file, "simulation"), read_archive(file, "run")};
  } catch (const hdf5::Error&) {
    refuse_damaged(path);
  }
}

}  // namespace kerf
