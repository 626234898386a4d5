// SPDX-License-Identifier: Apache-2.0
// What the fuzz programs share: the rule that every reader keeps, and files to begin with.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/error.hpp"

namespace kerf::test {

// Calls `read`. It may refuse its input by a UserError that names `file`, or fail as a run does
// that comes to a value that is not a number; any other exception is a defect.
template <class Read>
void read_or_refuse(const std::string& file, const Read& read) {
  try {
    read();
  } catch (const UserError& error) {
    const bool is_named = std::string_view(error.what()).find(file) != std::string_view::npos;
    if (is_named || error.exit_code() == exit_run_failed) return;
    std::cerr << "the message does not name " << file << ": " << error.what() << std::endl;
    std::abort();
  } catch (const std::exception& error) {
    std::cerr << "not a UserError: " << error.what() << std::endl;
    std::abort();
  }
}

inline std::string bytes_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

// Writes a file without waiting for the disk.
inline void put(const std::filesystem::path& file, std::string_view content) {
  std::ofstream(file, std::ios::binary)
      .write(content.data(), static_cast<std::streamsize>(content.size()));
}
inline std::string content_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

// Puts the first inputs into the first folder of the command line, if it is empty.
inline void put_first_inputs(int argc, char** argv, const std::vector<std::string>& inputs) {
  namespace fs = std::filesystem;
  const auto found =
      std::find_if(argv + 1, argv + argc, [](const char* word) { return fs::is_directory(word); });
  if (found == argv + argc || !fs::is_empty(*found)) return;
  const fs::path folder = *found;
  for (std::size_t n = 0; n < inputs.size(); ++n)
    put(folder / ("first" + std::to_string(n)), inputs[n]);
}

// Takes numbers from the bytes of an input, zeros after its end.
class Numbers {
 public:
  Numbers(const std::uint8_t* data, std::size_t size) : left_(data, size) {}
  bool empty() const { return left_.empty(); }
  template <class T>
  T take() {
    T value{};
    const std::size_t size = std::min(sizeof(T), left_.size());
    std::memcpy(&value, left_.data(), size);
    left_ = left_.subspan(size);
    return value;
  }

 private:
  std::span<const std::uint8_t> left_;
};

}  // namespace kerf::test
