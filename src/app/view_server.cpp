// SPDX-License-Identifier: Apache-2.0
#include "app/view_server.hpp"

namespace kerf {

ViewServer::ViewServer(const std::filesystem::path& folder)
    : LocalServer("kerf view"), view_(folder) {
  get("", RunView::page_type, [this](const auto&) { return view_.page(); });
  get("run.json", RunView::json_type, [this](const auto&) { return view_.run_json(); });
  get(RunView::frame_pattern, RunView::frame_type,
      [this](const auto& parts) { return view_.frame(std::stoul(parts[1])); });
}

}  // namespace kerf
