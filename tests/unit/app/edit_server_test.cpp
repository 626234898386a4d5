// SPDX-License-Identifier: Apache-2.0
// The server of kerf view --edit with the requests of its page. A script takes the place of kerf
// run.
#include "app/edit_server.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <httplib.h>

#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "input/read.hpp"
#include "model/case.hpp"
#include "output/files.hpp"
#include "report/viewer_files.hpp"
#include "support/fake_run.hpp"
#include "support/temporary_folder.hpp"

namespace kerf {
namespace {

namespace fs = std::filesystem;
using EditJson = nlohmann::json;

constexpr int ok = 200, bad_request = 400, forbidden_by_edit = 403, conflict = 409, too_long = 413;

class Edit : public testing::Test {
 protected:
  void SetUp() override {
    if (viewer_text("edit_script").empty()) GTEST_SKIP() << "the page was not built";
    write_file(file_, test::fake_case_text);
    open({file_, folder_ / "", program_});
  }
  void TearDown() override { close(); }

  void open(const EditServer::Settings& settings) {
    close();
    server_ = std::make_unique<EditServer>(settings);
    port_ = server_->bind(0);
    client_ = std::make_unique<httplib::Client>("127.0.0.1", port_);
    thread_ = std::thread([this] { server_->serve(); });
  }
  void close() {
    if (!server_) return;
    server_->stop();
    thread_.join();
    server_.reset();
  }
  // Makes the program that stands in for Kerf.
  void make_program(const std::string& lines) {
    write_file(program_,
               "#!/bin/sh\necho \"$@\" > '" + (folder_ / "words").string() + "'\n" + lines);
    fs::permissions(program_, fs::perms::owner_all);
  }
  httplib::Result get(const std::string& address) {
    return client_->Get(server_->path() + address);
  }
  httplib::Result send(const std::string& address, const EditJson& body, httplib::Headers headers) {
    return client_->Post(server_->path() + address, headers, body.dump(), "application/json");
  }
  httplib::Result post(const std::string& address, const EditJson& body) {
    return send(address, body, {{"Origin", fmt::format("http://127.0.0.1:{}", port_)}});
  }
  EditJson answer(const std::string& address, const EditJson& body) {
    const auto result = post(address, body);
    EXPECT_EQ(result->status, ok) << result->body;
    return EditJson::parse(result->body);
  }
  EditJson state_other_than(const std::string& state) {
    EditJson run;
    for (int n = 0; n < 200; ++n) {
      run = EditJson::parse(get("run")->body);
      if (run.at("state") != state) break;
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return run;
  }

  test::TemporaryFolder folder_;
  fs::path file_ = folder_ / "my.toml", program_ = folder_ / "fake_kerf";
  int port_ = 0;
  std::unique_ptr<EditServer> server_;
  std::unique_ptr<httplib::Client> client_;
  std::thread thread_;
};

EditJson value_at(const EditJson& answer, const std::string& path) {
  for (const EditJson& table : answer.at("tables"))
    for (const EditJson& key : table.at("keys"))
      if (key.at("path") == path) return key.at("value");
  return {};
}

TEST_F(Edit, ServesThePageTheSchemaAndTheCase) {
  EXPECT_THAT(get("")->body, testing::HasSubstr("id=\"kerf-edit\""));
  const auto schema = EditJson::parse(get("schema")->body);
  bool has_pressure = false;
  for (const auto& section : schema.at("sections"))
    for (const auto& key : section.at("keys"))
      has_pressure |= section.at("name") == "machine" && key.at("name") == "pressure" &&
                      key.at("unit") == "Pa" && key.at("required") == true;
  EXPECT_TRUE(has_pressure);
  EXPECT_GT(schema.at("materials").size(), 5u);
  const auto read = EditJson::parse(get("case")->body);
  EXPECT_EQ(read.at("text"), test::fake_case_text);
  EXPECT_EQ(read.at("file"), file_.string());
}

// A page of another site, or of another server of this machine, must not change a file.
TEST_F(Edit, OnlyItsOwnPageMayAct) {
  const EditJson body = {{"text", "x"}, {"before", test::fake_case_text}};
  const std::string own = fmt::format("http://127.0.0.1:{}", port_);
  EXPECT_EQ(send("save", body, {})->status, forbidden_by_edit);
  EXPECT_EQ(send("save", body, {{"Origin", "http://example.org"}})->status, forbidden_by_edit);
  EXPECT_EQ(send("save", body, {{"Origin", "http://127.0.0.1:1"}})->status, forbidden_by_edit);
  const auto as_form =
      client_->Post(server_->path() + "save", {{"Origin", own}}, body.dump(), "text/plain");
  EXPECT_EQ(as_form->status, forbidden_by_edit);
  EXPECT_EQ(client_->Post("/save", {{"Origin", own}}, body.dump(), "application/json")->status,
            404);
  EXPECT_EQ(read_file(file_), test::fake_case_text);
}

TEST_F(Edit, RefusesWhatIsTooLongOrNoRequest) {
  EXPECT_EQ(post("check", {{"text", std::string(5 << 20, ' ')}})->status, too_long);
  EXPECT_EQ(post("check", {{"words", 1}})->status, bad_request);
  EXPECT_EQ(
      post("check", {{"text", ""},
                     {"set", {{{"section", "machine"}, {"path", "machine.no"}, {"value", "1"}}}}})
          ->status,
      bad_request);
}

TEST_F(Edit, ChecksAChangedValue) {
  const auto before = answer("check", {{"text", test::fake_case_text}});
  const EditJson change = {{"section", "jet"}, {"path", "jet[1].spacing"}, {"value", "0.5 mm"}};
  const auto after = answer("check", {{"text", test::fake_case_text}, {"set", {change}}});
  EXPECT_EQ(value_at(before, "jet[1].spacing"), "1 mm");
  EXPECT_EQ(value_at(after, "jet[1].spacing"), "0.5 mm");
  EXPECT_TRUE(after.at("problems").empty());
  const auto particles = [](const EditJson& of) {
    return of.at("check").at("cost").at("final_particles").get<double>();
  };
  EXPECT_GT(particles(after), particles(before));
  EXPECT_THAT(after.at("text").get<std::string>(), testing::HasSubstr("spacing = \"0.5 mm\""));
  EXPECT_THAT(after.at("drawings").at(0).at("svg").get<std::string>(),
              testing::HasSubstr("block (tofu)"));
  EXPECT_EQ(after.at("facts").at(0).at("name"), "Run time");
}

TEST_F(Edit, NamesTheKeyOfAWrongUnit) {
  const EditJson change = {{"section", "jet"}, {"path", "jet[1].speed"}, {"value", "5 mm"}};
  const auto wrong = answer("check", {{"text", test::fake_case_text}, {"set", {change}}});
  ASSERT_EQ(wrong.at("problems").size(), 1u);
  const auto& problem = wrong.at("problems").at(0);
  EXPECT_EQ(problem.at("path"), "jet[1].speed");
  EXPECT_EQ(problem.at("line"), 19);
  EXPECT_THAT(problem.at("allowed").get<std::string>(), testing::HasSubstr("m/s"));
  EXPECT_TRUE(wrong.at("check").is_null());
  EXPECT_EQ(value_at(wrong, "jet[1].speed"), "5 mm");
}

TEST_F(Edit, TextThatIsNoTomlHasALineAndNoForm) {
  const auto wrong = answer("check", {{"text", "title = \"a\"\nx = \n"}});
  EXPECT_TRUE(wrong.at("tables").is_null());
  EXPECT_EQ(wrong.at("problems").at(0).at("line"), 2);
}

TEST_F(Edit, AddsATableAndRemovesIt) {
  const auto added = answer("add", {{"text", test::fake_case_text}, {"section", "probe"}});
  EXPECT_EQ(added.at("path"), "probe[2]");
  const auto checked = answer("check", {{"text", added.at("text")}});
  EXPECT_TRUE(checked.at("problems").empty());
  EXPECT_EQ(value_at(checked, "probe[2].name"), "probe-2");
  const auto removed = answer("remove", {{"text", added.at("text")}, {"path", "probe[2]"}});
  EXPECT_EQ(removed.at("text"), test::fake_case_text);
  EXPECT_EQ(post("add", {{"text", ""}, {"section", "time"}})->status, bad_request);
  EXPECT_EQ(post("add", {{"text", ""}, {"section", "nothing"}})->status, bad_request);
  EXPECT_EQ(post("remove", {{"text", ""}, {"path", "body[1]"}})->status, conflict);
}

// The form offers a place for each table that a case may hold several of.
TEST_F(Edit, OffersTablesToAdd) {
  std::vector<std::string> offered;
  const auto checked = answer("check", {{"text", test::fake_case_text}});
  for (const auto& table : checked.at("tables"))
    if (table.value("adds", false)) offered.push_back(table.at("section"));
  EXPECT_THAT(offered, testing::IsSupersetOf({"materials", "body", "jet", "probe"}));
}

TEST_F(Edit, SavesUnlessTheFileWasChanged) {
  const std::string text = test::fake_case_text + "# more\n";
  EXPECT_EQ(answer("save", {{"text", text}, {"before", test::fake_case_text}}).at("text"), text);
  EXPECT_EQ(read_file(file_), text);
  EXPECT_EQ(post("save", {{"text", "old"}, {"before", test::fake_case_text}})->status, conflict);
  EXPECT_EQ(read_file(file_), text);
}

TEST_F(Edit, ANewCaseGetsItsNameOnce) {
  open({"", folder_ / "", program_});
  EXPECT_TRUE(EditJson::parse(get("case")->body).at("text").is_null());
  for (const char* name : {"", "new", "../new.toml", ".toml", "/tmp/new.toml"})
    EXPECT_EQ(post("save", {{"text", "a"}, {"before", nullptr}, {"file", name}})->status,
              bad_request)
        << name;
  EXPECT_EQ(post("save", {{"text", "a"}, {"before", nullptr}, {"file", "my.toml"}})->status,
            conflict);
  EXPECT_EQ(read_file(file_), test::fake_case_text);
  answer("save", {{"text", "a"}, {"before", nullptr}, {"file", "new.toml"}});
  EXPECT_EQ(read_file(folder_ / "new.toml"), "a");
}

TEST_F(Edit, ATemplateBringsItsMesh) {
  EXPECT_EQ(post("template", {{"name", "nothing"}})->status, bad_request);
  const auto text = answer("template", {{"name", "stl-part"}}).at("text");
  EXPECT_TRUE(fs::exists(folder_ / "lug.stl"));
  EXPECT_TRUE(answer("check", {{"text", text}}).at("problems").empty());
}

TEST_F(Edit, RunsStopsAndNamesTheFolder) {
  make_program("trap 'exit 143' TERM\nwhile :; do sleep 0.02; done\n");
  const auto run = answer("run", {{"folder", (folder_ / "out").string()}});
  EXPECT_EQ(run.at("state"), "running");
  EXPECT_EQ(post("run", EditJson::object())->status, conflict);
  while (!fs::exists(folder_ / "words")) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  answer("stop", EditJson::object());
  EXPECT_EQ(state_other_than("running").at("state"), "stopped");
  EXPECT_EQ(read_file(folder_ / "words"),
            fmt::format("run {} --out {}\n", file_.string(), (folder_ / "out").string()));
}

TEST_F(Edit, TellsWhyARunFailed) {
  make_program("echo 'there is a run already'\nexit 4\n");
  answer("run", {{"existing", "replace"}, {"folder", (folder_ / "out").string()}});
  const auto run = state_other_than("running");
  EXPECT_EQ(run.at("state"), "failed");
  EXPECT_THAT(run.at("output").get<std::string>(), testing::HasSubstr("a run already"));
  EXPECT_THAT(read_file(folder_ / "words"), testing::HasSubstr("--force"));
  EXPECT_EQ(run.at("view"), "");
}

TEST_F(Edit, ShowsTheRunAsKerfViewDoes) {
  make_program("exit 0\n");
  test::run_fake(test::fake_case(), folder_ / "out");
  answer("run", {{"existing", "resume"}, {"folder", (folder_ / "out").string()}});
  const auto run = state_other_than("running");
  EXPECT_EQ(run.at("state"), "completed");
  EXPECT_EQ(run.at("view"), "view/1/");
  EXPECT_THAT(get("view/1/")->body, testing::HasSubstr("class=\"verdict"));
  EXPECT_EQ(EditJson::parse(get("view/1/run.json")->body).at("live"), false);
  EXPECT_EQ(get("view/1/frame/0")->status, ok);
  EXPECT_EQ(get("view/2/")->status, 404);
}

// A pilot run is coarser and shorter, and leaves the case file as it is.
TEST_F(Edit, APilotRunIsCoarserAndShorter) {
  make_program("exit 0\n");
  std::string text = test::fake_case_text;
  const auto end = text.find("end = \"");
  text.replace(end, text.find('\n', end) - end, "end = \"100 s\"");
  const std::string spacing = "spacing = \"1 mm\"";
  text.replace(text.find(spacing), spacing.size(), "spacing = \"0.25 mm\"");
  const auto run = answer("pilot", {{"text", text}});
  EXPECT_EQ(run.at("results"), "out/my-pilot");
  EXPECT_GE(run.at("changes").size(), 1u);
  EXPECT_EQ(state_other_than("running").at("state"), "completed");
  EXPECT_EQ(read_file(file_), test::fake_case_text);
  EXPECT_THAT(read_file(folder_ / "words"), testing::HasSubstr("my-pilot.toml --out out/my-pilot"));
  const Case full = parse_case(text, "full"), pilot = read_case(folder_ / "my-pilot.toml");
  EXPECT_LT(pilot.time.end, full.time.end);
  EXPECT_GT(pilot.jets.back().spacing, full.jets.back().spacing);
  const double arrival = pilot.jets.back().standoff / pilot.jets.back().speed;
  EXPECT_GT(pilot.time.end, arrival);
}

TEST_F(Edit, APilotRunNeedsAValidCaseAndItsName) {
  make_program("exit 0\n");
  EXPECT_EQ(post("pilot", {{"text", "title = \"a\"\n"}})->status, conflict);
  write_file(folder_ / "my-pilot.toml", "# my own\n");
  EXPECT_EQ(post("pilot", {{"text", test::fake_case_text}})->status, conflict);
  EXPECT_EQ(read_file(folder_ / "my-pilot.toml"), "# my own\n");
}

TEST_F(Edit, ARunNeedsASavedCase) {
  open({"", folder_ / "", program_});
  EXPECT_EQ(post("run", EditJson::object())->status, conflict);
}

}  // namespace
}  // namespace kerf
