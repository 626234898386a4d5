// SPDX-License-Identifier: Apache-2.0
// The log of a run: what it wrote and told, with the time of each line.
#pragma once

#include <spdlog/logger.h>

#include <filesystem>
#include <memory>

namespace kerf {

enum class LogFormat {
  text,  // log.txt, one sentence a line
  json,  // log.jsonl, one object a line with the keys time (ISO 8601), level and message
};

// Returns the name of the file of a format.
const char* log_name(LogFormat format);

// Opens the log of a folder and appends to it. Errors of later lines are ignored, so that they hide
// no message of the run. Throws UserError (exit_files) where the file cannot be opened.
std::shared_ptr<spdlog::logger> open_log(const std::filesystem::path& folder, LogFormat format);

}  // namespace kerf
