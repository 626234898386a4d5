// SPDX-License-Identifier: Apache-2.0
#include "study/slurm_request.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "core/error.hpp"
#include "output/files.hpp"
#include "study/child_process.hpp"

namespace kerf {

std::string quoted_for_shell(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

std::string with_exit_code(const std::string& command, const std::string& file) {
  return fmt::format(R"({0}
code=$?
if [ "$code" -lt 128 ]; then
  echo "$code" > {1}.tmp && mv {1}.tmp {1}
fi
exit "$code"
)",
                     command, file);
}

std::optional<int> written_exit_code(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return std::nullopt;
  return std::atoi(read_file(file).c_str());
}

std::vector<std::string> start_words(const SlurmResources& resources,
                                     const std::filesystem::path& program) {
  if (resources.ranks == 1) return {program.string()};
  // Slurm confines the job to its cores; mpirun would bind all threads of a rank to one of them.
  return {"mpirun", "-n", std::to_string(resources.ranks), "--bind-to", "none", program.string()};
}

std::string submit_to_slurm(const SlurmResources& resources,
                            const std::vector<std::string>& words) {
  constexpr double mebibyte = 1024.0 * 1024.0, spare = 256.0, factor = 1.5;
  std::vector<std::string> all{
      "--parsable", fmt::format("--ntasks={}", resources.ranks),
      fmt::format("--cpus-per-task={}", resources.cores),
      fmt::format("--mem={:.0f}M",  // of each node, which may have all ranks
                  resources.ranks * std::ceil(factor * resources.memory / mebibyte + spare)),
      "--output=/dev/null"};
  if (resources.device == "gpu") all.push_back("--gres=gpu:1");
  all.insert(all.end(), words.begin(), words.end());
  const CommandOutput answer = output_of("sbatch", all);
  if (answer.exit_code != 0)
    throw UserError(fmt::format("--on slurm: sbatch refused the run: {} Options for this cluster, "
                                "such as SBATCH_PARTITION or SBATCH_TIMELIMIT, may be put into "
                                "the environment.",
                                answer.errors),
                    exit_files);
  return answer.output.substr(0, answer.output.find_first_of(";\n"));  // "12;cluster"
}

}  // namespace kerf
