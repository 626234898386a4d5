// SPDX-License-Identifier: Apache-2.0
// A folder that is removed at the end of the test.
#pragma once

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace kerf::test {

class TemporaryFolder {
 public:
  TemporaryFolder() {
    // In memory if possible, so the tests do not wait for a disk.
    const std::filesystem::path memory = "/dev/shm";
    const auto place = std::filesystem::is_directory(memory) && access(memory.c_str(), W_OK) == 0
                           ? memory
                           : std::filesystem::temp_directory_path();
    std::string name = (place / "kerf_test_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make " + name);
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

// Returns the message of the UserError that `attempt` throws; empty when it throws none.
template <class Error, class Attempt>
std::string message_of(const Attempt& attempt) {
  try {
    attempt();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace kerf::test
