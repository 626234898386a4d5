// SPDX-License-Identifier: Apache-2.0
#include "app/command_line.hpp"

#include <fmt/format.h>
#include <oneapi/tbb/info.h>

#include <map>
#include <string>

#include "core/error.hpp"
#include "input/problems.hpp"
#include "parallel/threads.hpp"

namespace kerf {

void add_device_option(CLI::App& command, Device& device) {
  std::map<std::string, Device> devices;
  for (const Device each : {Device::cpu, Device::gpu}) devices[word_of(each)] = each;
  command
      .add_option_function<std::string>(
          "--device", [&device, devices](const std::string& word) { device = devices.at(word); },
          "device that computes: the threads of this machine, or an NVIDIA GPU")
      ->check(CLI::IsMember(devices))
      ->default_str(word_of(device));
}

void add_machine_options(CLI::App& command, MachineOptions& options) {
  command.add_option("--threads", options.threads, "number of threads; default: one per core")
      ->check(CLI::Range(1, 4096));
  add_device_option(command, options.device);
}

CLI::Option* add_out_option(CLI::App& command, std::string& folder, const std::string& meaning) {
  const CLI::Validator is_named(
      [](const std::string& text) {
        return std::string(text.empty() ? "the folder has no name. Allowed: the path of a folder. "
                                          "Leave --out away for the default"
                                        : "");
      },
      "");
  return command.add_option("--out", folder, meaning)->check(is_named);
}

void take_machine(const MachineOptions& options) {
  set_threads(options.threads);
  set_device(options.device);
}

int threads_of(const MachineOptions& options) {
  return options.threads > 0 ? options.threads : oneapi::tbb::info::default_concurrency();
}

void refuse_name(const std::string& sentence, const std::string& name,
                 const std::vector<std::string>& known, const std::string& separator) {
  std::string guess = closest(name, known);
  for (const std::string& each : known)
    if (guess.empty() && !name.empty() && each.find(name) != std::string::npos) guess = each;
  throw UserError(fmt::format("{}. {}Allowed: {}.", sentence,
                              guess.empty() ? "" : fmt::format("Did you mean \"{}\"? ", guess),
                              fmt::join(known, separator)));
}

}  // namespace kerf
