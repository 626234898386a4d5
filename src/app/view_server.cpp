// SPDX-License-Identifier: Apache-2.0
#include "app/view_server.hpp"

namespace kerf {

ViewServer::ViewServer(const std::filesystem::path& folder)
    : LocalServer("kerf view"), view_(folder) {
  get("", RunView::page_type, [this](const auto&) { return view_.page(); });
  serve_files(*this, view_, "");
}

}  // namespace kerf
