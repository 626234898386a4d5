// SPDX-License-Identifier: Apache-2.0
#include "app/edit_server.hpp"

#include <fmt/format.h>

#include <array>

#include "app/case_form.hpp"
#include "report/html.hpp"
#include "report/viewer_files.hpp"

namespace kerf {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

constexpr std::array<const char*, 3> existing_words{"refuse", "resume", "replace"};
constexpr std::array<const char*, 4> state_words{"running", "completed", "stopped", "failed"};

Json parsed(const std::string& body) {
  try {
    return Json::parse(body);
  } catch (const Json::exception& error) {
    throw RefusedRequest(http_status::bad_request, fmt::format("no JSON: {}", error.what()));
  }
}

// Returns a handler that takes JSON and refuses a request without the members that `act` reads.
template <class Act>
LocalServer::Post json_handler(Act act) {
  return [act](const std::string& body) {
    const Json request = parsed(body);
    try {
      return act(request).dump();
    } catch (const Json::exception& error) {
      throw RefusedRequest(http_status::bad_request, error.what());
    }
  };
}

Existing existing_of(const std::string& word) {
  for (std::size_t n = 0; n < existing_words.size(); ++n)
    if (word == existing_words[n]) return static_cast<Existing>(n);
  throw RefusedRequest(http_status::bad_request, "existing: refuse, resume or replace");
}

}  // namespace

EditServer::EditServer(const Settings& settings)
    : LocalServer("kerf view --edit"),
      program_(settings.program),
      editor_(settings.file, settings.folder) {
  if (viewer_text("edit_script").empty())
    throw UserError(
        "this Kerf was built without npm and has no page for editing. Edit the case in any editor, "
        "and check it with \"kerf check\".");
  set_routes();
  set_view_routes();
}

void EditServer::set_routes() {
  get("", RunView::page_type, [this](const auto&) { return page(); });
  get("schema", RunView::json_type, [](const auto&) { return form_schema().dump(); });
  get("case", RunView::json_type, [this](const auto&) { return editor_.read().dump(); });
  get("run", RunView::json_type, [this](const auto&) { return run_state().dump(); });
  post("check", json_handler([this](const Json& request) { return editor_.check(request); }));
  post("add", json_handler([this](const Json& request) { return editor_.add(request); }));
  post("remove", json_handler([this](const Json& request) { return editor_.remove(request); }));
  post("save", json_handler([this](const Json& request) { return editor_.save(request); }));
  post("template",
       json_handler([this](const Json& request) { return editor_.from_template(request); }));
  post("run", json_handler([this](const Json& request) { return start(request); }));
  post("pilot", json_handler([this](const Json& request) { return start_pilot(request); }));
  post("stop", json_handler([this](const Json&) { return stop_run(); }));
}

void EditServer::set_view_routes() {
  const std::string base = R"(view/(\d{1,9})/)";
  get(base, RunView::page_type, [this](const auto& parts) { return view(parts[1])->page(); });
  get(base + "run.json", RunView::json_type,
      [this](const auto& parts) { return view(parts[1])->run_json(); });
  get(base + RunView::frame_pattern, RunView::frame_type,
      [this](const auto& parts) { return view(parts[1])->frame(std::stoul(parts[2])); });
}

std::string EditServer::page() const {
  return html::page("Kerf: edit a case",
                    fmt::format("<div id=\"kerf-edit\"><noscript>This page needs JavaScript."
                                "</noscript></div>\n<script>\n{}</script>\n",
                                viewer_text("edit_script")),
                    "edit_style");
}

Json EditServer::start(const Json& request) {
  const fs::path file = editor_.file();
  if (file.empty() || !fs::exists(file))
    throw RefusedRequest(http_status::conflict, "The case is not saved yet. Save it first.");
  const auto folder = request.value("folder", std::string());
  const Existing existing = existing_of(request.value("existing", std::string("refuse")));
  start_run({program_, file, folder.empty() ? default_folder(file) : fs::path(folder), existing});
  return run_state();
}

Json EditServer::start_pilot(const Json& request) {
  {
    const std::lock_guard hold(mutex_);
    refuse_second_run();  // whose case file stays as it is
  }
  const PilotFile pilot = editor_.write_pilot(request);
  start_run({program_, pilot.file, default_folder(pilot.file), Existing::replace}, pilot.changes);
  return run_state();
}

void EditServer::refuse_second_run() const {
  if (run_ && run_->state() == CaseRun::State::running)
    throw RefusedRequest(http_status::conflict, "A run is in progress. Stop it first.");
}

void EditServer::start_run(CaseRun::Order order, std::vector<std::string> changes) {
  const std::lock_guard hold(mutex_);
  refuse_second_run();
  view_.reset();
  run_.reset();  // it has ended
  run_ = std::make_unique<CaseRun>(std::move(order));
  changes_ = std::move(changes);
  ++runs_;
}

Json EditServer::stop_run() {
  {
    const std::lock_guard hold(mutex_);
    if (run_) run_->stop();
  }
  return run_state();
}

Json EditServer::run_state() {
  const std::lock_guard hold(mutex_);
  const fs::path file = editor_.file();
  Json state = {{"state", "none"}, {"folder", file.empty() ? "" : default_folder(file).string()}};
  if (!run_) return state;
  state["state"] = state_words[static_cast<std::size_t>(run_->state())];
  state["results"] = run_->folder().string();
  state["changes"] = changes_;
  state["output"] = run_->output();
  state["view"] = run_->has_begun() ? fmt::format("view/{}/", runs_) : "";
  return state;
}

std::shared_ptr<RunView> EditServer::view(const std::string& number) {
  const std::lock_guard hold(mutex_);
  if (!run_ || number != std::to_string(runs_))
    throw RefusedRequest(http_status::not_found, "There is no such run.\n");
  if (!view_) view_ = std::make_shared<RunView>(run_->folder());
  return view_;
}

}  // namespace kerf
