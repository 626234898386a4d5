// SPDX-License-Identifier: Apache-2.0
// libFuzzer: whatever the bytes in the folder of a run, its report, its comparison with another run
// and the pages of kerf view are made or refused. The first byte of an input chooses the file, the
// others are its content.
#include <nlohmann/json.hpp>

#include "app/run_folder.hpp"
#include "app/run_view.hpp"
#include "fuzz/fuzzed.hpp"
#include "fuzz/small_run.hpp"
#include "report/report.hpp"
#include "support/temporary_folder.hpp"

namespace kerf::test {
namespace {

struct EndedRun {
  EndedRun() {
    run_small(folder / "run");
    run_small(folder / "other");
    for (const char* name : names) contents.push_back(content_of(folder / "run" / name));
  }

  static constexpr std::array names{"result.json",
                                    "series.csv",
                                    "case.used.toml",
                                    "small.vtkhdf.series",
                                    "frames/small_00001.vtkhdf",
                                    "pictures/small_00.png"};
  TemporaryFolder folder;
  std::vector<std::string> contents;
};

EndedRun& ended_run() {
  static EndedRun made;
  return made;
}

void make_pages() {
  const std::filesystem::path run = ended_run().folder / "run";
  const Case description = case_of_run(run);
  report_page(run, description, {});
  const std::filesystem::path other = ended_run().folder / "other";
  write_comparison({other, description}, {run, description});
  RunView view(run);
  const auto frames = nlohmann::json::parse(view.run_json()).at("frames").size();
  for (std::size_t n = 0; n < frames; ++n) view.frame(n);
}

}  // namespace
}  // namespace kerf::test

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  using namespace kerf::test;
  std::vector<std::string> inputs;
  for (std::size_t n = 0; n < ended_run().contents.size(); ++n)
    inputs.push_back(static_cast<char>(n) + ended_run().contents[n]);
  put_first_inputs(*argc, *argv, inputs);
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace kerf::test;
  if (size == 0) return 0;
  const std::size_t n = data[0] % ended_run().contents.size();
  const auto file = ended_run().folder / "run" / ended_run().names[n];
  put(file, bytes_of(data + 1, size - 1));
  read_or_refuse((ended_run().folder / "run").string(), make_pages);
  put(file, ended_run().contents[n]);
  return 0;
}
