// SPDX-License-Identifier: Apache-2.0
// The real program as a child process, and small disks to fill.
#pragma once

#include <fcntl.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "output/files.hpp"

namespace kerf::test {

struct Ending {
  int exit_code = -1;  // -1 = ended by a signal
  int signal = 0;
  std::string output;           // standard output and standard error
  double processor_time = 0.0;  // s
  double memory = 0.0;          // bytes, the most that it had
};

class Program {
 public:
  Program(const std::vector<std::string>& arguments, std::filesystem::path output)
      : Program(KERF_PROGRAM, arguments, std::move(output)) {}
  // Another program, found as a shell finds it.
  Program(const char* name, const std::vector<std::string>& arguments, std::filesystem::path output)
      : output_(std::move(output)) {
    std::vector<char*> words{const_cast<char*>(name)};
    for (const std::string& word : arguments) words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    process_ = fork();
    if (process_ < 0) throw std::runtime_error("cannot fork");
    if (process_ > 0) return;
    const int file = open(output_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    dup2(file, STDOUT_FILENO);
    dup2(file, STDERR_FILENO);
    execvp(name, words.data());
    _exit(127);
  }
  ~Program() {
    if (process_ > 0) end(SIGKILL);
  }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  Ending wait() {
    int status = 0;
    rusage usage{};
    wait4(process_, &status, 0, &usage);
    process_ = -1;
    Ending ending;
    ending.processor_time =
        static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
        1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
    ending.memory = 1024.0 * static_cast<double>(usage.ru_maxrss);
    if (WIFEXITED(status))
      ending.exit_code = WEXITSTATUS(status);
    else
      ending.signal = WTERMSIG(status);
    ending.output = read_file(output_);
    return ending;
  }
  Ending end(int signal) {
    kill(process_, signal);
    return wait();
  }
  pid_t process() const { return process_; }

 private:
  std::filesystem::path output_;
  pid_t process_ = -1;
};

// Waits until the condition holds; false after a minute.
template <class Condition>
bool wait_for(const Condition& condition) {
  for (int i = 0; i < 12000; ++i) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return false;
}

// A small disk in memory, if the user may mount one.
class SmallDisk {
 public:
  SmallDisk(std::filesystem::path place, std::size_t bytes) : place_(std::move(place)) {
    std::filesystem::create_directories(place_);
    there_ = mount("tmpfs", place_.c_str(), "tmpfs", 0, options(bytes).c_str()) == 0;
  }
  ~SmallDisk() {
    if (there_) umount2(place_.c_str(), MNT_DETACH);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

  bool there() const { return there_; }
  void resize(std::size_t bytes) const {
    if (mount("tmpfs", place_.c_str(), "tmpfs", MS_REMOUNT, options(bytes).c_str()) != 0)
      throw std::runtime_error("cannot enlarge the disk");
  }
  void make_read_only() const {
    if (mount("tmpfs", place_.c_str(), "tmpfs", MS_REMOUNT | MS_RDONLY, nullptr) != 0)
      throw std::runtime_error("cannot make the disk read-only");
  }

 private:
  static std::string options(std::size_t bytes) { return "size=" + std::to_string(bytes); }

  std::filesystem::path place_;
  bool there_ = false;
};

}  // namespace kerf::test
