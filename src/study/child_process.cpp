// SPDX-License-Identifier: Apache-2.0
#include "study/child_process.hpp"

#include <fmt/format.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>
#include <boost/asio/io_context.hpp>
#include <boost/process.hpp>
#include <boost/process/extend.hpp>

#include <future>

#include "core/error.hpp"

namespace kerf {

namespace process = boost::process;

struct ChildProcess::State {
  process::child child;
};

namespace {

// This is run in the child between fork and exec. The system kills the child when this process ends
// in any way; the test of the parent covers one that ended before.
template <class Executor>
void bind_to_parent(Executor&, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  setpgid(0, 0);
  if (getppid() != parent) _exit(1);
}

}  // namespace

ChildProcess::ChildProcess(const std::filesystem::path& program,
                           const std::vector<std::string>& arguments,
                           const std::filesystem::path& output) {
  const pid_t parent = getpid();
  std::error_code error;
  process::child child(
      program.string(), process::args(arguments),
      (process::std_out & process::std_err) > output.string(), process::std_in < process::null,
      process::extend::on_exec_setup =
          [parent](auto& executor) { bind_to_parent(executor, parent); },
      error);
  if (error)
    throw UserError(fmt::format("cannot start {}: {}. Is there memory left for another process?",
                                program.string(), error.message()),
                    exit_files);
  state_ = std::make_unique<State>(State{std::move(child)});
}

ChildProcess::ChildProcess(ChildProcess&&) noexcept = default;

ChildProcess::~ChildProcess() {
  if (!state_) return;
  std::error_code ignored;
  if (state_->child.running(ignored)) state_->child.terminate(ignored);
}

std::optional<JobEnd> ChildProcess::end() {
  std::error_code ignored;
  if (state_->child.running(ignored)) return std::nullopt;
  const int status = state_->child.native_exit_code();
  if (WIFSIGNALED(status)) return JobEnd{0, WTERMSIG(status), ""};
  return JobEnd{WEXITSTATUS(status), 0, ""};
}

void ChildProcess::send(int signal) {
  ::kill(state_->child.id(), signal);
}

CommandOutput output_of(const std::string& program, const std::vector<std::string>& arguments) {
  const auto path = process::search_path(program);
  if (path.empty()) return {-1, "", program + " is not installed"};
  boost::asio::io_context context;  // it reads both streams, so that neither blocks the program
  std::future<std::string> output, errors;
  process::child child(path, process::args(arguments),
                       process::std_in<process::null, process::std_out> output,
                       process::std_err > errors, context);
  context.run();
  child.wait();
  return {child.exit_code(), output.get(), errors.get()};
}

}  // namespace kerf
