// SPDX-License-Identifier: Apache-2.0
// This header declares the page of a run with all its frames, which follows a run that proceeds.
// kerf view and kerf view --edit serve it.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

namespace kerf {

class RunView {
 public:
  // `place`: the address of the files of the run beside that of the page, such as "first/"; empty
  // = beside the page. Throws UserError (exit_files) when the folder holds no run.
  explicit RunView(const std::filesystem::path& folder, const std::string& place = "");
  ~RunView();

  // The report of a run that has ended; else the viewer and the curves. Threads may ask at the same
  // time.
  std::string page();
  std::string run_json();
  // Returns the bytes of a frame as web/README.md describes them.
  std::string frame(std::size_t number);

  // The files beside the page: patterns and media types of HTTP. The first group of that of frames
  // is the number.
  static constexpr const char* frame_pattern = R"(frame/(\d{1,9}))";
  static constexpr const char *page_type = "text/html; charset=utf-8",
                              *json_type = "application/json",
                              *frame_type = "application/octet-stream";

 private:
  struct State;
  std::unique_ptr<State> state_;
};

class LocalServer;
// Serves what a page of the run loads, at `place` below the page. The view must outlive the server.
void serve_files(LocalServer& server, RunView& view, const std::string& place);

}  // namespace kerf
