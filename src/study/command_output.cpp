// SPDX-License-Identifier: Apache-2.0
#include "study/command_output.hpp"

#include <boost/asio/io_context.hpp>
#include <boost/process.hpp>
#include <future>

namespace kerf {

namespace process = boost::process;

CommandOutput output_of(const std::string& program, const std::vector<std::string>& arguments) {
  const auto path = process::search_path(program);
  if (path.empty()) return {-1, "", program + " is not installed"};
  boost::asio::io_context context;  // reads both streams, so that neither blocks the program
  std::future<std::string> output, errors;
  process::child child(path, process::args(arguments),
                       process::std_in<process::null, process::std_out> output,
                       process::std_err > errors, context);
  context.run();
  child.wait();
  return {child.exit_code(), output.get(), errors.get()};
}

}  // namespace kerf
