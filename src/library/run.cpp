// SPDX-License-Identifier: Apache-2.0
#include "library/run.hpp"

#include "analysis/derived.hpp"
#include "app/command_line.hpp"
#include "app/cost_advice.hpp"
#include "app/later_end.hpp"
#include "app/run_loop.hpp"
#include "core/error.hpp"
#include "input/read.hpp"
#include "input/write_used.hpp"
#include "report/picture.hpp"

namespace kerf {
namespace {

RunLoopSettings loop_settings(const Case& description, const std::filesystem::path& case_file,
                              const RunOptions& options) {
  const MachineOptions machine{options.threads, options.device};
  take_machine(machine);
  const std::string file = case_file.string(), text = write_used(description);
  Case checked = parse_case(text, file);
  if (!options.ignores_memory && options.device == Device::cpu)
    refuse_beyond_memory({text, file, checked, derive(checked), {}}, threads_of(machine),
                         options.ignore_memory_words);
  RunLoopSettings settings = settings_of_case(std::move(checked), file, options.folder);
  settings.existing = existing_of(options.resume, options.replace);
  settings.quiet = !options.shows_progress;
  settings.catches_signals = false;  // they belong to the program that drives the run
  settings.threads = threads_of(machine);
  settings.device = device_name();
  settings.resume_command = options.resume_words;
  continue_to_later_end(settings);
  return settings;
}

}  // namespace

Run::Run(const Case& description, const std::filesystem::path& case_file, const RunOptions& options)
    : loop_(std::make_unique<RunLoop>(loop_settings(description, case_file, options),
                                      make_simulation)),
      folder_(loop_->settings().folder) {
  if (!loop_->start()) loop_.reset();
}
Run::~Run() = default;
Run::Run(Run&&) noexcept = default;
Run& Run::operator=(Run&&) noexcept = default;

RunLoop& Run::loop() const {
  if (loop_) return *loop_;
  throw UserError("the run in " + folder_.string() +
                  " has finished. Read its result.json, or begin a run with other options (resume "
                  "continues a run that was stopped, replace runs it again).");
}

void Run::step(std::uint64_t count) {
  const Simulation& now = loop().simulation();
  advance([&now, last = now.step() + count] { return now.step() >= last; });
}
void Run::until(double time) {
  const Simulation& now = loop().simulation();
  advance([&now, time] { return now.time() >= time; });
}
void Run::advance(const std::function<bool()>& enough) {
  loop().advance(enough);
}

bool Run::has_finished() const {
  return loop_ == nullptr;
}
bool Run::is_over() const {
  return !loop_ || loop_->is_over();
}
void Run::save() {
  loop().save();
}
void Run::finish() {
  advance([] { return false; });
  loop().finish();
  loop_.reset();
}

const std::filesystem::path& Run::folder() const {
  return folder_;
}
const Case& Run::description() const {
  return loop().settings().description;
}
const Simulation& Run::simulation() const {
  return loop().simulation();
}
const Frame& Run::frame() {
  return loop().frame();
}
std::string Run::result() {
  return loop().result().dump();
}
std::string Run::picture(double scale) {
  return draw_picture(frame(), description(), scale);
}

}  // namespace kerf
