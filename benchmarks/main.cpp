// SPDX-License-Identifier: Apache-2.0
// How fast the engine is, stage by stage and as a whole, by Google Benchmark:
//   kerf_benchmarks [--threads=N] [--benchmark_...=...] [CASE.toml ...]
// Ends with another code than 0 when a benchmark failed or none was chosen.
#include <fmt/format.h>
#include <oneapi/tbb/info.h>

#include <charconv>
#include <string_view>
#include <vector>

#include "build_commit.hpp"
#include "core/processor.hpp"
#include "core/version.hpp"
#include "measure.hpp"
#include "parallel/threads.hpp"
#include "simd/instruction_set.hpp"

namespace kerf {
namespace {

constexpr std::string_view threads_option = "--threads=";

struct Options {
  int threads = 0;  // 0 = every core
  std::vector<std::string> cases;
  bool understood = true;
};

// Of what Google Benchmark has left of the arguments.
Options read_options(int count, char** arguments) {
  Options options;
  for (int a = 1; a < count; ++a) {
    const std::string_view argument = arguments[a];
    if (argument.starts_with(threads_option)) {
      const char* const end = argument.data() + argument.size();
      const auto [at, error] =
          std::from_chars(argument.data() + threads_option.size(), end, options.threads);
      options.understood &= at == end && error == std::errc() && options.threads >= 0;
    } else if (argument.starts_with("-")) {
      options.understood = false;
    } else {
      options.cases.emplace_back(argument);
    }
    if (!options.understood) {
      fmt::print(stderr, "kerf_benchmarks: error: {} is no option or value of one\n", argument);
      break;
    }
  }
  return options;
}

void add_context(int threads) {
  const int used = threads > 0 ? threads : oneapi::tbb::info::default_concurrency();
  benchmark::AddCustomContext("kerf", program_version);
  benchmark::AddCustomContext("commit", build_commit);
  benchmark::AddCustomContext("compiler", compiler_name());
  benchmark::AddCustomContext("flags", KERF_BENCHMARK_FLAGS);
  benchmark::AddCustomContext("processor", processor_name());
  benchmark::AddCustomContext("instruction_set", instruction_set_name());
  benchmark::AddCustomContext("threads", std::to_string(used));
}

int run(int count, char** arguments) {
  benchmark::Initialize(&count, arguments);
  const Options options = read_options(count, arguments);
  if (!options.understood) return 2;
  set_threads(options.threads);
  add_context(options.threads);
  add_stage_benchmarks();
  add_block_run_benchmarks();
  add_run_benchmark(KERF_SOURCE_DIR "/cases/tofu-5ms-standard.toml");
  for (const std::string& file : options.cases) add_run_benchmark(file);
  const bool any = benchmark::RunSpecifiedBenchmarks() > 0;
  benchmark::Shutdown();
  return any && !any_failed() ? 0 : 1;
}

}  // namespace
}  // namespace kerf

int main(int count, char** arguments) {
  try {
    return kerf::run(count, arguments);
  } catch (const std::exception& error) {
    fmt::print(stderr, "kerf_benchmarks: error: {}\n", error.what());
    return 1;
  }
}
