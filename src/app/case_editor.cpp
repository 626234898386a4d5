// SPDX-License-Identifier: Apache-2.0
#include "app/case_editor.hpp"

#include <fmt/format.h>

#include "app/case_answer.hpp"
#include "app/command_line.hpp"
#include "app/embedded.hpp"
#include "app/local_server.hpp"
#include "app/new_table.hpp"
#include "app/pilot_run.hpp"
#include "app/template_files.hpp"
#include "input/edit_tables.hpp"
#include "input/edit_toml.hpp"
#include "input/entered_value.hpp"
#include "input/read.hpp"
#include "input/schema.hpp"
#include "output/files.hpp"

namespace kerf {

namespace fs = std::filesystem;
using Json = CaseEditor::Json;

namespace {

// Returns the content of the case file, null where there is none.
Json content_of(const fs::path& file) {
  return fs::exists(file) ? Json(case_text(file)) : Json();
}

// Returns the text with a value of the form in it.
std::string with_entered(const std::string& text, const Json& change) {
  const auto path = change.at("path").get<std::string>();
  const auto section = change.at("section").get<std::string>();
  const std::string name = path.substr(path.rfind('.') + 1);
  const Key* key = find_key(section, name, {});
  if (!key)
    throw RefusedRequest(http_status::bad_request, fmt::format("{}: there is no such key", path));
  return with_value(text, path, literal_of(*key, change.at("value").get<std::string>()));
}

// Makes the changes that can be made; those that cannot become problems.
std::string with_changes(std::string text, const Json& changes, Json& problems) {
  for (const Json& change : changes) {
    try {
      text = with_entered(text, change);
    } catch (const RefusedRequest&) {
      throw;
    } catch (const UserError& error) {
      problems.push_back({{"path", change.at("path")},
                          {"line", 0},
                          {"value", change.at("value")},
                          {"what", error.what()},
                          {"allowed", ""},
                          {"remedy", ""}});
    }
  }
  return text;
}

[[noreturn]] void refuse_save(const fs::path& target, bool is_new) {
  throw RefusedRequest(
      http_status::conflict,
      is_new ? fmt::format("{} exists already. Choose another name.", target.string())
             : fmt::format("{} was changed by another program since it was read here. Nothing was "
                           "saved. Copy what you need from the text, and load this page again.",
                           target.string()));
}

// Returns what `act` returns; a change that cannot be made is refused with its reason.
template <class Act>
Json attempted(Act act) {
  try {
    return act();
  } catch (const UserError& error) {
    throw RefusedRequest(http_status::conflict, error.what());
  }
}

bool is_plain_name(const std::string& name) {
  constexpr std::string_view extension = ".toml";
  const bool is_file = name.size() > extension.size() && name.ends_with(extension);
  return is_file && !name.starts_with('.') && name.find('/') == std::string::npos;
}

}  // namespace

CaseEditor::CaseEditor(fs::path file, fs::path folder)
    : file_(std::move(file)), folder_(std::move(folder)) {
  if (fs::exists(file_)) case_text(file_);  // refuses what cannot be read
}

fs::path CaseEditor::file() const {
  const std::lock_guard hold(mutex_);
  return file_;
}

std::string CaseEditor::shown_name() const {
  const fs::path name = file();
  return name.empty() ? (folder_ / "new.toml").string() : name.string();
}

Json CaseEditor::read() const {
  const fs::path name = file();
  return {{"file", name.string()}, {"text", name.empty() ? Json() : content_of(name)}};
}

Json CaseEditor::check(const Json& request) const {
  Json problems = Json::array();
  const std::string text = with_changes(request.at("text").get<std::string>(),
                                        request.value("set", Json::array()), problems);
  Json answer = {{"text", text}};
  answer.update(case_answer(text, shown_name()));
  for (const Json& problem : problems) answer["problems"].push_back(problem);
  return answer;
}

fs::path CaseEditor::named(const Json& request) const {
  if (!file_.empty()) return file_;
  const std::string name = request.value("file", std::string());
  if (!is_plain_name(name))
    throw RefusedRequest(
        http_status::bad_request,
        fmt::format("\"{}\" is no name for the case. Allowed: a name that ends with .toml, without "
                    "a folder.",
                    name));
  return folder_ / name;
}

Json CaseEditor::save(const Json& request) {
  const std::lock_guard hold(mutex_);
  const fs::path target = named(request);
  if (content_of(target) != request.at("before")) refuse_save(target, file_.empty());
  const auto text = request.at("text").get<std::string>();
  write_file(target, text);
  file_ = target;
  return {{"file", file_.string()}, {"text", text}};
}

Json CaseEditor::add(const Json& request) const {
  const auto section = request.at("section").get<std::string>();
  if (keys_of(section).empty() || !is_repeatable(section))
    throw RefusedRequest(http_status::bad_request,
                         fmt::format("a case has no list of tables \"{}\"", section));
  return attempted([&]() -> Json {
    const NewTable made = with_new_table(request.at("text").get<std::string>(), shown_name(),
                                         section, request.value("name", std::string()));
    return {{"text", made.text}, {"path", made.path}};
  });
}

Json CaseEditor::remove(const Json& request) const {
  return attempted([&]() -> Json {
    return {{"text", without_table(request.at("text").get<std::string>(),
                                   request.at("path").get<std::string>())}};
  });
}

PilotFile CaseEditor::write_pilot(const Json& request) const {
  const fs::path known = file();
  const fs::path target =
      known.empty() ? folder_ / "pilot.toml"
                    : known.parent_path() / fmt::format("{}-pilot.toml", known.stem().string());
  if (fs::exists(target) && !case_text(target).starts_with(pilot_mark))
    throw RefusedRequest(http_status::conflict,
                         fmt::format("{} exists and is no pilot run. Rename it, as the pilot run "
                                     "needs this name.",
                                     target.string()));
  PilotFile pilot{target, {}};
  attempted([&]() -> Json {
    const PilotRun run =
        pilot_run(request.at("text").get<std::string>(), target.string(), threads_of({}));
    write_file(target, run.text);
    pilot.changes = run.changes;
    return {};
  });
  return pilot;
}

Json CaseEditor::from_template(const Json& request) const {
  const auto name = request.at("name").get<std::string>();
  const fs::path known = file();
  for (const EmbeddedText& entry : case_templates()) {
    if (entry.name != name) continue;
    return {{"text", entry.text},
            {"notes", write_meshes(entry.text, known.empty() ? folder_ : known.parent_path())}};
  }
  throw RefusedRequest(http_status::bad_request, fmt::format("there is no template \"{}\"", name));
}

}  // namespace kerf
