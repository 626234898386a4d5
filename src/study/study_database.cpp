// SPDX-License-Identifier: Apache-2.0
#include "study/study_database.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sqlite3.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "core/error.hpp"
#include "study/setting_json.hpp"

namespace kerf {

namespace {

using Json = nlohmann::ordered_json;

constexpr int version = 1;       // of the tables below
constexpr int patience = 10000;  // ms, to wait for a process that holds the file

constexpr const char* tables = R"(
CREATE TABLE IF NOT EXISTS runs (
  number INTEGER PRIMARY KEY AUTOINCREMENT,
  id TEXT NOT NULL UNIQUE,
  setting TEXT NOT NULL,
  repeat INTEGER NOT NULL,
  refinement REAL NOT NULL,
  spacing REAL NOT NULL,
  memory REAL NOT NULL,
  case_text TEXT NOT NULL,
  state TEXT NOT NULL,
  attempts INTEGER NOT NULL DEFAULT 0,
  metrics TEXT NOT NULL DEFAULT '{}',
  error TEXT NOT NULL DEFAULT '',
  made TEXT NOT NULL,
  started TEXT NOT NULL DEFAULT '',
  ended TEXT NOT NULL DEFAULT ''
);
CREATE TABLE IF NOT EXISTS notes (name TEXT PRIMARY KEY, text TEXT NOT NULL);
)";

constexpr const char* columns =
    "id, setting, repeat, refinement, spacing, memory, case_text, state, attempts, metrics, error, "
    "made, started, ended";

std::string now() {
  return fmt::format(
      "{:%Y-%m-%dT%H:%M:%SZ}",
      fmt::gmtime(std::chrono::system_clock::to_time_t(std::chrono::system_clock::now())));
}

std::string word_of_state(RunState state) {
  return std::string(run_state_words[static_cast<std::size_t>(state)]);
}

RunState state_of(const std::string& word, const std::string& file) {
  for (std::size_t i = 0; i < run_state_words.size(); ++i)
    if (run_state_words[i] == word) return static_cast<RunState>(i);
  throw UserError(fmt::format("{} holds a run of the unknown state \"{}\". It was written by "
                              "another version of Kerf: choose another folder with --out.",
                              file, word),
                  exit_files);
}

// Returns the text with a mark in place of bytes that are not UTF-8, which neither JSON nor pages
// hold: the output of a program may have been cut within a character.
std::string valid_text(const std::string& text) {
  const std::string written = Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
  return Json::parse(written).get<std::string>();
}

RunRow row_of(SQLite::Statement& query, const std::string& file) {
  RunRow row;
  int column = 0;
  const auto text = [&] { return valid_text(query.getColumn(column++).getString()); };
  const auto number = [&] { return query.getColumn(column++).getDouble(); };
  row.id = text();
  row.trial.setting = setting_of(Json::parse(text()));
  row.trial.repeat = static_cast<int>(number());
  row.trial.refinement = number();
  row.spacing = number();
  row.memory = number();
  row.case_text = text();
  row.state = state_of(text(), file);
  row.attempts = static_cast<int>(number());
  const Json metrics = Json::parse(text());
  for (const auto& [name, value] : metrics.items()) row.metrics[name] = value.get<double>();
  row.error = text();
  row.made = text();
  row.started = text();
  row.ended = text();
  return row;
}

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& why) {
  throw UserError(fmt::format("cannot use {}: {}. Choose another folder with --out, or free space "
                              "on the disk.",
                              file.string(), why),
                  exit_files);
}

// Returns what `read` reads; a file that is not as this program writes it ends the command.
template <class Read>
auto read_from(const SQLite::Database& database, const Read& read) -> decltype(read()) {
  try {
    return read();
  } catch (const SQLite::Exception& error) {
    fail(database.getFilename(), error.what());
  } catch (const Json::exception& error) {
    throw UserError(
        fmt::format("{} is damaged: a run in it has values that are no JSON of this program ({}). "
                    "Restore the file from a copy, or choose another folder with --out.",
                    database.getFilename(), error.what()),
        exit_files);
  }
}

int version_of(SQLite::Database& database) {
  return database.execAndGet("PRAGMA user_version").getInt();
}

void set_up(SQLite::Database& database) {
  // With this mode a writer does not block readers.
  database.exec("PRAGMA journal_mode = WAL");
  SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
  if (version_of(database) != 0) return;  // another process created them
  database.exec(tables);
  database.exec(fmt::format("PRAGMA user_version = {}", version));
  transaction.commit();
}

// Creates the tables if they do not exist. When two processes do so at the same time, SQLite makes
// one wait or refuses it to avoid a deadlock; the refused one tries again.
void open_or_set_up(SQLite::Database& database) {
  const auto start = std::chrono::steady_clock::now();
  while (true) {
    try {
      if (version_of(database) == 0) set_up(database);
      return;
    } catch (const SQLite::Exception& error) {
      const bool is_busy = error.getErrorCode() == SQLITE_BUSY;
      const auto waited = std::chrono::steady_clock::now() - start;
      if (!is_busy || waited > std::chrono::milliseconds(patience)) throw;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }
}

}  // namespace

StudyDatabase::StudyDatabase(const std::filesystem::path& file) try
    : database_(std::make_unique<SQLite::Database>(
          file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE, patience)) {
  open_or_set_up(*database_);
  if (const int found = version_of(*database_); found != version)
    fail(file,
         fmt::format("it has version {} of the tables and this program reads {}", found, version));
  database_->exec("PRAGMA synchronous = FULL");  // changes survive a loss of power
} catch (const SQLite::Exception& error) {
  fail(file, error.what());
}

StudyDatabase::~StudyDatabase() = default;

void StudyDatabase::update(const std::string& sql, const std::vector<std::string>& values) const {
  try {
    SQLite::Statement statement(*database_, sql);
    for (std::size_t i = 0; i < values.size(); ++i)
      statement.bind(static_cast<int>(i + 1), values[i]);
    statement.exec();
  } catch (const SQLite::Exception& error) {
    fail(database_->getFilename(), error.what());
  }
}

void StudyDatabase::add(const ResolvedCase& resolved, const Trial& trial) {
  update(
      "INSERT OR IGNORE INTO runs (id, setting, repeat, refinement, spacing, memory, case_text, "
      "state, made) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)",
      {resolved.id, setting_json(trial.setting).dump(), std::to_string(trial.repeat),
       fmt::format("{}", trial.refinement), fmt::format("{}", resolved.spacing),
       fmt::format("{}", resolved.memory), resolved.text, word_of_state(RunState::waiting), now()});
  // An existing run may have been requested with other keys: it serves both.
  Setting setting = find(resolved.id)->trial.setting;
  for (const auto& [key, value] : trial.setting.numbers) setting.numbers[key] = value;
  for (const auto& [key, value] : trial.setting.words) setting.words[key] = value;
  update("UPDATE runs SET setting = ? WHERE id = ?", {setting_json(setting).dump(), resolved.id});
}

std::optional<RunRow> StudyDatabase::find(const std::string& id) const {
  return read_from(*database_, [&]() -> std::optional<RunRow> {
    SQLite::Statement query(*database_, fmt::format("SELECT {} FROM runs WHERE id = ?", columns));
    query.bind(1, id);
    if (!query.executeStep()) return std::nullopt;
    return row_of(query, database_->getFilename());
  });
}

std::vector<RunRow> StudyDatabase::runs() const {
  return read_from(*database_, [&] {
    SQLite::Statement query(*database_,
                            fmt::format("SELECT {} FROM runs ORDER BY number", columns));
    std::vector<RunRow> rows;
    while (query.executeStep()) rows.push_back(row_of(query, database_->getFilename()));
    return rows;
  });
}

void StudyDatabase::mark_started(const std::string& id) {
  update("UPDATE runs SET state = ?, attempts = attempts + 1, started = ?, error = '' WHERE id = ?",
         {word_of_state(RunState::running), now(), id});
}

void StudyDatabase::mark_done(const std::string& id, const Metrics& metrics) {
  Json json = Json::object();
  for (const auto& [name, value] : metrics) json[name] = value;
  update("UPDATE runs SET state = ?, metrics = ?, ended = ?, error = '' WHERE id = ?",
         {word_of_state(RunState::done), json.dump(), now(), id});
}

void StudyDatabase::mark_failed(const std::string& id, const std::string& error) {
  update("UPDATE runs SET state = ?, error = ?, ended = ? WHERE id = ?",
         {word_of_state(RunState::failed), error, now(), id});
}

void StudyDatabase::mark_waiting(const std::string& id) {
  update("UPDATE runs SET state = ?, error = '' WHERE id = ?",
         {word_of_state(RunState::waiting), id});
}

void StudyDatabase::remember(const std::string& name, const std::string& text) {
  update(
      "INSERT INTO notes (name, text) VALUES (?, ?) ON CONFLICT (name) DO UPDATE SET text = "
      "excluded.text",
      {name, text});
}

std::string StudyDatabase::recall(const std::string& name) const {
  return read_from(*database_, [&] {
    SQLite::Statement query(*database_, "SELECT text FROM notes WHERE name = ?");
    query.bind(1, name);
    return query.executeStep() ? query.getColumn(0).getString() : std::string();
  });
}

void StudyDatabase::forget(const std::string& name) {
  update("DELETE FROM notes WHERE name = ?", {name});
}

}  // namespace kerf
