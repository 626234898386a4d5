// SPDX-License-Identifier: Apache-2.0
#include "study/process_limits.hpp"

#include <fmt/format.h>
#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <thread>
#include <vector>

#include "core/error.hpp"
#include "output/readable.hpp"

namespace kerf {

namespace {

constexpr double mebibyte = 1024.0 * 1024.0;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double least_stack = mebibyte;

double limit_of(__rlimit_resource resource) {
  rlimit limit{};
  const bool is_limited = getrlimit(resource, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
  return is_limited ? static_cast<double>(limit.rlim_cur) : infinity;
}

struct Space {
  const char* name;  // of the limit in the shell
  double limit, used;
};

// The spaces that have a limit.
std::vector<Space> limited_spaces() {
  double size = 0.0, resident = 0.0, shared = 0.0, code = 0.0, library = 0.0, data = 0.0;
  std::ifstream("/proc/self/statm") >> size >> resident >> shared >> code >> library >> data;
  const auto page = static_cast<double>(sysconf(_SC_PAGESIZE));
  std::vector<Space> spaces{{"ulimit -v", limit_of(RLIMIT_AS), page * size},
                            {"ulimit -d", limit_of(RLIMIT_DATA), page * data}};
  std::erase_if(spaces, [](const Space& space) { return space.limit == infinity; });
  return spaces;
}

// What the libraries and the stacks of the threads take in a run of any size.
double reserve() {
  constexpr double of_libraries = 64.0 * mebibyte, usual_stack = 8.0 * mebibyte;
  const double stack = std::min(limit_of(RLIMIT_STACK), usual_stack);
  return of_libraries + stack * (1.0 + std::thread::hardware_concurrency());
}

}  // namespace

double memory_within_limits() {
  double left = infinity;
  for (const Space& space : limited_spaces())
    left = std::min(left, space.limit - space.used - reserve());
  return left;
}

void refuse_small_limits() {
  const std::vector<Space> spaces = limited_spaces();
  // Else each thread would reserve 64 MiB for its allocations.
  if (!spaces.empty()) mallopt(M_ARENA_MAX, 1);
  const auto refuse = [](const char* name, double limit, double least) {
    throw UserError(fmt::format("there is not enough memory: this process may have {} ({}). "
                                "Allowed: at least {}. Raise the limit.",
                                readable(limit, "B"), name, readable(least, "B")),
                    exit_run_failed);
  };
  for (const Space& space : spaces)
    if (const double least = space.used + reserve(); space.limit < least)
      refuse(space.name, space.limit, least);
  if (limit_of(RLIMIT_STACK) < least_stack)
    refuse("ulimit -s", limit_of(RLIMIT_STACK), least_stack);
}

}  // namespace kerf
