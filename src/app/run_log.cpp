// SPDX-License-Identifier: Apache-2.0
#include "app/run_log.hpp"

#include <fmt/format.h>
#include <spdlog/pattern_formatter.h>
#include <spdlog/sinks/basic_file_sink.h>

#include <nlohmann/json.hpp>

#include "core/error.hpp"

namespace kerf {
namespace {

// Writes the message as a JSON string.
class JsonMessage : public spdlog::custom_flag_formatter {
 public:
  void format(const spdlog::details::log_msg& line, const std::tm&,
              spdlog::memory_buf_t& to) override {
    const nlohmann::json message = std::string(line.payload.begin(), line.payload.end());
    const std::string text = message.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    to.append(text.data(), text.data() + text.size());
  }
  std::unique_ptr<spdlog::custom_flag_formatter> clone() const override {
    return std::make_unique<JsonMessage>();
  }
};

std::unique_ptr<spdlog::formatter> json_formatter() {
  auto formatter = std::make_unique<spdlog::pattern_formatter>();
  formatter->add_flag<JsonMessage>('*').set_pattern(
      R"({"time":"%Y-%m-%dT%H:%M:%S.%e%z","level":"%l","message":%*})");
  return formatter;
}

}  // namespace

const char* log_name(LogFormat format) {
  return format == LogFormat::json ? "log.jsonl" : "log.txt";
}

std::shared_ptr<spdlog::logger> open_log(const std::filesystem::path& folder, LogFormat format) {
  const std::filesystem::path path = folder / log_name(format);
  try {
    auto sink = std::make_shared<spdlog::sinks::basic_file_sink_mt>(path.string());
    auto log = std::make_shared<spdlog::logger>("run", sink);
    if (format == LogFormat::json) log->set_formatter(json_formatter());
    log->set_error_handler([](const std::string&) {});
    log->flush_on(spdlog::level::info);
    return log;
  } catch (const spdlog::spdlog_ex& error) {
    throw UserError(fmt::format("cannot write {}: {}. Check the disk and the folder's permissions.",
                                path.string(), error.what()),
                    exit_files);
  }
}

}  // namespace kerf
