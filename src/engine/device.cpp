// SPDX-License-Identifier: Apache-2.0
#include "engine/device.hpp"

#include <fmt/format.h>

#include <boost/dll/runtime_symbol_info.hpp>
#include <boost/dll/shared_library.hpp>
#include <cstdlib>
#include <filesystem>

#include "core/error.hpp"
#include "core/processor.hpp"
#include "core/version.hpp"
#include "engine/gpu/gpu_engine.hpp"
#include "engine/instantiate.hpp"
#include "engine/lead.hpp"
#include "parallel/ranks.hpp"

namespace kerf {
namespace {

namespace fs = std::filesystem;

constexpr const char* file_name = "libkerf_gpu.so";
const GpuEngine* engine = nullptr;  // of the device in use; null = of this program itself

[[noreturn]] void refuse(const std::string& reason, const std::string& remedy) {
  throw UserError(fmt::format("--device gpu: {}. Allowed here: cpu. {}", reason, remedy),
                  exit_bad_input);
}

// Returns the path of the library, or the first path at which it is expected: beside the program
// (or Python module) in a build folder, or in lib as installed. The environment variable
// KERF_GPU_ENGINE names another one.
fs::path library_file() {
  if (const char* named = std::getenv("KERF_GPU_ENGINE"); named != nullptr && *named != '\0')
    return named;
  const fs::path folder = boost::dll::this_line_location().parent_path().string();
  const fs::path installed = folder.parent_path() / "lib" / file_name;
  return !fs::exists(folder / file_name) && fs::exists(installed) ? installed : folder / file_name;
}

const GpuEngine& load() {
  const fs::path file = library_file();
  const std::string build =
      "To compute on a GPU build with `cmake --preset cuda && cmake --build "
      "--preset cuda`, which needs nvcc (docs/gpu.md)";
  if (!fs::exists(file))
    refuse(fmt::format("this program has no engine for GPUs ({} is not there)", file.string()),
           build);
  boost::system::error_code error;
  // The library is never closed, because simulations that it made use its code.
  static auto& library = *new boost::dll::shared_library;
  library.load(file.string(), error, boost::dll::load_mode::rtld_now);
  if (error || !library.has(gpu_engine_symbol))
    refuse(fmt::format("{} cannot be loaded ({})", file.string(),
                       error ? error.message() : "it is no engine of Kerf"),
           build);
  const auto& found = library.get<const GpuEngine>(gpu_engine_symbol);
  if (std::string(found.version) != gpu_engine_version)
    refuse(fmt::format("{} belongs to {}, this program is {}", file.string(), found.version,
                       gpu_engine_version),
           build);
  return found;
}

}  // namespace

void set_device(Device device) {
  if (device == Device::cpu) {
    engine = nullptr;
    return;
  }
  static const GpuEngine& loaded = load();
  if (const std::string problem = loaded.problem(); !problem.empty())
    refuse(problem, "Look at what nvidia-smi says of GPU and driver, or leave the option out");
  engine = &loaded;
}

std::string device_name() {
  return engine == nullptr ? processor_name() : engine->name();
}

std::unique_ptr<Simulation> make_simulation(const Case& description) {
  if constexpr (ranks::exist)
    if (ranks::are_several()) return make_led(description);
  return engine == nullptr ? make_here(description) : engine->make(description);
}

}  // namespace kerf
