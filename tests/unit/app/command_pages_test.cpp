// SPDX-License-Identifier: Apache-2.0
// The manual page and the completions of shells name what the command line has. Completions are
// tried in the shells themselves.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "app/commands.hpp"
#include "app/completion.hpp"
#include "app/exit_codes.hpp"
#include "app/manual_page.hpp"
#include "app/version_text.hpp"
#include "core/version.hpp"
#include "support/shell.hpp"
#include "support/temporary_folder.hpp"

namespace kerf {
namespace {

using testing::HasSubstr;

// A program with each kind of option.
struct SmallProgram {
  CLI::App program{"Cuts.", "kerf"};
  std::string mode = "fast", file;
  int count = 0;
  bool dry_run = false;

  SmallProgram() {
    CLI::App* command = program.add_subcommand("cut", "Cut a case, it's \"quick\"");
    command->add_option("CASE", file, "the case: a file")->required();
    command->add_option("-m,--mode", mode, "how [it] cuts")
        ->check(CLI::IsMember({"fast", "slow"}))
        ->capture_default_str();
    command->add_option("--count", count, ".hidden or a\\b");
    command->add_flag("--dry-run", dry_run, "only say so");
    add_materials_command(program);
  }
  std::vector<CommandWords> words() const { return command_words(program); }
};

void write(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file) << text;
}

TEST(CommandWords, SayWhatAnOptionTakes) {
  const auto words = SmallProgram().words();
  ASSERT_EQ(words.size(), 3u);
  EXPECT_EQ(words[1].name, "cut");
  ASSERT_EQ(words[1].arguments.size(), 1u);
  EXPECT_TRUE(words[1].arguments[0].required);
  std::vector<std::string> names;
  for (const OptionWords& option : words[1].options) names.push_back(option.names.front());
  EXPECT_EQ(names, (std::vector<std::string>{"--help", "--mode", "--count", "--dry-run"}));
  EXPECT_EQ(words[1].options[1].choices, (std::vector<std::string>{"fast", "slow"}));
  EXPECT_EQ(words[1].options[1].standard, "fast");
  EXPECT_EQ(words[1].options[2].value, "INT");
  EXPECT_EQ(words[1].options[3].value, "");
  EXPECT_THAT(words[2].arguments[0].choices, testing::Contains("rubber"));
}

// Lines that begin with a dot are commands of troff, and backslashes begin its escapes.
TEST(ManualPage, EscapesWhatTroffWouldTakeForACommand) {
  const std::string page = manual_page(SmallProgram().words());
  EXPECT_THAT(page, HasSubstr("\\fB\\-\\-mode\\fR, \\fB\\-m\\fR fast|slow\n"));
  EXPECT_THAT(page, HasSubstr("\\fB\\-\\-count\\fR \\fIINT\\fR\n\\&.hidden or a\\eb."));
  EXPECT_THAT(page, HasSubstr("how [it] cuts. Default: fast."));
  EXPECT_THAT(page, HasSubstr("\\fBkerf cut\\fR [\\fIoptions\\fR] \\fICASE\\fR\n"));
}

TEST(ManualPage, HasTheExitCodesOfTheDocs) {
  std::stringstream docs;
  docs << std::ifstream(std::string(KERF_SOURCE_DIR) + "/docs/results.md").rdbuf();
  const std::string page = manual_page(SmallProgram().words());
  for (const ExitCode& entry : exit_codes) {
    EXPECT_THAT(docs.str(), HasSubstr(fmt::format("| {} | {} |", entry.listed(), entry.meaning)));
    EXPECT_THAT(page, HasSubstr(fmt::format(".TP\n{}\n", entry.listed())));
  }
}

class Completion : public testing::Test {
 protected:
  // Returns what bash offers for the last of the words.
  std::string bash(const std::string& words) {
    const auto script = (folder_ / "kerf.bash").string();
    write(script, bash_completion(SmallProgram().words()));
    write(folder_ / "try.bash",
          fmt::format("source {}\nCOMP_WORDS=({})\nCOMP_CWORD=$((${{#COMP_WORDS[@]}} - 1))\n_kerf\n"
                      "echo \"${{COMPREPLY[*]}}\"\n",
                      script, words));
    return test::printed_by("bash " + (folder_ / "try.bash").string());
  }
  test::TemporaryFolder folder_;
};

TEST_F(Completion, BashOffersCommandsOptionsAndValues) {
  EXPECT_EQ(bash("kerf c"), "cut\n");
  EXPECT_EQ(bash("kerf cut --"), "--help --mode --count --dry-run\n");
  EXPECT_EQ(bash("kerf cut --mode s"), "slow\n");
  EXPECT_EQ(bash("kerf cut -m ''"), "fast slow\n");
  EXPECT_EQ(bash("kerf cut --count 1"), "\n");  // and so files
  EXPECT_EQ(bash("kerf cut my"), "\n");
  EXPECT_EQ(bash("kerf materials gra"), "granite\n");
  EXPECT_EQ(bash("kerf unknown x"), "\n");
}

TEST_F(Completion, ZshAndFishReadTheirScripts) {
  const auto words = SmallProgram().words();
  write(folder_ / "_kerf", zsh_completion(words));
  EXPECT_THAT(zsh_completion(words), HasSubstr("]:value: '"));  // no file for --count
  write(folder_ / "kerf.fish", fish_completion(words));
  if (!test::is_installed("zsh") || !test::is_installed("fish"))
    GTEST_SKIP() << "zsh or fish is not installed";
  EXPECT_EQ(test::printed_by("zsh -n " + (folder_ / "_kerf").string() + " 2>&1"), "");
  const std::string source = "source " + (folder_ / "kerf.fish").string() + "; complete -C ";
  EXPECT_THAT(test::printed_by("fish -c \"" + source + "'kerf cut --mode s'\" 2>&1"),
              testing::StartsWith("slow\t"));
  EXPECT_THAT(test::printed_by("fish -c \"" + source + "'kerf cut --dry'\" 2>&1"),
              HasSubstr("--dry-run"));
  EXPECT_EQ(test::printed_by("fish -c \"" + source + "'kerf cut --count '\" 2>&1"), "");
}

TEST(VersionText, NamesCommitCompilerAndInstructionSet) {
  const std::string text = version_text();
  EXPECT_THAT(text, testing::StartsWith(fmt::format("kerf {}\ncommit ", program_version)));
  EXPECT_THAT(text, HasSubstr("\ncompiler  " + compiler_name()));
  EXPECT_THAT(text, testing::ContainsRegex("\nSIMD +(baseline|avx2|avx512)\n"));
}

}  // namespace
}  // namespace kerf
