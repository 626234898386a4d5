// SPDX-License-Identifier: Apache-2.0
// libFuzzer: whatever a study file, its case and its database hold, the study is read and its
// tables are made, or it is refused. The first byte of an input chooses what is changed.
#include <SQLiteCpp/SQLiteCpp.h>

#include "app/embedded.hpp"
#include "fuzz/fuzzed.hpp"
#include "fuzz/small_run.hpp"
#include "study/boundary.hpp"
#include "study/run_table.hpp"
#include "study/study_page.hpp"
#include "study/study_runs.hpp"
#include "support/temporary_folder.hpp"

namespace kerf::test {
namespace {

constexpr const char* study_file = R"(base = "small.toml"
metrics = ["kerf.depth"]
[vary]
"jet.jet.speed" = { from = "2 m/s", to = "10 m/s", count = 2 }
[design]
type = "grid"
[search]
find = "least"
key = "jet.jet.speed"
from = "1 m/s"
to = "8 m/s"
)";
constexpr std::array columns{"id",     "setting",   "repeat",  "refinement", "spacing",
                             "memory", "case_text", "state",   "attempts",   "metrics",
                             "error",  "made",      "started", "ended"};

class NoExecutor : public Executor {
 public:
  void run(const std::vector<Job>&, JobWatcher&) override {}
  int side_by_side() const override { return 1; }
};

std::vector<Trial> trials_of(const StudyPlan& plan) {
  std::vector<Trial> trials;
  if (!plan.design) return trials;
  for (const Setting& setting : settings_of(*plan.design, plan.axes)) {
    trials.push_back({setting, 0, plan.refinement});
    if (trials.size() > 20) break;
  }
  return trials;
}

struct MadeStudy {
  MadeStudy() {
    put(folder / "small.toml", small_case);
    put(folder / "study.toml", study_file);
    const StudyPlan plan = read_study(folder / "study.toml", case_templates());
    const CaseMaker maker(plan);
    {
      StudyDatabase made(folder / "study.db");
      for (const Trial& trial : trials_of(plan)) {
        const ResolvedCase resolved = maker.make(trial);
        made.add(resolved, trial);
        made.mark_started(resolved.id);
        made.mark_done(resolved.id, {{"cut_through", 1.0}, {"front_depth", 0.004}});
      }
    }
    SQLite::Database((folder / "study.db").string(), SQLite::OPEN_READWRITE)
        .exec("PRAGMA journal_mode = DELETE");
    database = content_of(folder / "study.db");
  }
  TemporaryFolder folder;
  std::string database;
};

MadeStudy& made_study() {
  static MadeStudy made;
  return made;
}

void make_tables() {
  const StudyPlan plan = read_study(made_study().folder / "study.toml", case_templates());
  StudyDatabase database(made_study().folder / "study.db");
  const CaseMaker maker(plan);
  NoExecutor executor;
  StudyRuns runs(made_study().folder.path(), maker, database, executor, {}, true);
  runs.run(trials_of(plan));
  StudyAnswers answers;
  answers.runs = database.runs();
  answers.boundary = cut_boundary(all_axes(plan), answers.runs);
  if (plan.model)
    answers.model =
        ReducedModel(*plan.model, model_data(*plan.model, plan.refinement, answers.runs));
  study_csv(plan, answers.runs);
  kerf::study_text(plan, answers.runs);
  study_hdf5(plan, answers.runs);
  study_page(plan, answers, StudyState::ended);
}

void change_row(std::string_view text, std::size_t column) {
  SQLite::Database database((made_study().folder / "study.db").string(), SQLite::OPEN_READWRITE);
  SQLite::Statement update(
      database, std::string("UPDATE runs SET ") + columns[column] + " = ? WHERE number = 1");
  update.bind(1, std::string(text));
  update.exec();
}

}  // namespace
}  // namespace kerf::test

// 0: the study, 1: the case, 2: the bytes of the database; then a column of one of its rows.
extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  using namespace kerf::test;
  std::vector<std::string> inputs{'\0' + std::string(study_file), '\1' + small_case,
                                  '\2' + made_study().database};
  for (const auto& study : kerf::study_templates())
    inputs.push_back('\0' + std::string(study.text));
  for (std::size_t n = 0; n < columns.size(); ++n)
    for (const char* text : {"1", "failed", R"({"jet.jet.speed": 2.0, "cut_through": 1.0})"})
      inputs.push_back(static_cast<char>(3 + n) + std::string(text));
  put_first_inputs(*argc, *argv, inputs);
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace kerf::test;
  if (size == 0) return 0;
  const std::size_t what = data[0] % (3 + columns.size());
  const std::string text = bytes_of(data + 1, size - 1);
  put(made_study().folder / "study.toml", what == 0 ? text : study_file);
  put(made_study().folder / "small.toml", what == 1 ? text : small_case);
  put(made_study().folder / "study.db", what == 2 ? text : made_study().database);
  for (const char* rest : {"study.db-wal", "study.db-shm", "study.db-journal"})
    std::filesystem::remove(made_study().folder / rest);
  if (what > 2) try {
      change_row(text, what - 3);
    } catch (const SQLite::Exception&) {
      return 0;  // the table does not take it
    }
  read_or_refuse(made_study().folder.path().string(), make_tables);
  return 0;
}
